// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LinearSolver.h"

#include "ConjugateGradient.h"
#include "DirectSolver.h"

namespace lmo
{
namespace
{
/// Takes the direct solution if it is closer; keeps what there is if the matrix is singular.
void ImproveDirectly(const NormalEquations& equations, const Points& b, Solution& solution)
{
  try
  {
    Solution direct;
    direct.displacement = SolveDirectly(equations, b);
    direct.relativeResidual = RelativeResidual(equations, b, direct.displacement);
    direct.iterations = solution.iterations;
    if (direct.relativeResidual < solution.relativeResidual)
    {
      solution = std::move(direct);
    }
  }
  catch (const SolverError&)
  {
    // The caller sees the residual of the iterative solution.
  }
}
}

Solution Solve(
  const NormalEquations& equations, SolverType type, const SolverOptions& options, Monitor& monitor)
{
  const Points b = equations.RightHandSide();
  Solution solution;
  if (!(Norm(b) > 0))
  {
    solution.displacement = Points::Zero(b.rows(), 3);
    return solution;
  }
  if (type == SolverType::DIRECT)
  {
    monitor.Report(0);
    solution.displacement = SolveDirectly(equations, b);
    solution.relativeResidual = RelativeResidual(equations, b, solution.displacement);
    return solution;
  }
  solution = SolveIteratively(equations, b, JacobiPreconditioner(equations), options, monitor);
  if (type == SolverType::AUTOMATIC && solution.relativeResidual > options.tolerance)
  {
    ImproveDirectly(equations, b, solution);
  }
  return solution;
}

double RelativeResidual(const NormalEquations& equations, const Points& b, const Points& d)
{
  Points residual(b.rows(), 3);
  equations.Apply(d, residual);
  residual = b - residual;
  const double norm = Norm(b);
  return norm > 0 ? Norm(residual) / norm : 0;
}
}
