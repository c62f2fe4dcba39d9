// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_FieldInterpolation_h
#define lmo_FieldInterpolation_h

#include "Core/Mesh/MeshTopology.h"
#include "Core/Mesh/SurfaceWalk.h"

namespace lmo
{
/// Up to four fields: a row for each vertex or location, a column for each field.
using Fields = Eigen::Array<double, Eigen::Dynamic, 4, Eigen::RowMajor>;

/// Fields at locations on a surface, by barycentric interpolation:
///   sum_k w_k f_k.
/// \return 0 where a location has no triangle
Fields InterpolateLinearly(
  const Triangles& triangles, const Fields& fields, const std::vector<SurfaceLocation>& locations);

/// The same with half of what the gradients at the corners add, which makes the error of smooth
/// fields smaller:
///   sum_k w_k (f_k + g_k . (x - x_k) / 2),
/// within sum_k w_k (the range of the values at corner k and its neighbours). The result is
/// continuous, and no value leaves the field's range. The gradient at a vertex is the mean over its
/// triangles of those of the linear interpolation, with the squares of the weights that N. Max
/// (1999) gives for normals: of the sine of the angle over the product of the edges. It is exact
/// for linear fields on a plane.
Fields InterpolateSmoothly(const WalkableSurface& surface, const Fields& fields,
  const std::vector<SurfaceLocation>& locations);

/// How fields come to other places: as the functions above say, or unchanged from a corner.
enum class Interpolation
{
  SMOOTH,
  LINEAR,
  NEAREST ///< the values of the corner with the largest weight
};

Fields InterpolateFields(const WalkableSurface& surface, const Fields& fields,
  const std::vector<SurfaceLocation>& locations, Interpolation how);

/// Where positions near a surface are when it has moved: each moves as the place of the surface
/// that is closest to it.
/// \param after the surface's vertices after the motion
/// \param positions one for each vertex, near which the closest place is sought
Points MoveWithSurface(const WalkableSurface& before, const Points& after, const Points& positions);
}

#endif
