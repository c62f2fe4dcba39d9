// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_TangentPlaneTerm_h
#define lmo_TangentPlaneTerm_h

#include "Core/Base/Threading.h"
#include "Core/LeastSquares/EnergyTerm.h"

#include <cmath>

namespace lmo
{
/// Eqn. 15: w^2 sum_i (n_i d_i)^2.
struct TangentPlaneTerm
{
  Points normals;    ///< n_i; no rows if there are no tangent-plane constraints
  double weight = 0; ///< w

  bool IsCoupled() const { return this->normals.rows() > 0; }

  /// w n_i
  Vector3 Row(Index i) const { return this->weight * this->normals.row(i); }

  double Energy(const Points& d) const
  {
    return ParallelSum(static_cast<Index>(this->normals.rows()), 0.0,
      [&](double& sum, Index i) { sum += std::pow(this->Row(i).dot(d.row(i)), 2); });
  }

  auto ResidualRows(const Points& d) const
  {
    return [this, &d](Index i, Vector3& sum)
    {
      if (this->IsCoupled() && d.rows() > 0)
      {
        const Vector3 row = this->Row(i);
        sum -= row.dot(d.row(i)) * row;
      }
    };
  }

  void AddDiagonal(Index i, DiagonalBlock& block) const
  {
    if (this->IsCoupled())
    {
      block.coupled += this->Row(i).transpose() * this->Row(i);
    }
  }

  void AddEntries(MatrixEntries& entries) const
  {
    for (Index i = 0; i < static_cast<Index>(this->normals.rows()); ++i)
    {
      entries.coupled.push_back({ i, i, this->Row(i).transpose() * this->Row(i) });
    }
  }

  template <typename Scalar>
  class Product
  {
  public:
    static constexpr bool IsForCoupled = true;

    explicit Product(const TangentPlaneTerm& term)
      : Normals(4, term.normals.rows())
    {
      ParallelFor(static_cast<Index>(term.normals.rows()),
        [&](Index i) { this->Normals.col(i) = Pack<Scalar>(term.Row(i)); });
    }

    void Prepare(const PackedPoints<Scalar>&) {}

    template <typename Body>
    void WithRows(const Body& body) const
    {
      body(
        [normals = View(this->Normals)](Index i, const PackedRow<Scalar>& x, PackedRow<Scalar>& sum)
        {
          if (normals.cols() > 0)
          {
            const PackedRow<Scalar> normal = normals.col(i);
            sum += (normal * x).sum() * normal;
          }
        });
    }

  private:
    PackedPoints<Scalar> Normals; ///< w n_i
  };
};
}

#endif
