// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Optimizer/GuidedSchedule.h"

#include "Core/Operators/NormalFilter.h"
#include "Core/Optimizer/GuidedSmoothing.h"

#include <algorithm>
#include <utility>

namespace lmo
{
namespace
{
constexpr double FirstScaleFactor = 0.75; ///< of the smoothing that the first normals come from
constexpr int Rounds = 3;                 ///< in which normals are filtered and followed
constexpr double LaterWidth = 0.4;      ///< factor of NormalWidth after the first round: less noise
constexpr double RoughTolerance = 1e-3; ///< of solutions that only lead to the next normals

/// Solves for the positions that follow the filtered normals of the result so far.
Solution Follow(const MeshQuantities& mesh, const RunPlan& plan, Points normals,
  const Points& positions, const SolverOptions& solver, ProgressMonitor& monitor)
{
  const Points& start = StartOf(mesh, plan);
  return FollowNormals(start, mesh.GetTriangles(), mesh.GetTopology(), std::move(normals),
    plan.problem.laplacian.L, plan.problem.constraints, plan.options.guide.detailWeight,
    positions - start, solver, monitor);
}
}

OptimizerOptions FirstSmoothing(const OptimizerOptions& options)
{
  OptimizerOptions smoothing;
  smoothing.mode = Mode::SMOOTH;
  smoothing.positionWeighting = PositionWeighting::CONSTANT;
  smoothing.scaleFactor = getenv("FS") ? atof(getenv("FS")) : FirstScaleFactor;
  smoothing.boundaryCondition = options.boundaryCondition;
  smoothing.freeAxes = options.freeAxes;
  smoothing.solver = options.solver;
  return smoothing;
}

ModeResult SmoothGuided(const MeshQuantities& mesh, RunPlan& plan, ProgressMonitor& monitor)
{
  const GuideOptions& guide = plan.options.guide;
  SolverOptions solver = plan.options.solver;
  const double share = 1.0 / (Rounds + 1); // of the time
  ModeResult result;
  PartialMonitor first(monitor, 0, share);
  first.Begin("Solving");
  const Solution smoothing = plan.solve(plan.problem, SolverType::AUTOMATIC, solver, first);
  AddSolution(smoothing, solver.tolerance, result);
  result.positions = MoveVertices(mesh, plan, smoothing.displacement);

  const int iterations = guide.normalIterations / 2 + guide.normalIterations % 2;
  for (int round = 1; round <= Rounds; ++round)
  {
    const bool isLast = round == Rounds;
    solver.tolerance = isLast ? plan.options.solver.tolerance
                              : std::max(RoughTolerance, plan.options.solver.tolerance);
    PartialMonitor filtering(monitor, round * share, (round + 0.3) * share);
    filtering.Begin("Filtering normals");
    Points normals = FilterNormals(result.positions, mesh.GetTriangles(), mesh.GetTopology(),
      iterations, (round == 1 ? 1 : LaterWidth) * guide.normalWidth, filtering);
    PartialMonitor following(monitor, (round + 0.3) * share, (round + 1) * share);
    following.Begin("Following normals");
    const Solution solution =
      Follow(mesh, plan, std::move(normals), result.positions, solver, following);
    result.relativeResidual = 0; // the last one counts
    AddSolution(solution, solver.tolerance, result);
    result.positions = StartOf(mesh, plan) + solution.displacement;
  }
  ProjectOntoLines(mesh, plan, result.positions);
  RestoreVolumes(mesh, plan, result);
  result.positionWeights = std::move(plan.problem.position.weights);
  result.laplacianWeights = std::move(plan.problem.laplacian.weights);
  return result;
}
}
