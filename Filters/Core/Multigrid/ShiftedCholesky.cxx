// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Multigrid/ShiftedCholesky.h"

#include "Core/Base/Exceptions.h"
#include "Core/Base/Threading.h"
#include "Core/Multigrid/FillReducingOrdering.h"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <utility>

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
    matrix.ForEachEntryWithIdentity(j,
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

using Permutation = Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, Index>;

/// Place of each unknown in an order with few entries.
std::vector<Index> FindOrder(const SparseMatrix& lower)
{
  Permutation inverse;
  FillReducingOrdering()(SparseMatrix(lower.selfadjointView<Eigen::Lower>()), inverse);
  const Permutation permutation = inverse.inverse();
  const Index* places = permutation.indices().data();
  return { places, places + permutation.size() };
}

SparseMatrix Permuted(const SparseMatrix& lower, const std::vector<Index>& placeOf)
{
  Permutation permutation(lower.rows());
  std::copy(placeOf.begin(), placeOf.end(), permutation.indices().data());
  SparseMatrix permuted(lower.rows(), lower.cols());
  permuted.selfadjointView<Eigen::Lower>() =
    lower.selfadjointView<Eigen::Lower>().twistedBy(permutation);
  return permuted;
}

/// The monitor may cancel between some rows.
void AskNowAndThen(ProgressMonitor& monitor, Index row)
{
  constexpr Index often = 1 << 16;
  if (row % often == 0)
  {
    monitor.Report(0);
  }
}
}

ShiftedCholesky::ShiftedCholesky(
  std::shared_ptr<const ShiftedStiffness> matrix, const ShiftedCholesky* previous)
  : Matrix(std::move(matrix))
  , Work(4, this->Matrix->Size())
{
  const SparseMatrix lower = LowerTriangle(*this->Matrix);
  this->PlaceOf = previous && previous->Matrix->HasPatternOf(*this->Matrix)
                    ? previous->PlaceOf
                    : std::make_shared<const std::vector<Index>>(FindOrder(lower));
  const Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower, Eigen::NaturalOrdering<Index>>
    factorisation(Permuted(lower, *this->PlaceOf));
  if (factorisation.info() != Eigen::Success || !factorisation.vectorD().allFinite())
  {
    throw SolverError("K + R is singular.");
  }
  const SparseMatrix& columns = factorisation.matrixL().nestedExpression();
  this->InverseD = factorisation.vectorD().cwiseInverse().cast<float>().array();
  this->Offsets.assign(columns.outerIndexPtr(), columns.outerIndexPtr() + columns.cols() + 1);
  this->Columns.assign(columns.innerIndexPtr(), columns.innerIndexPtr() + columns.nonZeros());
  this->Entries.assign(columns.valuePtr(), columns.valuePtr() + columns.nonZeros());
}

void ShiftedCholesky::Apply(
  const PackedPoints<float>& rightHandSide, PackedPoints<float>& solution, ProgressMonitor& monitor)
{
  using Row = PackedRow<float>;
  const std::vector<Index>& placeOf = *this->PlaceOf;
  const auto size = static_cast<Index>(placeOf.size());
  ParallelFor(size, [&](Index i) { this->Work.col(placeOf[i]) = rightHandSide.col(i); });
  auto x = View(this->Work);
  const Index* offsets = this->Offsets.data();
  const Index* columns = this->Columns.data();
  const float* entries = this->Entries.data();
  for (Index i = 0; i < size; ++i)
  {
    AskNowAndThen(monitor, i);
    const Row xi = x.col(i);
    for (Index k = offsets[i]; k < offsets[i + 1]; ++k)
    {
      x.col(columns[k]) -= entries[k] * xi;
    }
    x.col(i) = this->InverseD[i] * xi;
  }
  for (Index i = size - 1; i >= 0; --i)
  {
    AskNowAndThen(monitor, i);
    Row xi = x.col(i);
    for (Index k = offsets[i]; k < offsets[i + 1]; ++k)
    {
      xi -= entries[k] * x.col(columns[k]);
    }
    x.col(i) = xi;
  }
  ParallelFor(size, [&](Index i) { solution.col(i) = this->Work.col(placeOf[i]); });
}
}
