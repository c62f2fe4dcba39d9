// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_PositionTerm_h
#define lmo_PositionTerm_h

#include "Core/Base/Threading.h"
#include "Core/LeastSquares/EnergyTerm.h"

namespace lmo
{
/// Positions in Eqn. 11: |W_p d|^2.
struct PositionTerm
{
  Vector weights; ///< diagonal of W_p

  Index Size() const { return static_cast<Index>(this->weights.size()); }
  double SquaredWeight(Index i) const { return this->weights[i] * this->weights[i]; }

  bool IsCoupled() const { return false; }

  double Energy(const Points& d) const
  {
    return ParallelSum(this->Size(), 0.0,
      [&](double& sum, Index i) { sum += (this->weights[i] * d.row(i)).squaredNorm(); });
  }

  auto ResidualRows(const Points& d) const
  {
    return [this, &d](Index i, Vector3& sum)
    {
      if (d.rows() > 0)
      {
        sum -= this->SquaredWeight(i) * d.row(i);
      }
    };
  }

  void AddDiagonal(Index i, DiagonalBlock& block) const
  {
    block.isotropic += this->SquaredWeight(i);
  }

  void AddEntries(MatrixEntries& entries) const
  {
    for (Index i = 0; i < this->Size(); ++i)
    {
      entries.isotropic.emplace_back(i, i, this->SquaredWeight(i));
    }
  }

  template <typename Scalar>
  class Product
  {
  public:
    static constexpr bool IsForCoupled = false;

    explicit Product(const PositionTerm& term)
      : SquaredWeights(term.weights.array().square().template cast<Scalar>())
    {
    }

    void Prepare(const PackedPoints<Scalar>&) {}

    template <typename Body>
    void WithRows(const Body& body) const
    {
      body([squaredWeights = this->SquaredWeights.data()](Index i, const PackedRow<Scalar>& x,
             PackedRow<Scalar>& sum) { sum += squaredWeights[i] * x; });
    }

  private:
    Eigen::Array<Scalar, Eigen::Dynamic, 1> SquaredWeights;
  };
};
}

#endif
