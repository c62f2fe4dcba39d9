// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_CurveSmoothing_h
#define lmo_CurveSmoothing_h

#include "Core/Base/ProgressMonitor.h"
#include "Core/Operators/MeshQuantities.h"
#include "Core/Optimizer/RunPlan.h"

namespace lmo
{
/// Which vertices lie inside lines that the options let be smoothed as curves: the boundary by
/// BoundaryCondition::CURVE, the other lines by featureSmoothing, in modes that smooth.
Mask VerticesOnCurves(
  const MeshTopology& topology, const OptimizerOptions& options, const FeatureLines& lines);

/// Makes the corners of curves edges if the line turns by at most 60 degrees when it is seen over a
/// few edges: stairs, as label maps have them, are no corners.
void SmoothStairs(const Points& V, const Mask& isOnCurve, FeatureLines& lines);

/// Smooths the lines of VerticesOnCurves() as curves of their own: minimises
///   sum_i h_i (|w_i (l(d)_i + l(V)_i)|^2 + |W_p d_i|^2),
///   l(v)_i = (a v_previous + (1 - a) v_next - v_i) / (h_before h_after),
/// over the vertices inside these lines, in all directions. Here h_before and h_after are the
/// lengths of the edges at vertex i, h_i is their mean, all relative to the mean over all curves,
/// and a = h_after / (h_before + h_after): l is the curvature, and uneven edges do not bend a line.
/// Ends, junctions and sharp turns stay. The surface is then solved with these vertices fixed at
/// their new places, RunPlan::start: it does not draw a line out of its plane.
/// \throw SolverError, Cancelled as Solve() does.
void SmoothCurves(const MeshQuantities& mesh, RunPlan& plan, ProgressMonitor& monitor);
}

#endif
