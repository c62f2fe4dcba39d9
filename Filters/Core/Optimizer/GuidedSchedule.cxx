// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Optimizer/GuidedSchedule.h"

#include "Core/Deviation/ShapeRestoration.h"
#include "Core/Operators/NormalFilter.h"
#include "Core/Optimizer/EnclosedRegions.h"
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
constexpr double LargestLoss = 0.05;    ///< of a component's volume, that removing noise costs

/// Solves for the positions that follow the filtered normals of the result so far.
Solution Follow(const MeshQuantities& mesh, const RunPlan& plan, Points normals,
  const Points& positions, const SolverOptions& solver, ProgressMonitor& monitor)
{
  const Points& start = StartOf(mesh, plan);
  return FollowNormals(start, mesh.GetTriangles(), mesh.GetTopology(), std::move(normals),
    plan.problem.laplacian.L, plan.problem.constraints, plan.options.guide.detailWeight,
    positions - start, solver, monitor);
}

/// Filters the normals of the positions and moves the vertices after them, in rounds.
void FollowInRounds(
  const MeshQuantities& mesh, const RunPlan& plan, ProgressMonitor& monitor, ModeResult& result)
{
  const GuideOptions& guide = plan.options.guide;
  SolverOptions solver = plan.options.solver;
  const int iterations = guide.normalIterations / 2 + guide.normalIterations % 2;
  const double share = 1.0 / Rounds; // of the time
  for (int round = 0; round < Rounds; ++round)
  {
    const bool isLast = round == Rounds - 1;
    solver.tolerance = isLast ? plan.options.solver.tolerance
                              : std::max(RoughTolerance, plan.options.solver.tolerance);
    PartialMonitor filtering(monitor, round * share, (round + 0.3) * share);
    filtering.Begin("Filtering normals");
    Points normals = FilterNormals(result.positions, mesh.GetTriangles(), mesh.GetTopology(),
      iterations, (round == 0 ? 1 : LaterWidth) * guide.normalWidth, filtering);
    PartialMonitor following(monitor, (round + 0.3) * share, (round + 1) * share);
    following.Begin("Following normals");
    const Solution solution =
      Follow(mesh, plan, std::move(normals), result.positions, solver, following);
    result.relativeResidual = 0; // the last one counts
    AddSolution(solution, solver.tolerance, result);
    result.positions = StartOf(mesh, plan) + solution.displacement;
  }
}

/// For each component whether it lost too much of its volume.
Mask FindShrunk(const MeshQuantities& mesh, const Points& positions)
{
  const Triangles& T = mesh.GetTriangles();
  const std::vector<Index>& component = mesh.GetComponents();
  const EnclosedRegions regions = FindEnclosedRegions(T, component);
  const RegionVolumes before = MeasureVolumes(mesh.GetPoints(), T, regions);
  const RegionVolumes after = MeasureVolumes(positions, T, regions);
  Mask isShrunk(component.size(), false);
  for (Index t = 0; t < static_cast<Index>(T.rows()); ++t)
  {
    const Index region = regions.sides.row(t).maxCoeff();
    isShrunk[component[T(t, 0)]] = region != EnclosedRegions::None &&
                                   before.IsSignificant(region) &&
                                   1 - after.volume[region] / before.volume[region] > LargestLoss;
  }
  return isShrunk;
}

/// Replaces the positions in the components that are chosen.
void Replace(const MeshQuantities& mesh, const Mask& isChosen, const Points& by, Points& positions)
{
  ParallelFor(static_cast<Index>(positions.rows()), [&](Index i)
    { positions.row(i) = (isChosen[mesh.GetComponents()[i]] ? by : positions).row(i); });
}

/// Smoothing takes what is as small as the triangles: where that is the shape, tries without it,
/// and takes back what is lost all the same.
/// \param monitor of the second attempt
void KeepShapes(
  const MeshQuantities& mesh, const RunPlan& plan, ProgressMonitor& monitor, ModeResult& result)
{
  const Points& start = StartOf(mesh, plan);
  const ShapeRestoration shapes(
    start, mesh.GetTriangles(), mesh.GetTopology(), mesh.GetComponents());
  const auto isAny = [](const Mask& mask)
  { return std::find(mask.begin(), mask.end(), true) != mask.end(); };

  Mask isLost = FindShrunk(mesh, result.positions);
  const Mask isTurned = shapes.FindTurned(result.positions);
  std::transform(isTurned.begin(), isTurned.end(), isLost.begin(), isLost.begin(),
    [](bool a, bool b) { return a || b; });
  if (isAny(isLost))
  {
    ModeResult second;
    second.positions = start;
    FollowInRounds(mesh, plan, monitor, second);
    Replace(mesh, isLost, second.positions, result.positions);
    shapes.Restore(shapes.FindTurned(result.positions), result.positions);
    isLost = FindShrunk(mesh, result.positions);
    Replace(mesh, isLost, start, result.positions);
    result.unmovedComponents = std::count(isLost.begin(), isLost.end(), true);
  }
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
  const SolverOptions& solver = plan.options.solver;
  const double share = 1.0 / (Rounds + 1); // of the time
  ModeResult result;
  PartialMonitor first(monitor, 0, share);
  first.Begin("Solving");
  const Solution smoothing = plan.solve(plan.problem, SolverType::AUTOMATIC, solver, first);
  AddSolution(smoothing, solver.tolerance, result);
  result.positions = MoveVertices(mesh, plan, smoothing.displacement);
  PartialMonitor rounds(monitor, share, 1);
  FollowInRounds(mesh, plan, rounds, result);
  PartialMonitor again(monitor, 1, 1);
  KeepShapes(mesh, plan, again, result);
  ProjectOntoLines(mesh, plan, result.positions);
  RestoreVolumes(mesh, plan, result);
  result.positionWeights = std::move(plan.problem.position.weights);
  result.laplacianWeights = std::move(plan.problem.laplacian.weights);
  return result;
}
}
