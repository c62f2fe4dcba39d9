// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_TriangleQuality_h
#define lmo_TriangleQuality_h

#include "Core/Mesh/Subdomain.h"

namespace lmo
{
/// Radius ratio of points and cells that have none.
constexpr double UndefinedQuality = -1;

/// Eqn. 12: t = 2 r / R, with the radii of the inscribed and the circumscribed circle. 1 for an
/// equilateral, 0 for a degenerate triangle; independent of the triangle's size.
double RadiusRatio(const Vector3& a, const Vector3& b, const Vector3& c);

/// Eqn. 12 for each triangle.
Vector RadiusRatios(const Points& V, const Triangles& triangles);

/// Minimum over the triangles at each vertex, W_t of section 5.2; UndefinedQuality at vertices that
/// no triangle uses.
Vector MinimumAtVertices(const Vector& triangleValues, const Triangles& triangles, Index vertices);

/// Eqn. 12 over a mesh.
struct MeshQuality
{
  Vector triangles;                  ///< of each triangle
  Vector vertices;                   ///< minimum at each vertex
  double mean = UndefinedQuality;    ///< t_mean of Fig. 5; UndefinedQuality without triangles
  double minimum = UndefinedQuality; ///< t_min of Fig. 5
};

/// The mean and the minimum are those of the whole mesh of which this is a part.
MeshQuality MeasureQuality(
  const Points& V, const Triangles& triangles, const Subdomain& subdomain = Subdomain());
}

#endif
