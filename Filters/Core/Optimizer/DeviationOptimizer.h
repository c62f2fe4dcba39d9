// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_DeviationOptimizer_h
#define lmo_DeviationOptimizer_h

#include "Core/Base/ProgressMonitor.h"
#include "Core/Optimizer/RunPlan.h"

namespace lmo
{
/// The best triangles within an error: passes of Eqn. 11 with f = n n^T L_u V, in which every
/// vertex keeps its tangent plane, or its feature line, exactly; after each a guard takes back,
/// vertex by vertex, as much of the motion as leaves the error or spoils a triangle.
/// \param plan its problem is that of SetUpTangentialProblem() with W_p = C(kappa), and is moved
/// from \return what was admitted by then if the monitor asks to stop \throw Cancelled if it does
/// before the first pass.
ModeResult OptimizeWithinDeviation(
  const MeshQuantities& mesh, RunPlan& plan, ProgressMonitor& monitor);
}

#endif
