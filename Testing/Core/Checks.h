// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Checks_h
#define Checks_h

#include <cmath>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>

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

/// Whether values of this type can be written to a stream.
template <typename Value, typename = void>
struct IsWritten : std::false_type
{
};
template <typename Value>
struct IsWritten<Value,
  std::void_t<decltype(std::declval<std::ostream&>() << std::declval<const Value&>())>>
  : std::true_type
{
};

template <typename Value>
void Write(std::ostream& stream, const Value& value)
{
  if constexpr (std::is_enum_v<Value>)
  {
    stream << static_cast<long long>(value);
  }
  else if constexpr (std::is_integral_v<Value>)
  {
    stream << +value; // a char as a number
  }
  else if constexpr (IsWritten<Value>::value)
  {
    stream << value;
  }
  else
  {
    stream << '{';
    for (const auto& element : value)
    {
      Write(stream << ' ', element);
    }
    stream << " }";
  }
}

/// A number, text, matrix, or list as text, which is cut off where it is long.
template <typename Value>
std::string AsText(const Value& value)
{
  constexpr std::size_t longest = 200;
  std::ostringstream stream;
  stream.precision(10);
  Write(stream, value);
  const std::string text = stream.str();
  return text.size() <= longest ? text : text.substr(0, longest) + " ...";
}

/// Collects the properties that a test program checks, one line each: the property, the values that
/// were compared and, where it fails, the line of the source that checks it.
class Checks
{
public:
  /// The property holds if \a error is at most \a bound; NaN fails.
  void Error(const std::string& property, double error, double bound, int line = __builtin_LINE())
  {
    std::ostringstream detail;
    detail << ": error " << error << ", bound " << bound;
    this->Report(property + detail.str(), error <= bound, line);
  }

  void True(const std::string& property, bool holds, int line = __builtin_LINE())
  {
    this->Report(property, holds, line);
  }

  /// The property holds if \a value compares so with \a other.
  template <typename A, typename B>
  void Equal(
    const std::string& property, const A& value, const B& other, int line = __builtin_LINE())
  {
    this->Compare(property, value, " == ", other, std::equal_to<>(), line);
  }

  template <typename A, typename B>
  void Different(
    const std::string& property, const A& value, const B& other, int line = __builtin_LINE())
  {
    this->Compare(property, value, " != ", other, std::not_equal_to<>(), line);
  }

  template <typename A, typename B>
  void Less(
    const std::string& property, const A& value, const B& other, int line = __builtin_LINE())
  {
    this->Compare(property, value, " < ", other, std::less<>(), line);
  }

  template <typename A, typename B>
  void AtMost(
    const std::string& property, const A& value, const B& other, int line = __builtin_LINE())
  {
    this->Compare(property, value, " <= ", other, std::less_equal<>(), line);
  }

  template <typename A, typename B>
  void Greater(
    const std::string& property, const A& value, const B& other, int line = __builtin_LINE())
  {
    this->Compare(property, value, " > ", other, std::greater<>(), line);
  }

  template <typename A, typename B>
  void AtLeast(
    const std::string& property, const A& value, const B& other, int line = __builtin_LINE())
  {
    this->Compare(property, value, " >= ", other, std::greater_equal<>(), line);
  }

  /// The property holds if \a text contains \a part.
  void Says(const std::string& property, const std::string& text, const std::string& part,
    int line = __builtin_LINE())
  {
    const bool holds = text.find(part) != std::string::npos;
    this->Report(
      holds ? property : property + ": '" + part + "' is not in '" + text + "'", holds, line);
  }

  /// The property holds if \a body throws an Exception.
  template <typename Exception, typename Body>
  void Throws(const std::string& property, const Body& body, int line = __builtin_LINE())
  {
    try
    {
      body();
      this->Report(property + ": nothing was thrown", false, line);
    }
    catch (const Exception&)
    {
      this->Report(property, true, line);
    }
  }

  /// Exit code of the test.
  int Result() const { return this->Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE; }

private:
  template <typename A, typename B, typename Relation>
  void Compare(const std::string& property, const A& value, const char* sign, const B& other,
    const Relation& relation, int line)
  {
    bool holds;
    if constexpr (std::is_integral_v<A> && std::is_integral_v<B>)
    {
      holds = relation(static_cast<long long>(value), static_cast<long long>(other));
    }
    else
    {
      holds = relation(value, other);
    }
    // Lists and matrices that are equal need no print.
    const bool isShort = std::is_arithmetic_v<A> && std::is_arithmetic_v<B>;
    const bool isShown = isShort || !holds;
    this->Report(
      isShown ? property + ": " + AsText(value) + sign + AsText(other) : property, holds, line);
  }

  void Report(const std::string& property, bool holds, int line)
  {
    this->Failures += !holds;
    std::cout << (holds ? "ok    " : "FAILS ") << property;
    if (!holds)
    {
      std::cout << " (line " << line << ")";
    }
    std::cout << std::endl;
  }

  int Failures = 0;
};

/// The groups of properties of a test program: all are checked, or the one that the first argument
/// names. Each group is a test of its own for ctest (TestGroups.cmake).
class Groups
{
public:
  Groups(int argc, char* argv[])
    : Chosen(argc > 1 ? argv[1] : "")
  {
  }

  void Run(const std::string& name, void (*check)(Checks&))
  {
    if (this->Chosen.empty() || this->Chosen == name)
    {
      this->IsFound = true;
      check(this->Collected);
    }
  }

  /// Exit code of the test.
  int Result() const
  {
    if (!this->IsFound)
    {
      std::cout << "there is no group '" << this->Chosen << "'" << std::endl;
    }
    return this->IsFound ? this->Collected.Result() : EXIT_FAILURE;
  }

private:
  const std::string Chosen;
  bool IsFound = false;
  Checks Collected;
};

#endif
