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

/// K + R without the fixed vertices, which have a row of the identity.
SparseRows ShiftedStiffness(const LeastSquaresProblem& problem, const Vector& Q)
{
  const Laplacian& L = problem.L;
  const AdjacencyLists& rings = *L.rings;
  const auto isFixed = [&](Index i)
  { return problem.motion.freedom[i] == MotionConstraints::FIXED; };
  return MakeSparseRows(problem.Size(), problem.Size(),
    [&](Index i, const auto& add)
    {
      const double sum = WeightSum(L, i);
      if (isFixed(i) || !(sum > 0))
      {
        add(i, 1);
        return;
      }
      const double r = problem.positionWeights[i] / std::sqrt(Q[i]);
      add(i, static_cast<float>(std::max(r, SmallestRelativeR * sum) + sum));
      for (Index k = rings.offsets[i]; k < rings.offsets[i + 1]; ++k)
      {
        if (!isFixed(rings.ids[k]))
        {
          add(rings.ids[k], static_cast<float>(L.edgeWeights ? -(*L.edgeWeights)[k] : -1.0));
        }
      }
    });
}
}

SquaredPreconditioner::SquaredPreconditioner(const LeastSquaresProblem& problem)
  : Problem(problem)
  , InverseQ(PositiveRowWeights(problem).cwiseInverse().cast<float>().array())
  , Inverse(ShiftedStiffness(problem, PositiveRowWeights(problem)))
  , Intermediate(4, problem.Size())
  , Result(4, problem.Size())
{
}

void SquaredPreconditioner::Prepare(const PackedPoints<float>& residual)
{
  this->Inverse.Cycle(residual, this->Result);
  ParallelFor(this->Problem.Size(), [&](Index i) { this->Result.col(i) *= this->InverseQ[i]; });
  this->Inverse.Cycle(this->Result, this->Intermediate);
  ParallelFor(this->Problem.Size(),
    [&](Index i)
    {
      this->Result.col(i) = this->Problem.motion.freedom[i] == MotionConstraints::FIXED
                              ? PackedRow<float>(PackedRow<float>::Zero())
                              : PackedRow<float>(this->Intermediate.col(i));
    });
}
}
