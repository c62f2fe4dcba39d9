// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
// The smoother of multigrid on a cycle, whose eigenvectors are cosines.
#include "Checks.h"

#include "Core/Multigrid/ChebyshevSmoother.h"
#include "Core/Multigrid/ChebyshevSmoother.txx"

#include <cmath>

using namespace lmo;

namespace
{
/// L_u of a cycle, times 2.
struct Cycle
{
  Index size;

  Index Size() const { return this->size; }
  Index Next(Index i) const { return (i + 1) % this->size; }
  Index Previous(Index i) const { return (i + this->size - 1) % this->size; }

  template <typename Visit>
  void ForEachEntry(Index i, const Visit& visit) const
  {
    visit(this->Previous(i), -1.0f);
    visit(i, 2.0f);
    visit(this->Next(i), -1.0f);
  }

  template <typename Body>
  void WithRows(const PackedPoints<float>& x, const Body& body) const
  {
    body([&](Index i) -> PackedRow<float>
      { return 2 * x.col(i) - x.col(this->Previous(i)) - x.col(this->Next(i)); });
  }
};

/// The Chebyshev polynomial.
double T(int degree, double x)
{
  return std::abs(x) <= 1 ? std::cos(degree * std::acos(x)) : std::cosh(degree * std::acosh(x));
}

/// How far the smoother leaves the error of a wave from what the polynomial makes of it: its
/// largest value over the upper seven eighths of the eigenvalues, 0 to 2, is the least possible.
double ErrorOfWave(int degree, int waves)
{
  const Cycle A{ 64 };
  const double angle = 2 * EIGEN_PI * waves / A.size;
  PackedPoints<float> wave(4, A.size);
  for (Index i = 0; i < A.size; ++i)
  {
    wave.col(i) = PackedRow<float>::Constant(static_cast<float>(std::cos(i * angle)));
  }
  const PackedPoints<float> b = static_cast<float>(2 - 2 * std::cos(angle)) * wave;
  PackedPoints<float> x(4, A.size);
  ChebyshevSmoother smoother(A, degree);
  smoother.SmoothFromZero(A, b, x);
  constexpr double lower = 0.25;
  const double eigenvalue = 1 - std::cos(angle);
  const auto scaled = [](double lambda) { return (2 + lower - 2 * lambda) / (2 - lower); };
  const double factor = T(degree, scaled(eigenvalue)) / T(degree, scaled(0));
  return (wave - x - static_cast<float>(factor) * wave).abs().maxCoeff();
}
}

int TestChebyshevSmoother(int, char*[])
{
  Checks c;
  for (const int degree : { 1, 2, 3, 5 })
  {
    for (const int waves : { 1, 5, 12, 20, 31 })
    {
      c.Error("degree " + std::to_string(degree) + " leaves of " + std::to_string(waves) +
                " waves what the polynomial says",
        ErrorOfWave(degree, waves), 3e-6);
    }
  }
  return c.Result();
}
