// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_LaplacianTerm_h
#define lmo_LaplacianTerm_h

#include "Core/LeastSquares/EllpackStiffness.h"
#include "Core/LeastSquares/EnergyTerm.h"

namespace lmo
{
/// Laplacians in Eqn. 11: the sum of |W_L,i T_i ((L d)_i - c_i)|^2 with c = f - L V. With K = E - S
/// and Q = (G W_L)^2, its part of the matrix A is K Q T K.
struct LaplacianTerm
{
  Laplacian L;
  Vector weights;                                   ///< diagonal of W_L
  std::shared_ptr<const Points> target;             ///< c
  std::shared_ptr<const Vector> clampedEdgeWeights; ///< for multigrid: those of L without the
                                                    ///< largest; null stands for those of L
  std::vector<Matrix3> projectors;                  ///< T_i; none stand for the identity

  /// Q_i
  double RowWeight(Index i) const
  {
    const double weight = this->L.rowScale[i] * this->weights[i];
    return weight * weight;
  }

  bool IsCoupled() const { return !this->projectors.empty(); }

  double Energy(const Points& d) const;

  auto ResidualRows(const Points& d) const
  {
    return [this, y = this->WeightedRows(d)](Index i, Vector3& sum)
    { sum -= StiffnessRow(this->L, y, i); };
  }

  void AddDiagonal(Index i, DiagonalBlock& block) const;

  void AddEntries(MatrixEntries& entries) const;

  /// T (G W_L^2 c + Q K d), with which L^T T W_L^2 (c - L d) is -K times it; d without rows stands
  /// for 0.
  Points WeightedRows(const Points& d) const;

  template <typename Scalar>
  class Product
  {
  public:
    static constexpr bool IsForCoupled = false;

    explicit Product(const LaplacianTerm& term);

    std::shared_ptr<const EllpackStiffness<Scalar>> GetStiffness() const { return this->K; }

    /// Computes Q T K x.
    void Prepare(const PackedPoints<Scalar>& x);

    template <typename Body>
    void WithRows(const Body& body) const
    {
      this->K->WithRows(this->RowValues,
        [&body](const auto& rows) {
          body(
            [rows](Index i, const PackedRow<Scalar>&, PackedRow<Scalar>& sum) { sum += rows(i); });
        });
    }

  private:
    std::shared_ptr<const EllpackStiffness<Scalar>> K;
    Eigen::Array<Scalar, Eigen::Dynamic, 1> Q;
    PackedMatrices<Scalar> Projectors; ///< no columns if there are none
    PackedPoints<Scalar> RowValues;
  };
};
}

#endif
