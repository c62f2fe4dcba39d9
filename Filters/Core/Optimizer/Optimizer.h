// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_Optimizer_h
#define lmo_Optimizer_h

#include "Core/Deviation/SurfaceComparison.h"
#include "Core/Mesh/VertexOrder.h"
#include "Core/Operators/CotangentQuantities.h"
#include "Core/Optimizer/DeviationOptimizer.h"
#include "Core/Optimizer/OptimizerOptions.h"
#include "Core/Optimizer/ResultReview.h"
#include "Core/Solvers/PreconditionerCache.h"

#include <functional>

namespace lmo
{
struct OptimizerResult
{
  Points positions;      ///< V'
  Points displacements;  ///< V' - V
  Vector meanCurvatures; ///< kappa of the input
  Vector positionWeights;
  Vector laplacianWeights;
  Points normals; ///< vertex normals of the result, 0 where undefined; no rows if not asked for
  SurfaceComparison comparison; ///< of the input and the result
  VolumeLoss volumeLoss;        ///< of the smoothing modes
  VertexFreedom freedom;
  Index iterations = 0;
  double relativeResidual = 0;
  bool isConverged = true; ///< the residual is within the tolerance
  Vector featureClass;     ///< FeatureLines::Class of each vertex; no rows without features
  DeviationReport deviation;
  bool isCancelled = false; ///< the monitor asked to stop, and this is what there was by then
};

/// Solves a problem as Solve() does.
using ProblemSolver = std::function<Solution(
  const LeastSquaresProblem&, SolverType, const SolverOptions&, ProgressMonitor&)>;

/// Laplacian mesh optimization of one mesh, any number of times: what depends on the mesh alone is
/// computed once, when it is first needed.
class Optimizer
{
public:
  /// \param triangles ids below the number of rows of \a V
  Optimizer(Points V, Triangles triangles);

  /// For a part of a mesh that is distributed over processes. Results are right where the vertex is
  /// owned, figures are those of the whole mesh.
  /// \param solver in the place of Solve(); its displacements are right at all vertices
  Optimizer(Points V, Triangles triangles, std::shared_ptr<const Subdomain> subdomain,
    ProblemSolver solver);

  Optimizer(const Optimizer&) = delete;
  void operator=(const Optimizer&) = delete;

  /// Moves the vertices as the mode says.
  /// \throw InputError if an array that the options need is missing.
  /// \throw SolverError, Cancelled as Solve() does.
  OptimizerResult Run(
    const OptimizerOptions& options, const VertexArrays& arrays, ProgressMonitor& monitor);

  /// The mesh, perhaps renumbered.
  const MeshQuantities& GetMesh() const { return *this->Mesh; }

  /// How many quantities have been computed so far.
  int GetNumberOfParts() const;

  const PreconditionerCache& GetInverses() const { return this->Inverses; }

private:
  OptimizerResult RunInOrder(
    const OptimizerOptions& options, const VertexArrays& arrays, ProgressMonitor& monitor);

  /// Sets V' and the figures of the solution: by Eqn. 11 once,
  void SolveOnce(const OptimizerOptions& options, const VertexArrays& arrays,
    const std::optional<FeatureLines>& lines, ProgressMonitor& monitor, OptimizerResult& result);

  /// or along filtered normals,
  void FollowFilteredNormals(const OptimizerOptions& options, const VertexArrays& arrays,
    const std::optional<FeatureLines>& lines, ProgressMonitor& monitor, OptimizerResult& result);

  /// or by passes within a deviation.
  void StayWithinDeviation(const OptimizerOptions& options, const VertexArrays& arrays,
    const FeatureLines& lines, ProgressMonitor& monitor, OptimizerResult& result);

  MeshOrder Order;
  std::unique_ptr<const MeshQuantities> Mesh;
  std::unique_ptr<const CotangentQuantities> Quantities; ///< of the last run
  std::shared_ptr<const CotangentWeights> Weights; ///< null if the last run's L has none of them
  PreconditionerCache Inverses;
  ProblemSolver Solver;
};

/// Optimizer::Run() for a mesh that is used once.
inline OptimizerResult Optimize(const Points& V, const Triangles& triangles,
  const OptimizerOptions& options, const VertexArrays& arrays, ProgressMonitor& monitor)
{
  return Optimizer(V, triangles).Run(options, arrays, monitor);
}
}

#endif
