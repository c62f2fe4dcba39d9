// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_DeviationOptimizer_h
#define lmo_DeviationOptimizer_h

#include "Features.h"
#include "OptimizerOptions.h"

namespace lmo
{
struct DeviationResult
{
  Points positions;             ///< V'
  Index passes = 0;             ///< that moved the surface
  Index iterations = 0;         ///< of conjugate gradients, over all passes
  Index rolledBack = 0;         ///< vertices that the last pass moved less than the solution
  double relativeResidual = 0;  ///< of the last pass
  double bound = 0;             ///< Hausdorff distance of input and result is at most that
  bool isCancelled = false;     ///< the monitor asked to stop: the result is that of the last pass
};

/// The best triangles within an error: passes of Eqn. 11 with f = n n^T L_u V, in which every vertex
/// keeps its tangent plane, or its feature line, exactly; after each a guard takes back, vertex by
/// vertex, as much of the motion as leaves the error or spoils a triangle.
/// \param features lines to slide along
/// \param isFixed vertices that do not move
DeviationResult OptimizeWithinDeviation(MeshAnalysis& mesh, const OptimizerOptions& options,
  const FeatureLines& features, const Mask& isFixed, Monitor& monitor);
}

#endif
