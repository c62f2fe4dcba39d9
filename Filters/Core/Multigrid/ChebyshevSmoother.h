// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_ChebyshevSmoother_h
#define lmo_ChebyshevSmoother_h

#include "Core/LeastSquares/PackedPoints.h"

#include <vector>

namespace lmo
{
/// Chebyshev iteration for A x = b, A symmetric, that reduces the part of the error in the upper
/// range of the eigenvalues of D A (Adams, Brezina, Hu, Tuminaro 2003). The diagonal D has the
/// reciprocals of half the rows' sums of magnitudes, so that no eigenvalue of D A is above 2
/// (Gershgorin). Unlike one bound for the whole matrix it is local: triangles with large negative
/// cotangents slow down the smoother only where they are.
///
/// A matrix has Size(), ForEachEntry(i, visit), which calls visit(column, value) for the entries of
/// row i, and WithRows(x, body), which calls body(rows), where rows(i) is row i of A x and cheap to
/// copy.
class ChebyshevSmoother
{
public:
  /// \param degree number of steps, > 0
  template <typename Matrix>
  ChebyshevSmoother(const Matrix& A, int degree);

  /// Bound of the eigenvalues of D A.
  static constexpr float LargestEigenvalue = 2;

  /// D; 0 where a row is empty, whose unknown stays 0.
  const Eigen::ArrayXf& GetScale() const { return this->Scale; }
  Index Size() const { return static_cast<Index>(this->Scale.size()); }

  /// Does all steps from x = 0.
  template <typename Matrix>
  void SmoothFromZero(const Matrix& A, const PackedPoints<float>& b, PackedPoints<float>& x);

  /// Does all steps from x on.
  template <typename Matrix>
  void Smooth(const Matrix& A, const PackedPoints<float>& b, PackedPoints<float>& x)
  {
    this->SmoothFrom(0, A, b, x);
  }

private:
  /// x + momentum (x - previous x) + factor D (b - A x).
  struct Step
  {
    float momentum;
    float factor;
  };

  static std::vector<Step> MakeSteps(int degree);

  /// Does the steps from \a first on.
  template <typename Matrix>
  void SmoothFrom(
    std::size_t first, const Matrix& A, const PackedPoints<float>& b, PackedPoints<float>& x);

  std::vector<Step> Steps;
  Eigen::ArrayXf Scale;
  PackedPoints<float> Previous; ///< iterate
};
}

#include "Core/Multigrid/ChebyshevSmoother.txx"

#endif
