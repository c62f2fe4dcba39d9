// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_NormalFilter_h
#define lmo_NormalFilter_h

#include "Core/Base/ProgressMonitor.h"
#include "Core/Mesh/MeshTopology.h"

namespace lmo
{
/// Bilateral filter of the triangles' unit normals (Zheng et al. 2011): each becomes the mean over
/// the triangles that share a vertex of no high valence with it, weighted by area, a Gaussian of
/// the distance of the centroids, as wide as that is on average, and a Gaussian of the difference
/// of the normals.
/// \param width of the Gaussian of unit normals' differences, > 0
/// \return one row per triangle; 0 where there is none
/// \throw Cancelled if the monitor says so.
Points FilterNormals(const Points& V, const Triangles& triangles, const MeshTopology& topology,
  int iterations, double width, ProgressMonitor& monitor);
}

#endif
