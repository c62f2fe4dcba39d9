// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ExactIntersections_h
#define ExactIntersections_h

#include "MeshFixtures.h"

#include <set>
#include <utility>

/// Pairs of triangles, the smaller index first.
using ExactPairs = std::set<std::pair<lmo::Index, lmo::Index>>;

/// The pairs that meet elsewhere than in the vertices and the edge that they share, by CGAL's exact
/// predicates and brute force. Triangles without area are left out.
ExactPairs FindExactIntersections(const TestMesh& mesh);

#endif
