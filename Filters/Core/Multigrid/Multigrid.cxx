// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Multigrid/Multigrid.h"

#include "Core/Base/Threading.h"

namespace lmo
{
namespace
{
using Row = PackedRow<float>;

constexpr Index CoarsestSize = 400;
constexpr double LargestCoarseningRatio = 0.8; ///< a coarser level is not worth its while above

/// Of the Chebyshev smoother. Cotangents may be negative and need more of it, on the finest level.
constexpr float SmootherShare = 8;
constexpr int SmootherDegree = 3;
constexpr int CotangentSmootherDegree = 5;

/// product = A x
void Assign(const PaddedCsrMatrix& A, const PackedPoints<float>& x, PackedPoints<float>& product)
{
  ParallelFor(A.Size(), [rows = PaddedCsrMatrix::Times(A, x), product = View(product)](
                          Index i) mutable { product.col(i) = rows(i); });
}
}

Multigrid::Multigrid(std::shared_ptr<const ShiftedStiffness> matrix, ProgressMonitor& monitor)
  : Matrix(std::move(matrix))
  , Eliminated(*this->Matrix)
  , FinestSmoother(ChebyshevSmoother(
      this->Matrix->L.edgeWeights ? CotangentSmootherDegree : SmootherDegree, SmootherShare))
  , CoarseSmoother(ChebyshevSmoother(SmootherDegree, SmootherShare))
{
  SparseRows coarse;
  if (this->Eliminated.IsEmpty())
  {
    coarse = this->AddLevel(*this->Matrix, monitor);
    for (Index i = 0; i < this->Matrix->Size(); ++i)
    {
      this->Levels[0].smootherScale[i] *= !this->Matrix->isLeftOut[i];
    }
  }
  else
  {
    monitor.Report(0);
    coarse = this->Eliminated.SchurComplement(*this->Matrix);
    this->RestrictedRightHandSide.resize(4, coarse.rows());
    this->RestrictedSolution.resize(4, coarse.rows());
  }
  while (coarse.rows() > 0)
  {
    SparseRows coarser = this->AddLevel(SparseRowList(coarse), monitor);
    this->Levels.back().A = PaddedCsrMatrix(coarse);
    coarse.swap(coarser);
  }
}

template <typename Rows>
SparseRows Multigrid::AddLevel(const Rows& matrix, ProgressMonitor& monitor)
{
  const Index size = matrix.Size();
  this->Levels.emplace_back();
  Level& level = this->Levels.back();
  level.smootherScale = SmootherScale(matrix);
  level.previous.resize(4, size);
  const Aggregation aggregation = size > CoarsestSize ? Aggregate(matrix) : Aggregation();
  const bool isNearlyDiagonal = size > CoarsestSize && aggregation.count == 0;
  if (isNearlyDiagonal)
  {
    return {};
  }
  if (aggregation.count == 0 || aggregation.count > LargestCoarseningRatio * size)
  {
    this->FactoriseCoarsest(matrix);
    return {};
  }
  monitor.Report(0);
  level.residual.resize(4, size);
  level.coarseRightHandSide.resize(4, aggregation.count);
  level.coarseSolution.resize(4, aggregation.count);
  const SparseRows prolongation = SmoothedProlongation(matrix, level.smootherScale, aggregation);
  const SparseRows restriction = prolongation.transpose();
  level.prolongation = PaddedCsrMatrix(prolongation);
  level.restriction = PaddedCsrMatrix(restriction);
  monitor.Report(0);
  constexpr Index expectedEntries = 8;
  const SparseRows product = Multiply(matrix, prolongation, expectedEntries);
  return Multiply(SparseRowList(restriction), product, 2 * expectedEntries);
}

template <typename Rows>
void Multigrid::FactoriseCoarsest(const Rows& matrix)
{
  std::vector<Eigen::Triplet<double, Index>> entries;
  for (Index i = 0; i < matrix.Size(); ++i)
  {
    matrix.ForEachEntry(i, [&](Index j, double value) { entries.emplace_back(i, j, value); });
  }
  SparseMatrix coarsest(matrix.Size(), matrix.Size());
  coarsest.setFromTriplets(entries.begin(), entries.end());
  this->Coarsest.compute(coarsest);
}

void Multigrid::Apply(
  const PackedPoints<float>& rightHandSide, PackedPoints<float>& solution, ProgressMonitor& monitor)
{
  this->WithoutEliminated(rightHandSide, solution, monitor, &Multigrid::CycleFrom);
}

void Multigrid::ApplyTransposed(
  const PackedPoints<float>& rightHandSide, PackedPoints<float>& solution, ProgressMonitor& monitor)
{
  this->WithoutEliminated(rightHandSide, solution, monitor, &Multigrid::TransposedCycleFrom);
}

void Multigrid::WithoutEliminated(const PackedPoints<float>& rightHandSide,
  PackedPoints<float>& solution, ProgressMonitor& monitor, Cycle cycle)
{
  monitor.Report(0);
  if (this->Eliminated.IsEmpty())
  {
    (this->*cycle)(0, rightHandSide, solution);
    return;
  }
  this->Eliminated.Restrict(rightHandSide, this->RestrictedRightHandSide);
  (this->*cycle)(0, this->RestrictedRightHandSide, this->RestrictedSolution);
  this->Eliminated.Prolong(this->RestrictedSolution, rightHandSide, solution);
}

void Multigrid::CycleFrom(std::size_t index, const PackedPoints<float>& b, PackedPoints<float>& x)
{
  if (index + 1 == this->Levels.size())
  {
    this->SolveCoarsest(b, x);
    return;
  }
  Level& level = this->Levels[index];
  const auto size = static_cast<Index>(level.smootherScale.size());
  this->SmoothFromZero(index, b, x);
  this->WithRows(index, x,
    [&](const auto& rows)
    {
      ParallelFor(size, [=, b = View(b), residual = View(level.residual)](Index i) mutable
        { residual.col(i) = b.col(i) - rows(i); });
    });
  Assign(level.restriction, level.residual, level.coarseRightHandSide);
  this->CycleFrom(index + 1, level.coarseRightHandSide, level.coarseSolution);
  ParallelFor(size, [rows = PaddedCsrMatrix::Times(level.prolongation, level.coarseSolution),
                      x = View(x)](Index i) mutable { x.col(i) += rows(i); });
}

void Multigrid::TransposedCycleFrom(
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
  this->Smooth(index, b, x, 0);
}

template <typename Body>
void Multigrid::WithRows(std::size_t index, const PackedPoints<float>& x, const Body& body) const
{
  if (index > 0 || !this->Eliminated.IsEmpty())
  {
    body(PaddedCsrMatrix::Times(this->Levels[index].A, x));
    return;
  }
  this->Matrix->K->WithRows(x,
    [&](const auto& Kx)
    {
      body([Kx, shift = this->Matrix->shift.data(), x = View(x)](Index i)
        { return Row(Kx(i) + shift[i] * x.col(i)); });
    });
}

Multigrid::Smoother Multigrid::ChebyshevSmoother(int degree, float share)
{
  const float upper = LargestEigenvalue;
  const float lower = upper / share;
  const float centre = (upper + lower) / 2;
  const float radius = (upper - lower) / 2;
  Smoother steps{ { 0, 1 / centre } };
  float rho = radius / centre;
  for (int step = 1; step < degree; ++step)
  {
    const float nextRho = 1 / (2 * centre / radius - rho);
    steps.push_back({ nextRho * rho, 2 * nextRho / radius });
    rho = nextRho;
  }
  return steps;
}

void Multigrid::SmoothFromZero(
  std::size_t index, const PackedPoints<float>& b, PackedPoints<float>& x)
{
  Level& level = this->Levels[index];
  ParallelFor(static_cast<Index>(level.smootherScale.size()),
    [b = View(b), x = View(x), previous = View(level.previous), scale = level.smootherScale.data(),
      factor = this->GetSmoother(index)[0].factor](Index i) mutable
    {
      previous.col(i).setZero();
      x.col(i) = factor * scale[i] * b.col(i);
    });
  this->Smooth(index, b, x, 1);
}

void Multigrid::Smooth(
  std::size_t index, const PackedPoints<float>& b, PackedPoints<float>& x, std::size_t first)
{
  Level& level = this->Levels[index];
  const auto size = static_cast<Index>(level.smootherScale.size());
  const Smoother& steps = this->GetSmoother(index);
  for (std::size_t k = first; k < steps.size(); ++k)
  {
    this->WithRows(index, x,
      [&](const auto& rows)
      {
        ParallelFor(size,
          [rows, b = View(b), x = View(std::as_const(x)), previous = View(level.previous),
            scale = level.smootherScale.data(), step = steps[k],
            hasPrevious = k > 0](Index i) mutable
          {
            const Row old = x.col(i);
            const Row before = hasPrevious ? Row(previous.col(i)) : old;
            previous.col(i) =
              old + step.momentum * (old - before) + step.factor * scale[i] * (b.col(i) - rows(i));
          });
      });
    x.swap(level.previous);
  }
}

void Multigrid::SolveCoarsest(const PackedPoints<float>& b, PackedPoints<float>& x)
{
  if (this->Coarsest.rows() == 0)
  {
    this->SmoothFromZero(this->Levels.size() - 1, b, x);
    return;
  }
  const Eigen::MatrixXd exactB = b.matrix().transpose().cast<double>();
  x = this->Coarsest.solve(exactB).transpose().cast<float>().array();
}
}
