// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_TriangleGeometry_h
#define lmo_TriangleGeometry_h

#include "MeshTopology.h"

namespace lmo
{
constexpr double Pi = 3.14159265358979323846;

/// Cotangents beyond it are those of angles that round-off made.
constexpr double MaximumCotangent = 1e6;

/// Normal of triangle t, counter-clockwise, with twice the triangle's area as its length.
Vector3 ScaledNormal(const Points& V, const Triangles& triangles, Index t);

/// Cotangent of the angle at each corner (Fig. 4): positive below a right angle, negative above,
/// at most MaximumCotangent in magnitude; 0 at the corners of a triangle without area.
CornerValues Cotangents(const Points& V, const Triangles& triangles);

/// A(v) of Eqn. 7: the mixed Voronoi area of each vertex (Meyer et al. 2003). The sum over all
/// vertices is the area of the surface; 0 at isolated vertices.
Vector MixedVoronoiAreas(const Points& V, const Triangles& triangles, const MeshTopology& topology,
  const CornerValues& cotangents);

/// 2 pi minus the sum of the angles at each vertex, in radians; 0 at isolated vertices.
Vector AngleDefects(const Points& V, const Triangles& triangles, const MeshTopology& topology);

/// Unit mean of the normals of the triangles at each vertex, weighted by area; 0 where undefined.
Points VertexNormals(const Points& V, const Triangles& triangles, const MeshTopology& topology);

/// Volume enclosed by a closed surface; positive if its triangles are counter-clockwise seen from
/// outside.
double EnclosedVolume(const Points& V, const Triangles& triangles);

/// Diagonal of the axis-aligned bounding box of the vertices that a triangle uses.
double BoundingBoxDiagonal(const Points& V, const MeshTopology& topology);
}

#endif
