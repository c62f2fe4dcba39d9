// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_LeastSquaresProblem_txx
#define lmo_LeastSquaresProblem_txx

#include "Core/Base/Threading.h"

#include <cmath>

namespace lmo
{
template <typename Store>
double ComputeResidual(const LeastSquaresProblem& problem, const Points& d, const Store& store)
{
  const Points y = WeightedRows(problem, d);
  const Points lineForces = LineForces(problem, d);
  return std::sqrt(ParallelSum(problem.Size(), 0.0,
    [&, store = store](double& sum, Index i) mutable
    {
      Vector3 residual = PositionForce(problem, d, i) - StiffnessRow(problem.laplacian.L, y, i);
      if (lineForces.rows() > 0)
      {
        residual += lineForces.row(i);
      }
      residual = problem.motion.Project(i, residual);
      store(i, residual);
      sum += residual.squaredNorm();
    }));
}
}

#endif
