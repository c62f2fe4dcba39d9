// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Optimizer/CurveSmoothing.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lmo
{
namespace
{
constexpr double ShortestEdge = 0.05; ///< relative to the mean; shorter ones count as that long
constexpr int StairEdges = 3; ///< on both sides of a vertex, over which a line's turn is seen

/// The vertex \a edges further from vertex i over its neighbour j, or where the line ends before.
Index Follow(const AdjacencyLists& lines, Index i, Index j, int edges)
{
  for (int edge = 1; edge < edges && lines.Size(j) == 2; ++edge)
  {
    const Index next = lines.Begin(j)[lines.Begin(j)[0] == i ? 1 : 0];
    i = j;
    j = next;
  }
  return j;
}

/// The vertices of curves that may move.
Mask MovingVertices(const MeshTopology& topology, const RunPlan& plan)
{
  Mask moves(topology.vertices, 0);
  if (plan.lines)
  {
    moves = VerticesOnCurves(topology, plan.options, *plan.lines);
    for (Index i = 0; i < topology.vertices; ++i)
    {
      moves[i] = moves[i] && plan.lines->pointClass[i] == FeatureLines::EDGE &&
                 plan.problem.constraints.freedom[i] != DisplacementConstraints::FIXED;
    }
  }
  return moves;
}

/// The lengths of the two edges at each vertex inside a line.
struct LineEdge
{
  double before;
  double after;

  LineEdge(const Points& V, Index i, Index previous, Index next)
    : before((V.row(i) - V.row(previous)).norm())
    , after((V.row(next) - V.row(i)).norm())
  {
  }

  double Mean() const { return (this->before + this->after) / 2; }
};

/// Mean length of the edges of curves.
double MeanLength(const MeshQuantities& mesh, const FeatureLines& lines, const Mask& isCurve)
{
  const Subdomain& subdomain = mesh.GetSubdomain();
  double sum = 0;
  double count = 0;
  ForEachLineVertex(lines,
    [&](Index i, Index previous, Index next)
    {
      if (isCurve[i] && subdomain.OwnsVertex(i))
      {
        sum += LineEdge(mesh.GetPoints(), i, previous, next).Mean();
        ++count;
      }
    });
  return subdomain.Sum(sum) / std::max(1.0, subdomain.Sum(count));
}

/// The problem of the curves alone.
LeastSquaresProblem SetUpCurves(
  const MeshQuantities& mesh, const RunPlan& plan, const Mask& isCurve)
{
  const Points& V = mesh.GetPoints();
  const LeastSquaresProblem& surface = plan.problem;
  const double length = MeanLength(mesh, *plan.lines, isCurve);
  LeastSquaresProblem problem;
  problem.laplacian.L = surface.laplacian.L;
  problem.laplacian.weights = Vector::Zero(surface.Size());
  problem.laplacian.target = std::make_shared<const Points>(Points::Zero(surface.Size(), 3));
  problem.position = surface.position;
  problem.constraints.freedom.assign(isCurve.size(), DisplacementConstraints::FIXED);
  problem.constraints.freeAxes = surface.constraints.freeAxes;
  std::vector<PolylineRow> rows;
  ForEachLineVertex(*plan.lines,
    [&](Index i, Index previous, Index next)
    {
      if (isCurve[i])
      {
        const LineEdge edge(V, i, previous, next);
        const double least = ShortestEdge * length;
        const double before = std::max(edge.before, least) / length;
        const double after = std::max(edge.after, least) / length;
        const double share = std::sqrt((before + after) / 2); // of the line's length
        PolylineRow row{ i, previous, next, share * surface.laplacian.weights[i] / (before * after),
          Vector3::Zero(), after / (before + after) };
        row.target = -row.Apply(V);
        rows.push_back(row);
        problem.position.weights[i] *= share;
        problem.constraints.freedom[i] = DisplacementConstraints::FREE;
      }
    });
  problem.polylines = PolylineTerm(std::move(rows), surface.Size());
  return problem;
}

/// Fixes the curves' vertices in the problem of the surface, whose c = f - L V becomes f - L start.
void FixCurves(const Points& displacement, const Mask& isCurve, RunPlan& plan)
{
  LeastSquaresProblem& problem = plan.problem;
  problem.laplacian.target = std::make_shared<const Points>(
    *problem.laplacian.target - Apply(problem.laplacian.L, displacement));
  for (std::size_t i = 0; i < isCurve.size(); ++i)
  {
    if (isCurve[i])
    {
      problem.constraints.freedom[i] = DisplacementConstraints::FIXED;
      plan.lines->pointClass[i] = FeatureLines::CORNER;
    }
  }
  std::vector<PolylineRow> rows = std::move(problem.polylines.rows);
  rows.erase(std::remove_if(rows.begin(), rows.end(),
               [&](const PolylineRow& row) { return isCurve[row.vertex] != 0; }),
    rows.end());
  problem.polylines = PolylineTerm(std::move(rows), problem.Size());
}
}

Mask VerticesOnCurves(
  const MeshTopology& topology, const OptimizerOptions& options, const FeatureLines& lines)
{
  const bool isSmoothing = options.mode == Mode::SMOOTH || options.mode == Mode::SMOOTH_GUIDED;
  const bool hasCurves = options.boundaryCondition == BoundaryCondition::CURVE;
  Mask isOnCurve(topology.vertices, 0);
  for (Index i = 0; i < topology.vertices && isSmoothing; ++i)
  {
    isOnCurve[i] =
      lines.lines->Size(i) == 2 && (topology.isBoundary[i] ? hasCurves : options.featureSmoothing);
  }
  return isOnCurve;
}

void SmoothStairs(const Points& V, const Mask& isOnCurve, FeatureLines& lines)
{
  for (Index i = 0; i < static_cast<Index>(isOnCurve.size()); ++i)
  {
    if (isOnCurve[i] && lines.pointClass[i] == FeatureLines::CORNER)
    {
      const Index* ends = lines.lines->Begin(i);
      const Index previous = Follow(*lines.lines, i, ends[0], StairEdges);
      const Index next = Follow(*lines.lines, i, ends[1], StairEdges);
      if (IsSmoothTurn(V, previous, i, next))
      {
        lines.pointClass[i] = FeatureLines::EDGE;
        lines.tangents.row(i) = (V.row(next) - V.row(previous)).stableNormalized();
      }
    }
  }
}

void SmoothCurves(const MeshQuantities& mesh, RunPlan& plan, ProgressMonitor& monitor)
{
  const Mask isCurve = MovingVertices(mesh.GetTopology(), plan);
  const bool hasCurves = std::find(isCurve.begin(), isCurve.end(), 1) != isCurve.end();
  if (!(mesh.GetSubdomain().Maximum(hasCurves) > 0))
  {
    return;
  }
  monitor.Begin("Smoothing lines");
  const Points displacement = plan
                                .solve(SetUpCurves(mesh, plan, isCurve), plan.options.solverType,
                                  plan.options.solver, monitor)
                                .displacement;
  plan.start = mesh.GetPoints() + displacement;
  FixCurves(displacement, isCurve, plan);
}
}
