// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Multigrid.h"

#include "Parallel.h"

#include <algorithm>
#include <cmath>

namespace lmo
{
namespace
{
using Row = PackedRow<float>;

constexpr Index CoarsestSize = 400;
constexpr float StrongConnection = 0.08f; ///< relative to the geometric mean of the diagonals
constexpr int SmootherDegree = 2;
constexpr float SmoothedShare = 4; ///< the smoother acts on eigenvalues above the largest / this

Row MultiplySparseRow(const SparseRows& A, const PackedPoints<float>& x, Index i)
{
  Row sum = Row::Zero();
  for (Index k = A.outerIndexPtr()[i]; k < A.outerIndexPtr()[i + 1]; ++k)
  {
    sum += A.valuePtr()[k] * x.col(A.innerIndexPtr()[k]);
  }
  return sum;
}

/// K + R without the fixed vertices, which have a row of the identity.
SparseRows FineMatrix(const Laplacian& L, const Multigrid::Values& shift, const Mask& isFixed)
{
  const AdjacencyLists& rings = *L.rings;
  const auto size = static_cast<Index>(shift.size());
  return MakeSparseRows(size, size,
    [&](Index i, const auto& add)
    {
      if (isFixed[i])
      {
        add(i, 1);
        return;
      }
      add(i, static_cast<float>(shift[i] + WeightSum(L, i)));
      for (Index k = rings.offsets[i]; k < rings.offsets[i + 1]; ++k)
      {
        if (!isFixed[rings.ids[k]])
        {
          add(rings.ids[k], static_cast<float>(L.edgeWeights ? -(*L.edgeWeights)[k] : -1.0));
        }
      }
    });
}

/// Gershgorin bound of the largest eigenvalue of D^-1 A.
float LargestEigenvalueBound(const SparseRows& A)
{
  float bound = 0;
  for (Index i = 0; i < A.rows(); ++i)
  {
    float sum = 0;
    float diagonal = 1;
    for (SparseRows::InnerIterator entry(A, i); entry; ++entry)
    {
      sum += std::abs(entry.value());
      diagonal = entry.col() == i ? entry.value() : diagonal;
    }
    bound = std::max(bound, sum / diagonal);
  }
  return bound;
}

/// Groups strongly connected unknowns.
/// \return aggregate of each unknown, -1 for an unknown without strong connections: the smoother
/// alone solves for it
std::vector<Index> Aggregate(const SparseRows& A, Index& aggregates)
{
  constexpr Index undecided = -2;
  const auto size = static_cast<Index>(A.rows());
  const Eigen::ArrayXf diagonal = A.diagonal();
  const auto isStrong = [&](Index i, Index j, float value)
  {
    return i != j &&
           value * value > StrongConnection * StrongConnection * diagonal[i] * diagonal[j];
  };
  std::vector<Index> aggregate(size, undecided);
  aggregates = 0;
  for (Index i = 0; i < size; ++i)
  {
    bool isConnected = false;
    bool isNeighbourhoodFree = aggregate[i] == undecided;
    for (SparseRows::InnerIterator entry(A, i); entry && isNeighbourhoodFree; ++entry)
    {
      if (isStrong(i, entry.col(), entry.value()))
      {
        isConnected = true;
        isNeighbourhoodFree = aggregate[entry.col()] < 0;
      }
    }
    if (!isNeighbourhoodFree)
    {
      continue;
    }
    aggregate[i] = isConnected ? aggregates : -1;
    for (SparseRows::InnerIterator entry(A, i); entry && isConnected; ++entry)
    {
      if (isStrong(i, entry.col(), entry.value()))
      {
        aggregate[entry.col()] = aggregates;
      }
    }
    aggregates += isConnected;
  }
  // The others join the aggregate of their strongest neighbour that has one.
  std::vector<Index> joined = aggregate;
  for (Index i = 0; i < size; ++i)
  {
    float strongest = 0;
    for (SparseRows::InnerIterator entry(A, i); entry && aggregate[i] == undecided; ++entry)
    {
      if (isStrong(i, entry.col(), entry.value()) && aggregate[entry.col()] >= 0 &&
          std::abs(entry.value()) > strongest)
      {
        strongest = std::abs(entry.value());
        joined[i] = aggregate[entry.col()];
      }
    }
    if (joined[i] == undecided)
    {
      joined[i] = aggregates++;
    }
  }
  return joined;
}

/// (I - 4 / (3 lambda) D^-1 A) times the piecewise constant prolongation.
SparseRows SmoothedProlongation(const SparseRows& A, const Eigen::ArrayXf& damping)
{
  Index aggregates = 0;
  const std::vector<Index> aggregate = Aggregate(A, aggregates);
  return MakeSparseRows(static_cast<Index>(A.rows()), aggregates,
    [&](Index i, const auto& add)
    {
      if (aggregate[i] >= 0)
      {
        add(aggregate[i], 1);
      }
      for (SparseRows::InnerIterator entry(A, i); entry; ++entry)
      {
        if (aggregate[entry.col()] >= 0)
        {
          add(aggregate[entry.col()], -damping[i] * entry.value());
        }
      }
    });
}
}

Multigrid::Multigrid(
  const PackedStiffness<float>& K, const Laplacian& L, Values shift, const Mask& isFixed)
  : K(K)
  , Shift(std::move(shift))
{
  this->BuildLevels(FineMatrix(L, this->Shift, isFixed));
  this->Levels[0].A.resize(0, 0);
  this->Levels[0].A.data().squeeze();
  for (std::size_t i = 0; i < isFixed.size(); ++i)
  {
    this->Levels[0].inverseDiagonal[i] *= !isFixed[i];
  }
}

void Multigrid::BuildLevels(SparseRows matrix)
{
  while (true)
  {
    this->Levels.emplace_back();
    Level& level = this->Levels.back();
    level.A = std::move(matrix);
    level.inverseDiagonal = 1 / Values(level.A.diagonal().array());
    level.largestEigenvalue = LargestEigenvalueBound(level.A);
    const auto size = static_cast<Index>(level.A.rows());
    level.residual.resize(4, size);
    level.step.resize(4, size);
    level.nextStep.resize(4, size);
    if (size <= CoarsestSize)
    {
      break;
    }
    level.prolongation =
      SmoothedProlongation(level.A, 4 / (3 * level.largestEigenvalue) * level.inverseDiagonal);
    const auto coarseSize = static_cast<Index>(level.prolongation.cols());
    if (coarseSize == 0 || coarseSize > 0.8 * size)
    {
      level.prolongation.resize(0, 0);
      break;
    }
    level.restriction = level.prolongation.transpose();
    matrix = Multiply(level.restriction, Multiply(level.A, level.prolongation));
    level.coarseRightHandSide.resize(4, coarseSize);
    level.coarseSolution.resize(4, coarseSize);
  }
  this->Coarsest.compute(this->Levels.back().A.cast<double>());
}

void Multigrid::Cycle(const PackedPoints<float>& rightHandSide, PackedPoints<float>& solution)
{
  this->CycleFrom(0, rightHandSide, solution);
}

void Multigrid::CycleFrom(
  std::size_t index, const PackedPoints<float>& rightHandSide, PackedPoints<float>& solution)
{
  if (index + 1 == this->Levels.size())
  {
    this->SolveCoarsest(rightHandSide, solution);
  }
  else if (index > 0)
  {
    const SparseRows& A = this->Levels[index].A;
    this->CycleWith(
      index, [&A](const PackedPoints<float>& x, Index i) { return MultiplySparseRow(A, x, i); },
      rightHandSide, solution);
  }
  else if (this->K.IsWeighted())
  {
    this->CycleWith(
      index,
      [this](const PackedPoints<float>& x, Index i)
      { return Row(this->K.Row<true>(x, i) + this->Shift[i] * x.col(i)); },
      rightHandSide, solution);
  }
  else
  {
    this->CycleWith(
      index,
      [this](const PackedPoints<float>& x, Index i)
      { return Row(this->K.Row<false>(x, i) + this->Shift[i] * x.col(i)); },
      rightHandSide, solution);
  }
}

template <typename MultiplyRow>
void Multigrid::CycleWith(std::size_t index, const MultiplyRow& multiplyRow,
  const PackedPoints<float>& rightHandSide, PackedPoints<float>& solution)
{
  Level& level = this->Levels[index];
  const auto size = static_cast<Index>(level.inverseDiagonal.size());
  ParallelFor(size,
    [&](Index i)
    {
      solution.col(i).setZero();
      level.residual.col(i) = rightHandSide.col(i);
    });
  Smooth(level, multiplyRow, solution);
  ParallelFor(size, [&](Index i) { level.residual.col(i) -= multiplyRow(level.step, i); });
  ParallelFor(static_cast<Index>(level.restriction.rows()),
    [&](Index i) {
      level.coarseRightHandSide.col(i) = MultiplySparseRow(level.restriction, level.residual, i);
    });
  this->CycleFrom(index + 1, level.coarseRightHandSide, level.coarseSolution);
  ParallelFor(size, [&](Index i)
    { solution.col(i) += MultiplySparseRow(level.prolongation, level.coarseSolution, i); });
  ParallelFor(size,
    [&](Index i) { level.residual.col(i) = rightHandSide.col(i) - multiplyRow(solution, i); });
  Smooth(level, multiplyRow, solution);
}

template <typename MultiplyRow>
void Multigrid::Smooth(Level& level, const MultiplyRow& multiplyRow, PackedPoints<float>& solution)
{
  const float upper = level.largestEigenvalue;
  const float lower = upper / SmoothedShare;
  const float centre = (upper + lower) / 2;
  const float radius = (upper - lower) / 2;
  const auto size = static_cast<Index>(level.inverseDiagonal.size());
  ParallelFor(size,
    [&](Index i)
    {
      const Row step = level.inverseDiagonal[i] / centre * level.residual.col(i);
      level.step.col(i) = step;
      solution.col(i) += step;
    });
  float rho = radius / centre;
  for (int degree = 1; degree < SmootherDegree; ++degree)
  {
    const float nextRho = 1 / (2 * centre / radius - rho);
    ParallelFor(size,
      [&](Index i)
      {
        const Row residual = level.residual.col(i) - multiplyRow(level.step, i);
        const Row step = nextRho * rho * level.step.col(i) +
                         2 * nextRho / radius * level.inverseDiagonal[i] * residual;
        level.residual.col(i) = residual;
        level.nextStep.col(i) = step;
        solution.col(i) += step;
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
