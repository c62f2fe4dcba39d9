// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_RunPlan_h
#define lmo_RunPlan_h

#include "Core/Deviation/ReferenceSurface.h"
#include "Core/Deviation/SelfIntersections.h"
#include "Core/LeastSquares/LeastSquaresProblem.h"
#include "Core/Mesh/FeatureLines.h"
#include "Core/Operators/CotangentWeights.h"
#include "Core/Optimizer/EnclosedRegions.h"
#include "Core/Optimizer/OptimizerOptions.h"
#include "Core/Optimizer/ResultReview.h"

#include <functional>

namespace lmo
{
/// Solves a problem as Solve() does.
using ProblemSolver = std::function<Solution(
  const LeastSquaresProblem&, SolverType, const SolverOptions&, ProgressMonitor&)>;

/// A run of the Optimizer: what MakePlan() finds out once from options and arrays.
struct RunPlan
{
  OptimizerOptions options;
  std::shared_ptr<const CotangentWeights> weights; ///< those of L; null if it is L_u
  std::optional<Vector> featureClass; ///< FeatureLines::Class of each vertex; none without features
  std::optional<FeatureLines> lines;  ///< along which vertices slide
  Points start; ///< V with smoothed curves, which \a problem starts from; no rows if that is V
  EnclosedRegions regions; ///< whose volumes are preserved; none if that is not wanted
  VertexFreedom freedom;
  std::shared_ptr<const MeshQuantities> reference; ///< to stay near; null: the mesh as it is
  std::shared_ptr<const EarlierStep> earlier;      ///< to start from; null: from the mesh as it is
  PartOfSurface part;                              ///< for OPTIMIZE_WITHIN_DEVIATION of a part
  LeastSquaresProblem problem; ///< the first one that the mode solves, with the constraints
  ProblemSolver solve;
};

/// What Mode::OPTIMIZE_WITHIN_DEVIATION did.
struct DeviationReport
{
  Index passes = 0;         ///< that moved the surface
  Index rolledBack = 0;     ///< vertices that the last pass moved less than its solution
  double bound = 0;         ///< the Hausdorff distance of result and reference is at most that
  double relativeBound = 0; ///< the same, divided by the diagonal of the bounding box
  double gain = 0;          ///< EarlierStep::gain for the next step
  Index pinnedBad = 0;      ///< bad triangles of which no corner may move
  Index beyond = 0; ///< triangles of mesh and reference that began farther away than allowed
};

/// What a mode returns.
struct ModeResult
{
  Points positions; ///< V'
  Vector positionWeights;
  Vector laplacianWeights;
  Index iterations = 0; ///< of conjugate gradients, over all solutions
  double relativeResidual = 0;
  bool isConverged = true; ///< the residual is within the tolerance
  DeviationReport deviation;
  IntersectionReport intersections;
  Index unpreservedVolumes = 0; ///< components or labels that enclose no volume to preserve
  Index unmovedComponents = 0;  ///< that SMOOTH_GUIDED would have shrunk
  bool isCancelled = false;     ///< the monitor asked to stop, and this is what there was by then
};

/// Adds a solution to the result: its iterations, and its residual if that is the largest.
void AddSolution(const Solution& solution, double tolerance, ModeResult& result);

/// True if two meshes differ in their positions at most: one may be a result of the other.
bool HaveSameTriangles(const MeshQuantities& a, const MeshQuantities& b);

/// Where the displacements of the plan's problem start.
const Points& StartOf(const MeshQuantities& mesh, const RunPlan& plan);

/// The start + d, with the vertices on lines at the closest points of these.
Points MoveVertices(const MeshQuantities& mesh, const RunPlan& plan, const Points& displacement);

/// Moves vertices on lines to the closest points of these.
void ProjectOntoLines(const MeshQuantities& mesh, const RunPlan& plan, Points& positions);

/// Gives the plan's regions their volumes back.
/// \throw SolverError if that is not possible.
void RestoreVolumes(const MeshQuantities& mesh, const RunPlan& plan, ModeResult& result);
}

#endif
