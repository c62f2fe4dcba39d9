// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_VolumePreservation_h
#define lmo_VolumePreservation_h

#include "Core/Mesh/DisplacementConstraints.h"
#include "Core/Mesh/MeshTopology.h"

namespace lmo
{
/// Gives each closed component of \a moved the volume that it encloses in \a V, by an offset along
/// its vertex normals, the same for all its vertices that may move freely. A component with a
/// boundary, with an edge of three and more triangles or with triangles of different orientations
/// encloses none.
/// \param component connected component of each vertex
/// \throw SolverError if there is no such offset
void RestoreVolumes(const Points& V, const Triangles& triangles, const MeshTopology& topology,
  const std::vector<Index>& component, const DisplacementConstraints& motion, Points& moved);
}

#endif
