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
Multigrid::Matrix ShiftedStiffness(const LeastSquaresProblem& problem, const Vector& Q)
{
  const Laplacian& L = problem.L;
  const AdjacencyLists& rings = *L.rings;
  const auto isFixed = [&](Index i)
  { return problem.motion.freedom[i] == MotionConstraints::FIXED; };
  Multigrid::Matrix matrix(problem.Size(), problem.Size());
  Eigen::VectorXi sizes(problem.Size());
  ParallelFor(problem.Size(), [&](Index i) { sizes[i] = rings.Size(i) + 1; });
  matrix.reserve(sizes);
  for (Index i = 0; i < problem.Size(); ++i)
  {
    if (isFixed(i))
    {
      matrix.insert(i, i) = 1;
      continue;
    }
    double sum = 0;
    bool isDiagonalDone = false;
    float* diagonal = nullptr;
    for (Index k = rings.offsets[i]; k < rings.offsets[i + 1]; ++k)
    {
      const Index j = rings.ids[k];
      const double weight = L.edgeWeights ? std::max((*L.edgeWeights)[k], getenv("CLIP")?0.0:-1e30) : 1.0;
      sum += weight;
      if (!isDiagonalDone && j > i)
      {
        diagonal = &matrix.insert(i, i);
        isDiagonalDone = true;
      }
      if (!isFixed(j))
      {
        matrix.insert(i, j) = static_cast<float>(-weight);
      }
    }
    if (!isDiagonalDone)
    {
      diagonal = &matrix.insert(i, i);
    }
    const double r = problem.positionWeights[i] / std::sqrt(Q[i]);
    *diagonal = static_cast<float>(sum > 0 ? std::max(r, SmallestRelativeR * sum) + sum : 1);
  }
  matrix.makeCompressed();
  return matrix;
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
  ParallelFor(this->Problem.Size(),
    [&](Index i) { this->Result.col(i) *= this->InverseQ[i]; });
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
