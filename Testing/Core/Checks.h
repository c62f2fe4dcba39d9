// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Checks_h
#define Checks_h

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <sstream>
#include <string>

#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define HAS_SANITIZER
#endif
#endif

/// A test that tries many cases tries one in so many: a sanitizer slows it down a hundredfold.
#ifdef HAS_SANITIZER
constexpr int Thinning = 10;
#else
constexpr int Thinning = 1;
#endif

/// Steps of the grid of points over each triangle at which distances are compared: no power of two
/// divides an edge into them.
constexpr int GridSteps = Thinning > 1 ? 3 : 7;

/// The larger of two errors; NaN is the largest.
inline double Larger(double a, double b)
{
  return std::isnan(a) || b <= a ? a : b;
}

/// Collects the properties that a test program checks, one line each.
class Checks
{
public:
  /// The property holds if \a error is at most \a bound; NaN fails.
  void Error(const std::string& property, double error, double bound)
  {
    std::ostringstream detail;
    detail << "error " << error << ", bound " << bound;
    this->Report(property + ": " + detail.str(), error <= bound);
  }

  void True(const std::string& property, bool holds) { this->Report(property, holds); }

  /// The property holds if \a body throws an Exception.
  template <typename Exception, typename Body>
  void Throws(const std::string& property, const Body& body)
  {
    try
    {
      body();
      this->Report(property + ": nothing was thrown", false);
    }
    catch (const Exception&)
    {
      this->Report(property, true);
    }
  }

  /// Exit code of the test.
  int Result() const { return this->Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE; }

private:
  void Report(const std::string& property, bool holds)
  {
    this->Failures += !holds;
    std::cout << (holds ? "ok    " : "FAILS ") << property << std::endl;
  }

  int Failures = 0;
};

#endif
