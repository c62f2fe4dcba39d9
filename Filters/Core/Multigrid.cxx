// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Multigrid.h"

#include "Parallel.h"

namespace lmo
{
namespace
{
using Row = PackedRow<float>;

constexpr Index CoarsestSize = 400;
constexpr double LargestCoarseningRatio = 0.8; ///< a coarser level is not worth its while above

/// Chebyshev smoother: on eigenvalues above the largest / share. Cotangents, which may be negative,
/// need more of it.
struct SmootherOptions
{
  int degree;
  float share;
};
constexpr SmootherOptions UniformSmoother{ 2, 5 };
constexpr SmootherOptions CotangentSmoother{ 3, 10 };

/// The rows of A x; cheap to copy.
class SparseRowsTimes
{
public:
  SparseRowsTimes(const SparseRows& A, const PackedPoints<float>& x)
    : X(View(x))
    , Offsets(A.outerIndexPtr())
    , Columns(A.innerIndexPtr())
    , Values(A.valuePtr())
  {
  }

  Row operator()(Index i) const
  {
    Row sum = Row::Zero();
    for (Index k = this->Offsets[i]; k < this->Offsets[i + 1]; ++k)
    {
      sum += this->Values[k] * this->X.col(this->Columns[k]);
    }
    return sum;
  }

private:
  const ConstPackedView<float> X;
  const Index* Offsets;
  const Index* Columns;
  const float* Values;
};
}

Multigrid::Multigrid(std::shared_ptr<const ShiftedStiffness> matrix, Monitor& monitor)
  : Matrix(std::move(matrix))
{
  SparseRows coarse = this->AddLevel(*this->Matrix, monitor);
  for (Index i = 0; i < this->Matrix->Size(); ++i)
  {
    this->Levels[0].smootherScale[i] *= !this->Matrix->isLeftOut[i];
  }
  while (coarse.rows() > 0)
  {
    SparseRows coarser = this->AddLevel(SparseRowList(coarse), monitor);
    this->Levels.back().A.swap(coarse);
    coarse.swap(coarser);
  }
}

template <typename Rows>
SparseRows Multigrid::AddLevel(const Rows& matrix, Monitor& monitor)
{
  const Index size = matrix.Size();
  this->Levels.emplace_back();
  Level& level = this->Levels.back();
  level.smootherScale = SmootherScale(matrix);
  const Aggregation aggregation = size > CoarsestSize ? Aggregate(matrix) : Aggregation();
  if (aggregation.count == 0 || aggregation.count > LargestCoarseningRatio * size)
  {
    this->FactoriseCoarsest(matrix);
    return {};
  }
  monitor.Report(0);
  level.residual.resize(4, size);
  level.step.resize(4, size);
  level.nextStep.resize(4, size);
  level.coarseRightHandSide.resize(4, aggregation.count);
  level.coarseSolution.resize(4, aggregation.count);
  level.prolongation = SmoothedProlongation(matrix, level.smootherScale, aggregation);
  level.restriction = level.prolongation.transpose();
  monitor.Report(0);
  constexpr Index expectedEntries = 8;
  const SparseRows product = Multiply(matrix, level.prolongation, expectedEntries);
  return Multiply(SparseRowList(level.restriction), product, 2 * expectedEntries);
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
  const PackedPoints<float>& rightHandSide, PackedPoints<float>& solution, Monitor& monitor)
{
  monitor.Report(0);
  this->CycleFrom(0, rightHandSide, solution);
}

void Multigrid::CycleFrom(
  std::size_t index, const PackedPoints<float>& rightHandSide, PackedPoints<float>& solution)
{
  if (index + 1 == this->Levels.size())
  {
    this->SolveCoarsest(rightHandSide, solution);
    return;
  }
  Level& level = this->Levels[index];
  const auto size = static_cast<Index>(level.smootherScale.size());
  ParallelFor(size,
    [=, b = View(rightHandSide), x = View(solution), r = View(level.residual)](Index i) mutable
    {
      x.col(i).setZero();
      r.col(i) = b.col(i);
    });
  this->Smooth(index, solution);
  this->WithRows(index, level.step,
    [&](const auto& rows) {
      ParallelFor(size, [=, r = View(level.residual)](Index i) mutable { r.col(i) -= rows(i); });
    });
  ParallelFor(static_cast<Index>(level.restriction.rows()),
    [rows = SparseRowsTimes(level.restriction, level.residual),
      b = View(level.coarseRightHandSide)](Index i) mutable { b.col(i) = rows(i); });
  this->CycleFrom(index + 1, level.coarseRightHandSide, level.coarseSolution);
  ParallelFor(size, [rows = SparseRowsTimes(level.prolongation, level.coarseSolution),
                      x = View(solution)](Index i) mutable { x.col(i) += rows(i); });
  this->WithRows(index, solution,
    [&](const auto& rows)
    {
      ParallelFor(size, [=, b = View(rightHandSide), r = View(level.residual)](Index i) mutable
        { r.col(i) = b.col(i) - rows(i); });
    });
  this->Smooth(index, solution);
}

template <typename Body>
void Multigrid::WithRows(std::size_t index, const PackedPoints<float>& x, const Body& body) const
{
  if (index > 0)
  {
    body(SparseRowsTimes(this->Levels[index].A, x));
    return;
  }
  this->Matrix->K->WithRows(x,
    [&](const auto& Kx)
    {
      body([Kx, shift = this->Matrix->shift.data(), x = View(x)](Index i)
        { return Row(Kx(i) + shift[i] * x.col(i)); });
    });
}

void Multigrid::Smooth(std::size_t index, PackedPoints<float>& solution)
{
  Level& level = this->Levels[index];
  const SmootherOptions options = this->Matrix->L.edgeWeights ? CotangentSmoother : UniformSmoother;
  const float upper = LargestEigenvalue;
  const float lower = upper / options.share;
  const float centre = (upper + lower) / 2;
  const float radius = (upper - lower) / 2;
  const auto size = static_cast<Index>(level.smootherScale.size());
  const float* const smootherScale = level.smootherScale.data();
  ParallelFor(size,
    [=, r = View(level.residual), step = View(level.step), x = View(solution)](Index i) mutable
    {
      step.col(i) = smootherScale[i] / centre * r.col(i);
      x.col(i) += step.col(i);
    });
  float rho = radius / centre;
  for (int degree = 1; degree < options.degree; ++degree)
  {
    const float nextRho = 1 / (2 * centre / radius - rho);
    const float momentum = nextRho * rho;
    const float factor = 2 * nextRho / radius;
    this->WithRows(index, level.step,
      [&](const auto& rows)
      {
        ParallelFor(size,
          [=, r = View(level.residual), step = View(level.step), next = View(level.nextStep),
            x = View(solution)](Index i) mutable
          {
            const Row residual = r.col(i) - rows(i);
            const Row change = momentum * step.col(i) + factor * smootherScale[i] * residual;
            r.col(i) = residual;
            next.col(i) = change;
            x.col(i) += change;
          });
      });
    level.step.swap(level.nextStep);
    rho = nextRho;
  }
}

void Multigrid::SolveCoarsest(
  const PackedPoints<float>& rightHandSide, PackedPoints<float>& solution) const
{
  const Eigen::MatrixXd b = rightHandSide.matrix().transpose().cast<double>();
  solution = this->Coarsest.solve(b).transpose().cast<float>().array();
}
}
