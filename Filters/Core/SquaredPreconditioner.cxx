// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SquaredPreconditioner.h"

#include "Parallel.h"

#include <algorithm>
#include <cmath>

namespace lmo
{
namespace
{
constexpr double SmallestRelativeQ = 1e-6; ///< where a row is empty: relative to the largest
constexpr double SmallestRelativeR = 1e-6; ///< where W_p = 0: relative to E

/// Q with a positive value where a row of L is empty.
Vector PositiveRowWeights(const LeastSquaresProblem& problem)
{
  Vector Q(problem.Size());
  ParallelFor(problem.Size(), [&](Index i) { Q[i] = RowWeight(problem, i); });
  return Q.cwiseMax(SmallestRelativeQ * Q.maxCoeff());
}

Mask FixedVertices(const LeastSquaresProblem& problem)
{
  Mask isFixed(problem.Size());
  ParallelFor(problem.Size(),
    [&](Index i) { isFixed[i] = problem.motion.freedom[i] == MotionConstraints::FIXED; });
  return isFixed;
}

/// R = W_p / sqrt(Q), bounded from below so that K + R is not singular.
Multigrid::Values Shift(const LeastSquaresProblem& problem)
{
  const Vector Q = PositiveRowWeights(problem);
  Multigrid::Values shift(problem.Size());
  ParallelFor(problem.Size(),
    [&](Index i)
    {
      const double sum = WeightSum(problem.L, i);
      const double least = sum > 0 ? SmallestRelativeR * sum : 1;
      shift[i] = static_cast<float>(std::max(problem.positionWeights[i] / std::sqrt(Q[i]), least));
    });
  return shift;
}
}

SquaredPreconditioner::SquaredPreconditioner(
  const LeastSquaresProblem& problem, const PackedStiffness<float>& K)
  : Problem(problem)
  , InverseQ(PositiveRowWeights(problem).cwiseInverse().cast<float>().array())
  , Inverse(K, problem.L, Shift(problem), FixedVertices(problem))
  , Intermediate(4, problem.Size())
  , Result(4, problem.Size())
{
  ParallelFor(problem.Size(),
    [&](Index i) { this->InverseQ[i] *= problem.motion.freedom[i] != MotionConstraints::FIXED; });
}

void SquaredPreconditioner::Prepare(const PackedPoints<float>& residual)
{
  this->Inverse.Cycle(residual, this->Intermediate);
  ParallelFor(
    this->Problem.Size(), [&](Index i) { this->Intermediate.col(i) *= this->InverseQ[i]; });
  this->Inverse.Cycle(this->Intermediate, this->Result);
}
}
