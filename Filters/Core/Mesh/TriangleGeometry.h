// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_TriangleGeometry_h
#define lmo_TriangleGeometry_h

#include "Core/Mesh/MeshTopology.h"

#include <Eigen/Geometry>

namespace lmo
{
constexpr double Pi = 3.14159265358979323846;

/// Cotangents beyond it are those of angles that round-off made.
constexpr double MaximumCotangent = 1e6;

/// Corners a, b and c, one per row.
using TriangleCorners = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

inline TriangleCorners CornersOf(const Points& V, const Triangles& triangles, Index t)
{
  TriangleCorners corners;
  corners << V.row(triangles(t, 0)), V.row(triangles(t, 1)), V.row(triangles(t, 2));
  return corners;
}

/// Normal of triangle t, counter-clockwise, with twice the triangle's area as its length.
Vector3 ScaledNormal(const Points& V, const Triangles& triangles, Index t);

/// The point of triangle abc that is closest to x.
Vector3 ClosestPointOnTriangle(
  const Vector3& x, const Vector3& a, const Vector3& b, const Vector3& c);

/// Cotangents of one triangle, as Cotangents() gives them.
Vector3 TriangleCotangents(const TriangleCorners& corners);

/// Shares of its corners in the area of one triangle, as MixedVoronoiAreas() sums them.
Vector3 MixedVoronoiShares(const TriangleCorners& corners, const Vector3& cotangents);

/// Angles at the corners, in radians.
Vector3 TriangleAngles(const TriangleCorners& corners);

/// The barycentric coordinates of ClosestPointOnTriangle(): the weights of a, b and c, from 0 to 1,
/// with sum 1.
Vector3 ClosestBarycentricCoordinates(
  const Vector3& x, const Vector3& a, const Vector3& b, const Vector3& c);

/// Cotangent of the angle at each corner (Fig. 4): positive below a right angle, negative above,
/// at most MaximumCotangent in magnitude; 0 at the corners of a triangle without area.
CornerValues Cotangents(const Points& V, const Triangles& triangles);

/// A(v) of Eqn. 7: the mixed Voronoi area of each vertex (Meyer et al. 2003). The sum over all
/// vertices is the area of the surface; 0 at isolated vertices.
Vector MixedVoronoiAreas(const Points& V, const Triangles& triangles, const MeshTopology& topology,
  const CornerValues& cotangents);

/// 2 pi minus the sum of the angles at each vertex, in radians; 0 at isolated vertices.
Vector AngleDefects(const Points& V, const Triangles& triangles, const MeshTopology& topology);

/// One row of VertexNormals().
Vector3 VertexNormal(
  const Points& V, const Triangles& triangles, const MeshTopology& topology, Index i);

/// Unit mean of the normals of the cells at each vertex, weighted by area; 0 where undefined. It
/// does not depend on the diagonals along which polygons are cut.
Points VertexNormals(const Points& V, const Triangles& triangles, const MeshTopology& topology);

/// Signed volume of the tetrahedron between a point and triangle t. The sum over a closed surface
/// is the volume that it encloses, positive if its triangles are counter-clockwise seen from
/// outside.
double VolumeTo(const Vector3& point, const Points& V, const Triangles& triangles, Index t);

/// Volume enclosed by a closed surface.
double EnclosedVolume(const Points& V, const Triangles& triangles);

/// Axis-aligned bounding box of the vertices that a triangle uses.
Eigen::AlignedBox3d BoundingBox(const Points& V, const MeshTopology& topology);

/// Diagonal of BoundingBox(); 0 if it is empty.
double BoundingBoxDiagonal(const Points& V, const MeshTopology& topology);
}

#endif
