// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Optimizer/SingleSolve.h"

namespace lmo
{
namespace
{
/// S (2 I - S) V instead of the solution S V of smoothing with f = 0, where d = S V - V: the same
/// system on what was smoothed away.
void SmoothTwice(LeastSquaresProblem& problem, const Points& d)
{
  problem.laplacian.target = std::make_shared<const Points>(Apply(problem.laplacian.L, d));
  for (PolylineRow& row : problem.polylines.rows)
  {
    const Vector3 tangent = problem.constraints.axes.row(row.vertex);
    const Vector3 laplacian = 0.5 * (d.row(row.previous) + d.row(row.next)) - d.row(row.vertex);
    row.target = laplacian.dot(tangent) * tangent;
  }
}
}

ModeResult SolveOnce(const MeshQuantities& mesh, RunPlan& plan, ProgressMonitor& monitor)
{
  const OptimizerOptions& options = plan.options;
  LeastSquaresProblem& problem = plan.problem;
  ModeResult result;
  monitor.Begin("Solving");
  Solution solution = plan.solve(problem, options.solverType, options.solver, monitor);
  AddSolution(solution, options.solver.tolerance, result);
  if (options.twicing && options.mode == Mode::SMOOTH)
  {
    SmoothTwice(problem, solution.displacement);
    solution = plan.solve(problem, options.solverType, options.solver, monitor);
    AddSolution(solution, options.solver.tolerance, result);
  }
  result.positions = MoveVertices(mesh, plan, solution.displacement);
  RestoreVolumes(mesh, plan, result);
  result.positionWeights = std::move(problem.position.weights);
  result.laplacianWeights = std::move(problem.laplacian.weights);
  return result;
}
}
