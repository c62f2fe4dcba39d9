// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_MeshTopology_h
#define lmo_MeshTopology_h

#include "Core/Mesh/Polygons.h"

namespace lmo
{
/// A vertex of more triangles has a high valence: looking at all pairs of its triangles would take
/// too long.
constexpr Index LargestStar = 100;

/// Who is whose neighbour. A triangle that names a vertex twice has no edges and counts nowhere.
/// Edges, and with them the boundary, are those of the polygons if there are any: diagonals along
/// which these are cut are none.
struct MeshTopology
{
  Index vertices = 0;
  Polygons polygons;        ///< empty if the triangles are the cells
  AdjacencyLists cornersAt; ///< corners at each vertex; corner k of triangle t is 3 t + k
  AdjacencyLists oneRings;  ///< vertices that share an edge with each vertex
  Mask isFan; ///< corner k at the vertex lies between the neighbours k and k + 1, the first again
              ///< after the last; at other vertices both lists ascend
  AdjacencyLists boundaryEdges; ///< vertices that share an edge of exactly one cell with each
  Mask isBoundary;              ///< vertex lies on an edge of exactly one cell
  Mask isUsed; ///< a triangle uses the vertex; the others keep their place and count nowhere

  bool HasHighValence(Index i) const { return this->cornersAt.Size(i) > LargestStar; }

  /// At least one triangle, and no edge with exactly one.
  bool IsClosed() const;
};

/// The corners after and before corner 3 t + k, counter-clockwise.
inline Index NextCorner(Index corner)
{
  return corner % 3 == 2 ? corner - 2 : corner + 1;
}
inline Index PreviousCorner(Index corner)
{
  return corner % 3 == 0 ? corner + 2 : corner - 1;
}

/// True if the triangle names a vertex twice.
inline bool IsDegenerate(const Triangles& triangles, Index t)
{
  return triangles(t, 0) == triangles(t, 1) || triangles(t, 1) == triangles(t, 2) ||
         triangles(t, 2) == triangles(t, 0);
}

/// The corners at each vertex, ascending, without those of degenerate triangles.
AdjacencyLists CornersAtVertices(Index vertices, const Triangles& triangles);

/// \param vertices number of vertices; every id in \a triangles is below it.
/// \param polygons to which the triangles belong; empty if the triangles are the cells
/// \throw InputError if the mesh has more corners than Index can count.
MeshTopology BuildTopology(
  Index vertices, const Triangles& triangles, Polygons polygons = Polygons());

/// Connected component of each vertex, 0, 1, ... in the order of their first vertices; an isolated
/// vertex is a component of its own.
std::vector<Index> ConnectedComponents(const AdjacencyLists& oneRings);
}

#endif
