// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_SurfaceWalk_h
#define lmo_SurfaceWalk_h

#include "Core/Mesh/AdjacencyLists.h"

namespace lmo
{
/// A surface to walk on, by its parts, which somebody else keeps.
struct WalkableSurface
{
  const Points& V;
  const Triangles& triangles;
  const AdjacencyLists& cornersAt; ///< CornersAtVertices() of the triangles
};

/// A point of a surface.
struct SurfaceLocation
{
  Index triangle = -1; ///< -1 if there is none
  Vector3 weights;     ///< barycentric coordinates: of the triangle's corners, >= 0, with sum 1

  /// The corner with the largest weight, 0 to 2.
  Index NearestCorner() const
  {
    Index corner = 0;
    this->weights.maxCoeff(&corner);
    return corner;
  }
};

/// Finds the point of a surface that is closest to \a x near one of its vertices: begins with the
/// triangles at the vertex and, unless the closest point lies inside a triangle, goes on to those
/// that share a vertex with the closest triangle, as long as the distance falls. Sheets of the
/// surface that are not connected there are not reached, and where the surface folds back by more
/// than 90 degrees, the triangle below \a x may be taken instead of the closest one.
/// \return no triangle if the vertex has none
SurfaceLocation WalkToClosestPoint(const WalkableSurface& surface, Index vertex, const Vector3& x);
}

#endif
