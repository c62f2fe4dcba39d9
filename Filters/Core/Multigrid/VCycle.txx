// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_VCycle_txx
#define lmo_VCycle_txx

#include "Core/Base/Threading.h"
#include "Core/Multigrid/SmoothedAggregation.h"

#include <utility>

namespace lmo
{
template <typename Matrix>
VCycle<Matrix>::VCycle(
  std::shared_ptr<const Matrix> matrix, int finestDegree, ProgressMonitor& monitor)
  : Finest(std::move(matrix))
{
  constexpr int coarseDegree = 3;
  PaddedCsrMatrix coarse(this->AddLevel(*this->Finest, finestDegree, monitor));
  while (coarse.Size() > 0)
  {
    PaddedCsrMatrix coarser(this->AddLevel(coarse, coarseDegree, monitor));
    this->Levels.back().A = std::move(coarse);
    coarse = std::move(coarser);
  }
}

template <typename Matrix>
template <typename LevelMatrix>
SparseRows VCycle<Matrix>::AddLevel(
  const LevelMatrix& A, int smootherDegree, ProgressMonitor& monitor)
{
  constexpr Index coarsestSize = 400;
  constexpr double largestCoarseningRatio = 0.8; // a coarser level is not worth its while above
  const Index size = A.Size();
  this->Levels.push_back({ {}, ChebyshevSmoother(A, smootherDegree), {}, {}, {}, {}, {} });
  Level& level = this->Levels.back();
  const Aggregation aggregation = size > coarsestSize ? Aggregate(A) : Aggregation();
  const bool isNearlyDiagonal = size > coarsestSize && aggregation.count == 0;
  if (isNearlyDiagonal)
  {
    return {};
  }
  if (aggregation.count == 0 || aggregation.count > largestCoarseningRatio * size)
  {
    this->FactoriseCoarsest(A);
    return {};
  }
  monitor.Report(0);
  level.residual.resize(4, size);
  level.coarseRightHandSide.resize(4, aggregation.count);
  level.coarseSolution.resize(4, aggregation.count);
  const SparseRows prolongation = SmoothedProlongation(A, level.smoother, aggregation);
  const SparseRows restriction = prolongation.transpose();
  level.prolongation = PaddedCsrMatrix(prolongation);
  level.restriction = PaddedCsrMatrix(restriction);
  monitor.Report(0);
  constexpr Index expectedEntries = 8;
  const SparseRows product = Multiply(A, prolongation, expectedEntries);
  return Multiply(SparseRowList(restriction), product, 2 * expectedEntries);
}

template <typename Matrix>
template <typename LevelMatrix>
void VCycle<Matrix>::FactoriseCoarsest(const LevelMatrix& A)
{
  std::vector<Eigen::Triplet<double, Index>> entries;
  for (Index i = 0; i < A.Size(); ++i)
  {
    const std::size_t before = entries.size();
    A.ForEachEntry(i, [&](Index j, double value) { entries.emplace_back(i, j, value); });
    if (entries.size() == before)
    {
      entries.emplace_back(i, i, 1);
    }
  }
  SparseMatrix coarsest(A.Size(), A.Size());
  coarsest.setFromTriplets(entries.begin(), entries.end());
  this->Coarsest.compute(coarsest);
}

template <typename Matrix>
void VCycle<Matrix>::CycleFrom(
  std::size_t index, const PackedPoints<float>& b, PackedPoints<float>& x)
{
  if (index + 1 == this->Levels.size())
  {
    this->SolveCoarsest(b, x);
    return;
  }
  Level& level = this->Levels[index];
  this->WithMatrix(index,
    [&](const auto& A)
    {
      level.smoother.SmoothFromZero(A, b, x);
      A.WithRows(x,
        [&](const auto& rows)
        {
          ParallelFor(A.Size(), [=, b = View(b), residual = View(level.residual)](Index i) mutable
            { residual.col(i) = b.col(i) - rows(i); });
        });
    });
  Assign(level.restriction, level.residual, level.coarseRightHandSide);
  this->CycleFrom(index + 1, level.coarseRightHandSide, level.coarseSolution);
  level.prolongation.WithRows(level.coarseSolution,
    [&](const auto& rows)
    {
      ParallelFor(
        level.prolongation.Size(), [=, x = View(x)](Index i) mutable { x.col(i) += rows(i); });
    });
}

template <typename Matrix>
void VCycle<Matrix>::TransposedCycleFrom(
  std::size_t index, const PackedPoints<float>& b, PackedPoints<float>& x)
{
  if (index + 1 == this->Levels.size())
  {
    this->SolveCoarsest(b, x);
    return;
  }
  Level& level = this->Levels[index];
  Assign(level.restriction, b, level.coarseRightHandSide);
  this->TransposedCycleFrom(index + 1, level.coarseRightHandSide, level.coarseSolution);
  Assign(level.prolongation, level.coarseSolution, x);
  this->WithMatrix(index, [&](const auto& A) { level.smoother.Smooth(A, b, x); });
}

template <typename Matrix>
void VCycle<Matrix>::SolveCoarsest(const PackedPoints<float>& b, PackedPoints<float>& x)
{
  if (this->Coarsest.rows() == 0)
  {
    const std::size_t last = this->Levels.size() - 1;
    this->WithMatrix(
      last, [&](const auto& A) { this->Levels[last].smoother.SmoothFromZero(A, b, x); });
    return;
  }
  const Eigen::MatrixXd exactB = b.matrix().transpose().cast<double>();
  x = this->Coarsest.solve(exactB).transpose().template cast<float>().array();
}
}

#endif
