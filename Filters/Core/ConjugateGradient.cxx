// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ConjugateGradient.h"

namespace lmo
{
Solution Start(const LeastSquaresProblem& problem)
{
  Solution solution;
  solution.displacement = Points::Zero(problem.Size(), 3);
  solution.residual.resize(problem.Size(), 3);
  solution.rightHandSideNorm = ComputeResidual(problem, Points(0, 3),
    [&](Index i, const Vector3& residual) { solution.residual.row(i) = residual; });
  solution.relativeResidual = solution.rightHandSideNorm > 0 ? 1 : 0;
  return solution;
}

void UpdateResidual(const LeastSquaresProblem& problem, Solution& solution)
{
  const double norm = ComputeResidual(problem, solution.displacement,
    [&](Index i, const Vector3& residual) { solution.residual.row(i) = residual; });
  solution.relativeResidual = norm / solution.rightHandSideNorm;
}
}
