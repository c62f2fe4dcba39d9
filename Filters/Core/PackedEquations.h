// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_PackedEquations_h
#define lmo_PackedEquations_h

#include "LeastSquaresProblem.h"

namespace lmo
{
/// A row (x, y, z, 0) per vertex, which the processor handles as one unit.
template <typename Scalar>
using PackedPoints = Eigen::Array<Scalar, 4, Eigen::Dynamic>;

template <typename Scalar>
using PackedRow = Eigen::Array<Scalar, 4, 1>;

/// An inner product each for x, y and z; the fourth is 0.
using Dots = Eigen::Array4d;

/// K = E - S with the first neighbours of each vertex in slots of fixed number: no branch depends
/// on the valence, which the processor could not predict. An unused slot names the vertex itself.
template <typename Scalar>
class PackedStiffness
{
public:
  explicit PackedStiffness(const Laplacian& L);

  bool IsWeighted() const { return this->Weights.cols() > 0; }

  /// Row i of K x.
  template <bool Weighted>
  PackedRow<Scalar> Row(const PackedPoints<Scalar>& x, Index i) const
  {
    const PackedRow<Scalar> centre = x.col(i);
    PackedRow<Scalar> sum = PackedRow<Scalar>::Zero();
    for (int slot = 0; slot < Slots; ++slot)
    {
      const PackedRow<Scalar> difference = centre - x.col(this->Neighbours(slot, i));
      sum += Weighted ? PackedRow<Scalar>(this->Weights(slot, i) * difference) : difference;
    }
    const AdjacencyLists& rings = *this->L.rings;
    for (Index k = rings.offsets[i] + Slots; k < rings.offsets[i + 1]; ++k)
    {
      const Scalar weight = Weighted ? Scalar((*this->L.edgeWeights)[k]) : Scalar(1);
      sum += weight * (centre - x.col(rings.ids[k]));
    }
    return sum;
  }

private:
  static constexpr int Slots = 8;

  const Laplacian& L;
  Eigen::Array<Index, Slots, Eigen::Dynamic> Neighbours;
  Eigen::Array<Scalar, Slots, Eigen::Dynamic> Weights; ///< no columns if all are 1
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

extern template class PackedStiffness<float>;
extern template class PackedStiffness<double>;
extern template class PackedEquations<float>;
extern template class PackedEquations<double>;
}

#endif
