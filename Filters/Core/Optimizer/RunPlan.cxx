// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Optimizer/RunPlan.h"

#include "Core/Base/Threading.h"
#include "Core/Optimizer/VolumePreservation.h"

#include <algorithm>

namespace lmo
{
void AddSolution(const Solution& solution, double tolerance, ModeResult& result)
{
  result.iterations += solution.iterations;
  result.relativeResidual = std::max(result.relativeResidual, solution.relativeResidual);
  result.isConverged = result.relativeResidual <= tolerance;
}

bool HaveSameTriangles(const MeshQuantities& a, const MeshQuantities& b)
{
  return a.GetPoints().rows() == b.GetPoints().rows() &&
         a.GetTriangles().rows() == b.GetTriangles().rows() && a.GetTriangles() == b.GetTriangles();
}

const Points& StartOf(const MeshQuantities& mesh, const RunPlan& plan)
{
  return plan.start.rows() > 0 ? plan.start : mesh.GetPoints();
}

Points MoveVertices(const MeshQuantities& mesh, const RunPlan& plan, const Points& displacement)
{
  const Points& start = StartOf(mesh, plan);
  Points positions(start.rows(), 3);
  ParallelFor(static_cast<Index>(start.rows()),
    [&](Index i) { positions.row(i) = start.row(i) + displacement.row(i); });
  ProjectOntoLines(mesh, plan, positions);
  return positions;
}

void ProjectOntoLines(const MeshQuantities& mesh, const RunPlan& plan, Points& positions)
{
  if (plan.lines)
  {
    mesh.GetSubdomain().ProjectOntoLines(*plan.lines, mesh.GetPoints(), positions);
    mesh.GetSubdomain().UpdateGhosts(positions);
  }
}

void RestoreVolumes(const MeshQuantities& mesh, const RunPlan& plan, ModeResult& result)
{
  result.unpreservedVolumes = plan.regions.open;
  if (plan.regions.count > 0)
  {
    result.unpreservedVolumes += RestoreVolumes(mesh.GetPoints(), mesh.GetTriangles(),
      mesh.GetTopology(), plan.regions, plan.problem.constraints, result.positions);
  }
}
}
