// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_DeviationOptimizer_h
#define lmo_DeviationOptimizer_h

#include "Core/Mesh/DisplacementConstraints.h"
#include "Core/Mesh/FeatureLines.h"
#include "Core/Operators/CotangentQuantities.h"
#include "Core/Optimizer/OptimizerOptions.h"

namespace lmo
{
/// What Mode::OPTIMIZE_WITHIN_DEVIATION did.
struct DeviationReport
{
  Index passes = 0;     ///< that moved the surface
  Index rolledBack = 0; ///< vertices that the last pass moved less than its solution
  /// The Hausdorff distance of input and result, divided by the bounding-box diagonal, is at most
  /// that.
  double relativeBound = 0;
};

struct DeviationResult
{
  Points positions; ///< V'
  Vector positionWeights;
  Vector laplacianWeights;
  Index iterations = 0;        ///< of conjugate gradients, over all passes
  double relativeResidual = 0; ///< of the last pass
  DeviationReport report;
  bool isCancelled = false; ///< the monitor asked to stop: the result is what was admitted by then
};

/// The best triangles within an error: passes of Eqn. 11 with f = n n^T L_u V, in which every
/// vertex keeps its tangent plane, or its feature line, exactly; after each a guard takes back,
/// vertex by vertex, as much of the motion as leaves the error or spoils a triangle.
/// \param features lines along which vertices slide
/// \param motion FIXED, ALONG_LINE or FREE, which here is in the tangent plane
DeviationResult OptimizeWithinDeviation(const CotangentQuantities& quantities,
  const OptimizerOptions& options, const FeatureLines& features,
  const DisplacementConstraints& motion, ProgressMonitor& monitor);
}

#endif
