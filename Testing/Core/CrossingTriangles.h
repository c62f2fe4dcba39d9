// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef CrossingTriangles_h
#define CrossingTriangles_h

#include "MeshFixtures.h"

#include <utility>
#include <vector>

/// Triangle pairs by another way than that of the code under test, slowly.

/// Whether two triangles with small integer coordinates have a common point that is not a common
/// corner or on a common edge: exact.
bool MeetExactly(const TestMesh& mesh, lmo::Index s, lmo::Index t);

/// The pairs of triangles, the smaller index first, in which an edge of one passes clearly through
/// the inside of the other.
std::vector<std::pair<lmo::Index, lmo::Index>> CrossingPairs(const TestMesh& mesh);

/// Those that do not cross in another mesh with the same triangles.
std::size_t CountNewCrossings(const TestMesh& before, const TestMesh& after);

#endif
