// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_TriangleNeighbours_h
#define lmo_TriangleNeighbours_h

#include "Core/Mesh/MeshTopology.h"

namespace lmo
{
/// No neighbour: the edge is a boundary, belongs to more than two triangles, or the two differ in
/// their orientation.
constexpr Index NoNeighbour = -1;

/// The triangle beside the edge from vertex i to j of a triangle, or NoNeighbour.
Index NeighbourAcross(const Triangles& triangles, const MeshTopology& topology, Index i, Index j);

/// One row per triangle: the triangle across the edge that leaves each corner counter-clockwise, or
/// NoNeighbour.
Triangles FindTriangleNeighbours(const Triangles& triangles, const MeshTopology& topology);

/// Whether every edge has two triangles that run along it in opposite directions, so that the
/// surface has an inside. False without triangles.
bool IsClosedAndOriented(const Triangles& triangles, const MeshTopology& topology);

/// Whether a surface that IsClosedAndOriented() encloses a negative volume: its triangles are
/// counter-clockwise seen from inside. False for other surfaces.
bool IsInsideOut(const Points& V, const Triangles& triangles, const MeshTopology& topology);
}

#endif
