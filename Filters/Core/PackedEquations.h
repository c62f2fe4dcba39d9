// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_PackedEquations_h
#define lmo_PackedEquations_h

#include "LeastSquaresProblem.h"
#include "PackedStiffness.h"

namespace lmo
{
/// Inner products of the columns x, y and z; the fourth is 0.
using Dots = Eigen::Array4d;

/// Sums inner products; plain numbers stay in registers.
struct DotSum
{
  double x = 0;
  double y = 0;
  double z = 0;

  template <typename Row>
  void Add(const Row& products)
  {
    this->x += products[0];
    this->y += products[1];
    this->z += products[2];
  }

  void operator+=(const DotSum& other)
  {
    this->x += other.x;
    this->y += other.y;
    this->z += other.z;
  }

  Dots Get() const { return Dots(this->x, this->y, this->z, 0); }
};

/// The matrix A of a problem's normal equations, stored for speed. In single precision it serves to
/// find search directions: residuals that decide are computed by Residual().
template <typename Scalar>
class PackedEquations
{
public:
  /// Keeps a reference to \a problem.
  explicit PackedEquations(const LeastSquaresProblem& problem);

  Index Size() const { return this->Problem.Size(); }
  const LeastSquaresProblem& GetProblem() const { return this->Problem; }
  const PackedStiffness<Scalar>& GetStiffness() const { return this->K; }

  /// product = A x, for x within the motion allowed.
  /// \return the inner products of x and A x; three times their sum if the problem is coupled
  Dots Multiply(const PackedPoints<Scalar>& x, PackedPoints<Scalar>& product);

private:
  template <bool Weighted>
  Dots MultiplyWeighted(const PackedPoints<Scalar>& x, PackedPoints<Scalar>& product);

  /// Adds what is not K Q K + W_p^2 and projects on the motion allowed.
  Dots FinishCoupled(const PackedPoints<Scalar>& x, PackedPoints<Scalar>& product);

  const LeastSquaresProblem& Problem;
  PackedStiffness<Scalar> K;
  Eigen::Array<Scalar, Eigen::Dynamic, 1> Q;
  Eigen::Array<Scalar, Eigen::Dynamic, 1> SquaredPositionWeights;
  PackedPoints<Scalar> RowValues;
};

extern template class PackedEquations<float>;
extern template class PackedEquations<double>;
}

#endif
