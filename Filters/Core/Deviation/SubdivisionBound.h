// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_SubdivisionBound_h
#define lmo_SubdivisionBound_h

#include "Core/Mesh/TriangleBvh.h"
#include "Core/Mesh/TriangleGeometry.h"

namespace lmo
{
/// The search for closest points of a mesh, and how often proofs may use it.
struct Subdivision
{
  const TriangleBvh& tree;
  int searchesLeft; ///< what needs more is not proven
};

struct Nearness
{
  bool isProven = false;
  Index failure = -1; ///< triangle of the mesh that is close to where the certificate fails, or -1
  std::vector<Index> used; ///< triangles of the mesh that the certificate needs
};

/// Proves that a triangle lies within a distance of a mesh. The distance to one triangle, a convex
/// set, is a convex function: if the corners are within it, so is all between them. Where no single
/// triangle of the mesh serves, the triangle is divided into four, up to six times.
/// \param hint triangle of the mesh that is perhaps close, or -1
Nearness TestBySubdivision(
  const TriangleCorners& triangle, Subdivision& subdivision, double distance, Index hint);
}

#endif
