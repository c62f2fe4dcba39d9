// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "StiffnessFactorisation.h"

#include "Exceptions.h"
#include "Ordering.h"
#include "Parallel.h"

#include <Eigen/SparseCholesky>

namespace lmo
{
namespace
{
/// Lower triangle of K + R.
SparseMatrix LowerTriangle(const ShiftedStiffness& matrix)
{
  SparseMatrix lower(matrix.Size(), matrix.Size());
  lower.reserve(4 * std::ptrdiff_t(matrix.Size()));
  for (Index j = 0; j < matrix.Size(); ++j)
  {
    lower.startVec(j);
    matrix.ForEachEntry(j,
      [&](Index i, double value)
      {
        if (i >= j)
        {
          lower.insertBackByOuterInnerUnordered(j, i) = value;
        }
      });
  }
  lower.finalize();
  return lower;
}
}

StiffnessFactorisation::StiffnessFactorisation(const ShiftedStiffness& matrix)
  : PlaceOf(matrix.Size())
  , Work(4, matrix.Size())
{
  const Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower, Ordering> factorisation(
    LowerTriangle(matrix));
  if (factorisation.info() != Eigen::Success || !factorisation.vectorD().allFinite())
  {
    throw SolverError("K + R is singular.");
  }
  const SparseMatrix& columns = factorisation.matrixL().nestedExpression();
  const auto& order = factorisation.permutationP().indices();
  for (Index i = 0; i < matrix.Size(); ++i)
  {
    this->PlaceOf[i] = order.size() > 0 ? order[i] : i;
  }
  this->InverseD = factorisation.vectorD().cwiseInverse().cast<float>().array();
  this->Offsets.assign(columns.outerIndexPtr(), columns.outerIndexPtr() + matrix.Size() + 1);
  this->Columns.assign(columns.innerIndexPtr(), columns.innerIndexPtr() + columns.nonZeros());
  this->Entries.assign(columns.valuePtr(), columns.valuePtr() + columns.nonZeros());
}

void StiffnessFactorisation::Apply(
  const PackedPoints<float>& rightHandSide, PackedPoints<float>& solution)
{
  using Row = PackedRow<float>;
  const auto size = static_cast<Index>(this->PlaceOf.size());
  ParallelFor(size, [&](Index i) { this->Work.col(this->PlaceOf[i]) = rightHandSide.col(i); });
  auto x = View(this->Work);
  const Index* offsets = this->Offsets.data();
  const Index* columns = this->Columns.data();
  const float* entries = this->Entries.data();
  for (Index i = 0; i < size; ++i)
  {
    const Row xi = x.col(i);
    for (Index k = offsets[i]; k < offsets[i + 1]; ++k)
    {
      x.col(columns[k]) -= entries[k] * xi;
    }
    x.col(i) = this->InverseD[i] * xi;
  }
  for (Index i = size - 1; i >= 0; --i)
  {
    Row xi = x.col(i);
    for (Index k = offsets[i]; k < offsets[i + 1]; ++k)
    {
      xi -= entries[k] * x.col(columns[k]);
    }
    x.col(i) = xi;
  }
  ParallelFor(size, [&](Index i) { solution.col(i) = this->Work.col(this->PlaceOf[i]); });
}
}
