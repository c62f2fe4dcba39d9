// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_GuidedSchedule_h
#define lmo_GuidedSchedule_h

#include "Core/Base/ProgressMonitor.h"
#include "Core/Optimizer/RunPlan.h"

namespace lmo
{
/// The smoothing with which Mode::SMOOTH_GUIDED starts, for the problem of its plan.
OptimizerOptions FirstSmoothing(const OptimizerOptions& options);

/// Mode::SMOOTH_GUIDED: smooths, then filters the normals of the triangles and moves the vertices
/// after them, in rounds.
/// \param plan its problem is moved from
/// \throw SolverError, Cancelled as Solve() does.
ModeResult SmoothGuided(const MeshQuantities& mesh, RunPlan& plan, ProgressMonitor& monitor);
}

#endif
