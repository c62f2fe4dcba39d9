// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_TriangleSeparation_h
#define lmo_TriangleSeparation_h

#include "Core/Mesh/MeshTopology.h"

namespace lmo
{
/// Proves that two triangles meet at most in the vertices and the edge that they share, with a
/// margin above round-off.
/// \return false if that is not so, or is too close to be told
bool AreSeparate(const Points& V, const Triangles& triangles, Index s, Index t);

/// Proves that the triangles at a vertex meet at most in the vertices and edges that they share:
/// seen along their mean normal, they are one fan that does not overlap.
/// \return false if that is not so, or another test has to decide
bool IsFlatFan(
  const Points& V, const Triangles& triangles, const MeshTopology& topology, Index vertex);
}

#endif
