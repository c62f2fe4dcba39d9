// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_SingleSolve_h
#define lmo_SingleSolve_h

#include "Core/Base/ProgressMonitor.h"
#include "Core/Optimizer/RunPlan.h"

namespace lmo
{
/// The modes of one solution of Eqn. 11; with twicing there is a second one.
/// \param plan its problem is moved from
/// \throw SolverError, Cancelled as Solve() does.
ModeResult SolveOnce(const MeshQuantities& mesh, RunPlan& plan, ProgressMonitor& monitor);
}

#endif
