// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef PointNormals_h
#define PointNormals_h

#include "MeshNumbering.h"

class vtkPolyData;

namespace lmo
{
/// Unit normals at points of which several may be one vertex. A point whose input normal was rather
/// that of its own triangles than that of its vertex, as beside a sharp edge, takes the normal of
/// its own triangles, other points that of the vertex.
/// \param input with point normals, and points of which several are one vertex
/// \param positions of the points now
/// \return a row per point, 0 where no triangle gives a normal
Points NormalsOfMergedPoints(
  vtkPolyData* input, const Points& positions, const MeshNumbering& numbering);
}

#endif
