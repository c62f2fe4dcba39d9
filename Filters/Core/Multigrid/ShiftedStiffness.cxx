// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Multigrid/ShiftedStiffness.h"

#include "Core/Base/Threading.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace lmo
{
namespace
{
constexpr double SmallestRelativeQ = 1e-12; ///< where a row is empty: relative to the largest
constexpr Index LargestRing = 1000;         ///< with more, products of matrices become dense
constexpr double SmallestRelativeR = 1e-6;  ///< where W_p = 0: relative to E

/// Mean of W_p^2 over a vertex and its one-ring.
double MeanSquaredWeight(const LeastSquaresProblem& problem, Index i)
{
  const AdjacencyLists& rings = *problem.laplacian.L.rings;
  const Vector& weights = problem.position.weights;
  const double sum = std::accumulate(rings.Begin(i), rings.End(i), weights[i] * weights[i],
    [&](double total, Index j) { return total + weights[j] * weights[j]; });
  return sum / (rings.Size(i) + 1);
}
}

ShiftedStiffness::ShiftedStiffness(const LeastSquaresProblem& problem,
  std::shared_ptr<const EllpackStiffness<float>> K,
  const std::shared_ptr<const Vector>& clampedEdgeWeights)
  : L{ problem.laplacian.L.rings,
    clampedEdgeWeights ? clampedEdgeWeights : problem.laplacian.L.edgeWeights, {} }
  , K(clampedEdgeWeights ? std::make_shared<const EllpackStiffness<float>>(L) : std::move(K))
  , shift(problem.Size())
  , diagonal(problem.Size())
  , inverseQ(problem.Size())
  , isLeftOut(problem.Size())
{
  Vector Q(problem.Size());
  ParallelFor(problem.Size(),
    [&](Index i)
    {
      const double sum = WeightSum(this->L, i);
      const double ratio = sum > 0 ? WeightSum(problem.laplacian.L, i) / sum : 1;
      Q[i] = ratio * ratio * problem.laplacian.RowWeight(i);
    });
  const double smallestQ = SmallestRelativeQ * (Q.size() > 0 ? Q.maxCoeff() : 1);
  ParallelFor(problem.Size(),
    [&](Index i)
    {
      const double q = std::max(Q[i], smallestQ);
      const double sum = WeightSum(this->L, i);
      const double least = sum > 0 ? SmallestRelativeR * sum : 1;
      this->isLeftOut[i] = problem.constraints.freedom[i] != DisplacementConstraints::FREE ||
                           problem.laplacian.L.rings->Size(i) > LargestRing;
      this->inverseQ[i] = static_cast<float>(this->isLeftOut[i] ? 0 : 1 / q);
      const double here = problem.position.weights[i] / std::sqrt(q);
      const double mean = std::sqrt(MeanSquaredWeight(problem, i) / q);
      this->shift[i] = static_cast<float>(std::max(std::min(mean, std::max(here, sum)), least));
      this->diagonal[i] = this->shift[i] + sum;
    });
}

bool ShiftedStiffness::HasPatternOf(const ShiftedStiffness& other) const
{
  return this->L.rings == other.L.rings && this->isLeftOut == other.isLeftOut;
}

bool ShiftedStiffness::IsEqualTo(const ShiftedStiffness& other) const
{
  return this->HasPatternOf(other) && this->L.edgeWeights == other.L.edgeWeights &&
         (this->shift == other.shift).all();
}
}
