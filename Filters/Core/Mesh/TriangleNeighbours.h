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
}

#endif
