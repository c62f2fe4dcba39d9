// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef CoincidentPoints_h
#define CoincidentPoints_h

#include "Core/Mesh/MeshTopology.h"

#include <vector>

namespace lmo
{
/// Points on the boundary that have the same coordinates are one vertex of the surface: soups of
/// triangles and seams of texture coordinates are connected there. Other points are not compared,
/// so that closed surfaces that touch stay apart.
/// \param V coordinates of the points
/// \param triangles by point ids
/// \return for each point the lowest point that is the same vertex; empty if no two are the same
std::vector<Index> FindCoincidentBoundaryPoints(const Points& V, const Triangles& triangles);

/// The points that share their coordinates with another one, those of one place together and
/// ascending.
std::vector<Index> PointsWithTwins(const Points& V);

/// True if an edge at the point belongs to exactly one triangle.
bool IsOnBoundary(const AdjacencyLists& cornersAt, const Triangles& triangles, Index point);
}

#endif
