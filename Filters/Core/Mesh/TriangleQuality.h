// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_TriangleQuality_h
#define lmo_TriangleQuality_h

#include "Core/Mesh/Polygons.h"
#include "Core/Mesh/Subdomain.h"

#include <algorithm>

namespace lmo
{
/// Radius ratio of points and cells that have none.
constexpr double UndefinedQuality = -1;

/// Eqn. 12: t = 2 r / R, with the radii of the inscribed and the circumscribed circle. 1 for an
/// equilateral, 0 for a degenerate triangle; independent of the triangle's size.
double RadiusRatio(const Vector3& a, const Vector3& b, const Vector3& c);

/// Eqn. 12 for each triangle.
Vector RadiusRatios(const Points& V, const Triangles& triangles);

/// 2 |a x b| / (|a|^2 + |b|^2) for the edges a and b of a corner: the sine of its angle where both
/// have the same length, and less otherwise; 0 if an edge has no length.
double CornerShape(const Vector3& a, const Vector3& b);

/// Sine of the angles of a regular polygon.
double SineOfRegularPolygon(Index corners);

/// Quality of a cell: Eqn. 12 for a triangle; for a larger polygon the minimum over its corners of
/// CornerShape(), divided by that of the regular polygon and clipped to 1. 1 for a regular polygon,
/// 0 for a degenerate one; independent of the size. For convex quads in a plane it is the metric
/// Shape of the Verdict library.
/// \param pointAt returns the position of corner 0 to \a corners - 1
template <typename PointAt>
double CellQuality(Index corners, const PointAt& pointAt)
{
  if (corners == 3)
  {
    return RadiusRatio(pointAt(0), pointAt(1), pointAt(2));
  }
  double least = SineOfRegularPolygon(corners);
  const double regular = least;
  Vector3 previous = pointAt(corners - 1);
  Vector3 here = pointAt(0);
  for (Index k = 0; k < corners; ++k)
  {
    const Vector3 next = pointAt(k + 1 < corners ? k + 1 : 0);
    least = std::min(least, CornerShape(previous - here, next - here));
    previous = here;
    here = next;
  }
  return least / regular;
}

/// CellQuality() of polygon p.
double PolygonQuality(const Points& V, const Polygons& polygons, Index p);

/// Number of corners that are turned inwards, seen along the normal of the polygon's area.
Index CountReflexCorners(const Points& V, const Polygons& polygons, Index p);

/// CellQuality() of the cell of each triangle.
/// \param polygons to which the triangles belong; empty if the triangles are the cells
Vector CellQualities(const Points& V, const Triangles& triangles, const Polygons& polygons);

/// Minimum over the triangles at each vertex, W_t of section 5.2; UndefinedQuality at vertices that
/// no triangle uses.
Vector MinimumAtVertices(const Vector& triangleValues, const Triangles& triangles, Index vertices);

/// Eqn. 12 over a mesh, with CellQuality() where cells are larger polygons.
struct MeshQuality
{
  Vector triangles;                  ///< for each triangle the quality of its cell
  Vector vertices;                   ///< minimum at each vertex
  double mean = UndefinedQuality;    ///< t_mean of Fig. 5 over cells; UndefinedQuality without any
  double minimum = UndefinedQuality; ///< t_min of Fig. 5
};

/// The mean and the minimum are those of the whole mesh of which this is a part.
/// \param polygons to which the triangles belong; empty if the triangles are the cells
MeshQuality MeasureQuality(const Points& V, const Triangles& triangles,
  const Polygons& polygons = Polygons(), const Subdomain& subdomain = Subdomain());
}

#endif
