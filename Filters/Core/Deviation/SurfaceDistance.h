// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_SurfaceDistance_h
#define lmo_SurfaceDistance_h

#include "Core/Base/ProgressMonitor.h"
#include "Core/Base/Types.h"

namespace lmo
{
/// Distances between a surface and a reference; lengths in the unit of the meshes. All are 0 if the
/// surface has no triangles.
struct SurfaceDistance
{
  Vector atVertices;                   ///< distance of each vertex of the surface to the reference
  std::vector<Index> closestTriangles; ///< of the reference, for each vertex; -1 if the surface
                                       ///< has no triangles
  double hausdorff = 0;                ///< maximum of both directions, over vertices and samples
  double mean = 0;                     ///< mean over the area, of both directions
  double diagonal = 0; ///< bounding box of the reference, of the vertices that a triangle uses
};

/// Measures both directions as Metro does (Cignoni et al. 1998): at the vertices that a triangle
/// uses and at samples inside the triangles. Triangles that name a vertex twice do not count.
/// \param samples in each direction, >= 1
/// \throw InputError if the surface has triangles and the reference has none.
/// \throw Cancelled if the monitor says so.
SurfaceDistance MeasureSurfaceDistance(const Points& V, const Triangles& triangles,
  const Points& referenceV, const Triangles& referenceTriangles, Index samples,
  ProgressMonitor& monitor);
}

#endif
