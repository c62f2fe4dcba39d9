// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_VolumePreservation_h
#define lmo_VolumePreservation_h

#include "Core/Mesh/DisplacementConstraints.h"
#include "Core/Optimizer/EnclosedRegions.h"

namespace lmo
{
/// Gives each region of \a moved the volume that it encloses in \a V. A vertex that may move freely
/// is offset by
///   sum_k h_k g_k / max_k |g_k|,
/// where g_k is the gradient of the volume of region k: along its normal on the surface of one
/// region, by the difference of two offsets between two regions. Newton's method finds the h_k.
/// \return how many regions have no volume in \a V but round-off, or another one in \a moved since
/// none of their vertices may move freely
/// \throw SolverError if there are no such offsets
Index RestoreVolumes(const Points& V, const Triangles& triangles, const MeshTopology& topology,
  const EnclosedRegions& regions, const DisplacementConstraints& constraints, Points& moved);
}

#endif
