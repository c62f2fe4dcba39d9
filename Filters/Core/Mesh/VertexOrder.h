// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_VertexOrder_h
#define lmo_VertexOrder_h

#include "Core/Base/Threading.h"
#include "Core/Mesh/MeshTopology.h"

namespace lmo
{
/// New numbers for the vertices and triangles of a mesh, so that neighbours lie close together in
/// memory.
struct MeshOrder
{
  std::vector<Index> vertices;  ///< old number of each new vertex
  std::vector<Index> triangles; ///< old number of each new triangle
};

/// True if neighbours lie so far apart that the processor's caches do not hold what is between
/// them: that makes every pass over the mesh several times slower.
bool IsScattered(const Triangles& triangles);

/// Numbers the vertices breadth-first (Cuthill and McKee 1969) and the triangles by their first
/// vertex, those of a polygon one after the other.
/// \param vertices number of vertices; every id in \a triangles is below it.
/// \param polygons to which the triangles belong; empty if the triangles are the cells
MeshOrder BreadthFirstOrder(
  Index vertices, const Triangles& triangles, const Polygons& polygons = Polygons());

/// The triangles in the new order with the new vertex numbers.
Triangles Renumber(const MeshOrder& order, const Triangles& triangles);

/// The polygons in the order of their triangles with the new vertex numbers.
Polygons Renumber(const MeshOrder& order, const Polygons& polygons);

/// Rows of \a values in the new order.
/// \param oldNumbers of the rows; if empty, the result is \a values
template <typename Values>
Values ToNewOrder(const std::vector<Index>& oldNumbers, Values values)
{
  if (oldNumbers.empty())
  {
    return values;
  }
  Values result(static_cast<Eigen::Index>(oldNumbers.size()), values.cols());
  ParallelFor(static_cast<Index>(oldNumbers.size()),
    [&](Index i) { result.row(i) = values.row(oldNumbers[i]); });
  return result;
}
}

#endif
