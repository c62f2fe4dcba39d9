// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_Optimizer_h
#define lmo_Optimizer_h

#include "Core/Deviation/SurfaceComparison.h"
#include "Core/Operators/CotangentQuantities.h"
#include "Core/Optimizer/ResultReview.h"
#include "Core/Optimizer/RunPlan.h"
#include "Core/Solvers/PreconditionerCache.h"

namespace lmo
{
/// What a run returns, with a row for each vertex.
struct OptimizerResult : ModeResult
{
  Points displacements;               ///< V' - V
  Vector meanCurvatures;              ///< kappa of the input
  std::optional<Vector> featureClass; ///< FeatureLines::Class of each vertex; none without features
  Points normals;               ///< vertex normals of V', 0 where undefined; no rows if not wanted
  SurfaceComparison comparison; ///< of V and V'
  VolumeLoss volumeLoss;        ///< of the smoothing modes
  VertexFreedom freedom;
};

/// Laplacian mesh optimization of one mesh, any number of times: what depends on the mesh alone is
/// computed once, when it is first needed.
class Optimizer
{
public:
  /// \param triangles ids below the number of rows of \a V
  /// \param polygons to which the triangles belong; empty if the triangles are the cells
  Optimizer(Points V, Triangles triangles, Polygons polygons = Polygons());

  /// For a part of a mesh that is distributed over processes. Results are right where the vertex is
  /// owned, metrics are those of the whole mesh.
  /// \param solver in the place of Solve(); its displacements are right at all vertices
  Optimizer(Points V, Triangles triangles, std::shared_ptr<const Subdomain> subdomain,
    ProblemSolver solver);

  virtual ~Optimizer() = default;
  Optimizer(const Optimizer&) = delete;
  void operator=(const Optimizer&) = delete;

  /// Moves the vertices as the mode says.
  /// \throw InputError if an array that the options need is missing.
  /// \throw SolverError, Cancelled as Solve() does.
  virtual OptimizerResult Run(
    const OptimizerOptions& options, const VertexArrays& arrays, ProgressMonitor& monitor);

  const MeshQuantities& GetMesh() const { return this->Mesh; }

  const PreconditionerCache& GetInverses() const { return this->Inverses; }

  /// How many quantities have been computed so far.
  int GetNumberOfParts() const;

protected:
  /// Mode::OPTIMIZE_WITHIN_DEVIATION.
  virtual ModeResult OptimizeWithin(RunPlan& plan, ProgressMonitor& monitor);

private:
  /// The quantities of a choice of weights.
  const CotangentQuantities& ChooseQuantities(bool isRobust);

  const MeshQuantities Mesh;
  std::unique_ptr<const CotangentQuantities> Quantities; ///< of the last run
  std::shared_ptr<const CotangentWeights> Weights;       ///< of its L; null if it was L_u
  PreconditionerCache Inverses;
  const ProblemSolver Solver;
};

/// Optimizer::Run() for a mesh that is used once.
inline OptimizerResult Optimize(const Points& V, const Triangles& triangles,
  const OptimizerOptions& options, const VertexArrays& arrays, ProgressMonitor& monitor)
{
  return Optimizer(V, triangles).Run(options, arrays, monitor);
}
}

#endif
