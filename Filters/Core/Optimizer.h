// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_Optimizer_h
#define lmo_Optimizer_h

#include "LinearSolver.h"

#include <optional>

namespace lmo
{
/// Section 4: what L and f are.
enum class Mode
{
  OPTIMIZE_TRIANGLES,   ///< L = L_u, f = delta_c (section 5)
  SMOOTH,               ///< f = 0 (section 6)
  PRESCRIBED_LAPLACIANS ///< f from the user
};

enum class LaplacianType
{
  UNIFORM,
  COTANGENT,
  MEAN_CURVATURE ///< times the squared length scale of the mesh, to be independent of its unit
};

enum class PositionWeighting
{
  CONSTANT,
  LINEAR,
  CDF,
  ANCHORS,
  ARRAY
};

enum class LaplacianWeighting
{
  CONSTANT,
  LINEAR_COMPLEMENT,
  CDF_COMPLEMENT,
  GAUSSIAN,
  ARRAY
};

enum class BoundaryCondition
{
  FIXED,   ///< no motion, no Laplacian row
  SLIDING, ///< along the boundary curve, with a Laplacian row of the curve
  FREE     ///< as inner vertices
};

/// The properties of vtkLaplacianMeshOptimizer; see there for meaning and ranges.
struct OptimizerOptions
{
  Mode mode = Mode::OPTIMIZE_TRIANGLES;
  LaplacianType laplacianType = LaplacianType::UNIFORM;
  PositionWeighting positionWeighting = PositionWeighting::CDF;
  double scaleFactor = 1;
  LaplacianWeighting laplacianWeighting = LaplacianWeighting::CONSTANT;
  double gaussianWidth = 0.5;
  bool modulateByTriangleQuality = false;
  bool tangentPlaneConstraints = false;
  double tangentPlaneWeight = 1;
  BoundaryCondition boundaryCondition = BoundaryCondition::FIXED;
  SolverType solverType = SolverType::AUTOMATIC;
  SolverOptions solver;
};

/// Values that the user may give for each vertex.
struct VertexArrays
{
  std::optional<Vector> positionWeights;      ///< W_p or anchors, >= 0
  std::optional<Vector> laplacianWeights;     ///< W_L, >= 0
  std::optional<Points> prescribedLaplacians; ///< f
  std::optional<Vector> fixedPoints;          ///< not 0: does not move
};

struct OptimizerResult
{
  Points positions;      ///< V'
  Vector meanCurvatures; ///< kappa of the input
  Vector positionWeights;
  Vector laplacianWeights;
  std::shared_ptr<const MeshTopology> topology;
  Index iterations = 0;
  double relativeResidual = 0;
};

/// Moves the vertices to the solution of Eqn. 11.
/// \param triangles ids below the number of rows of \a V
/// \throw InputError if an array that the options need is missing.
/// \throw SolverError, Cancelled as Solve() does.
OptimizerResult Optimize(const Points& V, const Triangles& triangles,
  const OptimizerOptions& options, const VertexArrays& arrays, Monitor& monitor);
}

#endif
