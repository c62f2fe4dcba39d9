// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/LeastSquares/LaplacianTerm.h"

#include "Core/Base/Threading.h"

namespace lmo
{
namespace
{
/// Calls visit(j, K_ij) for the entries of row i of K.
template <typename Visit>
void ForEachStiffness(const Laplacian& L, Index i, const Visit& visit)
{
  const AdjacencyLists& rings = *L.rings;
  visit(i, WeightSum(L, i));
  for (Index k = rings.offsets[i]; k < rings.offsets[i + 1]; ++k)
  {
    visit(rings.ids[k], L.edgeWeights ? -(*L.edgeWeights)[k] : -1.0);
  }
}
}

double LaplacianTerm::Energy(const Points& d) const
{
  return ParallelSum(static_cast<Index>(d.rows()), 0.0,
    [&](double& sum, Index i)
    {
      Vector3 difference =
        -this->L.rowScale[i] * StiffnessRow(this->L, d, i) - this->target->row(i);
      if (this->IsCoupled())
      {
        difference *= this->projectors[i];
      }
      sum += (this->weights[i] * difference).squaredNorm();
    });
}

Points LaplacianTerm::WeightedRows(const Points& d) const
{
  const auto size = static_cast<Index>(this->weights.size());
  Points y(size, 3);
  ParallelFor(size,
    [&](Index i)
    {
      const double weight = this->weights[i];
      Vector3 row = this->L.rowScale[i] * weight * weight * this->target->row(i);
      if (d.rows() > 0)
      {
        row += this->RowWeight(i) * StiffnessRow(this->L, d, i);
      }
      if (this->IsCoupled())
      {
        row *= this->projectors[i];
      }
      y.row(i) = row;
    });
  return y;
}

void LaplacianTerm::AddDiagonal(Index i, DiagonalBlock& block) const
{
  ForEachStiffness(this->L, i,
    [&](Index j, double stiffness)
    {
      const double value = stiffness * stiffness * this->RowWeight(j);
      if (this->IsCoupled())
      {
        block.coupled += value * this->projectors[j];
      }
      else
      {
        block.isotropic += value;
      }
    });
}

void LaplacianTerm::AddEntries(MatrixEntries& entries) const
{
  const auto add = [&](Index a, Index b, Index j, double value) // K_aj Q_j T_j K_jb
  {
    if (this->IsCoupled())
    {
      entries.coupled.push_back({ a, b, value * this->projectors[j] });
    }
    else
    {
      entries.isotropic.emplace_back(a, b, value);
    }
  };
  for (Index j = 0; j < static_cast<Index>(this->weights.size()); ++j)
  {
    if (this->RowWeight(j) > 0) // else the ring may be too long for pairs
    {
      ForEachStiffness(this->L, j,
        [&](Index a, double first)
        {
          ForEachStiffness(this->L, j,
            [&](Index b, double second) { add(a, b, j, first * this->RowWeight(j) * second); });
        });
    }
  }
}

template <typename Scalar>
LaplacianTerm::Product<Scalar>::Product(const LaplacianTerm& term)
  : K(std::make_shared<const EllpackStiffness<Scalar>>(term.L))
  , Q(term.weights.size())
  , Projectors(12, term.projectors.size())
  , RowValues(4, term.weights.size())
{
  ParallelFor(static_cast<Index>(term.weights.size()),
    [&](Index i)
    {
      this->Q[i] = static_cast<Scalar>(term.RowWeight(i));
      if (term.IsCoupled())
      {
        StoreMatrix(term.projectors[i], i, this->Projectors);
      }
    });
}

template <typename Scalar>
void LaplacianTerm::Product<Scalar>::Prepare(const PackedPoints<Scalar>& x)
{
  const auto size = static_cast<Index>(x.cols());
  this->K->WithRows(x,
    [&](const auto& rows)
    {
      ParallelFor(size, [Kx = rows, Q = this->Q.data(), rowValues = View(this->RowValues)](
                          Index i) mutable { rowValues.col(i) = Q[i] * Kx(i); });
    });
  if (this->Projectors.cols() > 0)
  {
    ParallelFor(size,
      [projectors = this->Projectors.data(), rowValues = View(this->RowValues)](Index i) mutable
      {
        const PackedRow<Scalar> row = rowValues.col(i);
        rowValues.col(i) = MultiplyPacked(projectors + 12 * std::ptrdiff_t(i), row);
      });
  }
}

template class LaplacianTerm::Product<float>;
template class LaplacianTerm::Product<double>;
}
