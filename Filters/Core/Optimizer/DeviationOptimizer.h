// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_DeviationOptimizer_h
#define lmo_DeviationOptimizer_h

#include "Core/Base/ProgressMonitor.h"
#include "Core/Optimizer/RunPlan.h"

namespace lmo
{
/// The best triangles within an error: passes of Eqn. 11 with f = n n^T L_u V, in which every
/// vertex stays exactly in its tangent plane, or on its feature line. After each pass a guard
/// reduces the displacements that would exceed the error or spoil a triangle.
/// \param plan its problem, that of SetUpTangentialProblem() with W_p = C(kappa), is moved from
/// \return what was accepted by then if the monitor asks to stop
/// \throw Cancelled if it does so before the first pass
ModeResult OptimizeWithinDeviation(
  const MeshQuantities& mesh, RunPlan& plan, ProgressMonitor& monitor);
}

#endif
