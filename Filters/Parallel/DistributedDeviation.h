// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_DistributedDeviation_h
#define lmo_DistributedDeviation_h

#include "Core/Optimizer/RunPlan.h"
#include "DistributedSubdomain.h"

namespace lmo
{
/// OPTIMIZE_WITHIN_DEVIATION of a surface over several processes, in steps that the code of one
/// process takes:
/// 1. Every process moves the vertices that are far from those of the others.
/// 2. Process 0 moves the rest, the seam between the pieces, and what is near it.
/// 3. Process 0 improves the worst triangles that are left.
/// Each guarantee holds for the whole surface, since a proof against the part that a process knows
/// is one against the whole:
/// - Original and moved triangles of the first step are within the distance of each other. Process
///   0 proves the other steps against the original surface, for all triangles that it moves and all
///   original ones that they were near.
/// - Surfaces of two processes cannot meet in the first step, since they are farther apart than
///   both can move. Process 0 sees that this is so, and has all triangles that its own can meet.
/// Collective.
/// \param plan of this process's part of the mesh, with what each vertex may do in the whole; its
///   problem is moved from
/// \return the positions of all vertices of the part; figures of the whole surface
ModeResult OptimizeWithinDeviation(const MeshQuantities& mesh,
  const DistributedSubdomain& subdomain, RunPlan& plan, ProgressMonitor& monitor);
}

#endif
