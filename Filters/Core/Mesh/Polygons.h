// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_Polygons_h
#define lmo_Polygons_h

#include "Core/Mesh/AdjacencyLists.h"

namespace lmo
{
/// The cells of a surface of which some have more than three corners. Each is cut into triangles,
/// which are stored beside them in the order of the polygons: n - 2 triangles for n corners.
struct Polygons
{
  AdjacencyLists corners;        ///< vertices around each polygon, counter-clockwise
  std::vector<Index> ofTriangle; ///< the polygon that each triangle is a part of

  Polygons() = default;

  /// \param corners three or more of each polygon
  explicit Polygons(AdjacencyLists corners);

  /// True if the triangles are the cells.
  bool IsEmpty() const { return this->ofTriangle.empty(); }

  Index Size() const
  {
    return this->IsEmpty() ? 0 : static_cast<Index>(this->corners.offsets.size()) - 1;
  }

  /// The triangles of polygon p are those from this one up to the first of polygon p + 1.
  Index FirstTriangle(Index p) const { return this->corners.offsets[p] - 2 * p; }

  /// True for one triangle of each cell.
  bool IsFirstTriangle(Index t) const
  {
    return this->IsEmpty() || t == this->FirstTriangle(this->ofTriangle[t]);
  }
};

/// The edges of polygons, without the diagonals along which they are cut.
struct PolygonEdges
{
  AdjacencyLists neighbours; ///< vertices that share an edge with each vertex, ascending
  AdjacencyLists boundary;   ///< those that share an edge of exactly one polygon with it
};

/// An edge that ends where it starts is none, and polygons whose triangles all name a vertex twice
/// have none.
PolygonEdges EdgesOfPolygons(Index vertices, const Polygons& polygons, const Triangles& triangles);

/// Calls visit(t) for each triangle of each cell that has a corner at vertex i, once.
/// \param cornersAt ascending lists of the triangles' corners at each vertex if there are polygons
template <typename Visit>
void ForEachTriangleOfCellsAt(
  const AdjacencyLists& cornersAt, const Polygons& polygons, Index i, const Visit& visit)
{
  Index last = -1;
  for (const Index corner : cornersAt[i])
  {
    const Index triangle = corner / 3;
    if (polygons.IsEmpty())
    {
      visit(triangle);
      continue;
    }
    const Index p = polygons.ofTriangle[triangle];
    for (Index t = polygons.FirstTriangle(p); p != last && t < polygons.FirstTriangle(p + 1); ++t)
    {
      visit(t);
    }
    last = p;
  }
}
}

#endif
