// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_CurveSmoothing_h
#define lmo_CurveSmoothing_h

#include "Core/Base/ProgressMonitor.h"
#include "Core/Operators/MeshQuantities.h"
#include "Core/Optimizer/RunPlan.h"

namespace lmo
{
/// Smooths the lines that the options name (BoundaryCondition::CURVE, featureSmoothing) as curves
/// of their own: minimises
///   sum_i |w_i (l(d)_i + l(V)_i)|^2 + |W_p d|^2 with l(v)_i = (v_previous + v_next) / 2 - v_i
/// over the vertices inside these lines, in all directions. Their ends, junctions and sharp turns
/// stay. The surface is solved with these vertices fixed at their new places, RunPlan::start, so
/// that a line is not drawn out of its plane by the surface. Does nothing in modes that do not
/// smooth.
/// \throw SolverError, Cancelled as Solve() does.
void SmoothCurves(const MeshQuantities& mesh, RunPlan& plan, ProgressMonitor& monitor);
}

#endif
