// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Mesh/Polygons.h"

#include "Core/Base/Threading.h"

#include <algorithm>
#include <numeric>

namespace lmo
{
namespace
{
bool HasArea(const Polygons& polygons, const Triangles& triangles, Index p)
{
  for (Index t = polygons.FirstTriangle(p); t < polygons.FirstTriangle(p + 1); ++t)
  {
    if (triangles(t, 0) != triangles(t, 1) && triangles(t, 1) != triangles(t, 2) &&
        triangles(t, 2) != triangles(t, 0))
    {
      return true;
    }
  }
  return false;
}

/// Calls visit(i, j) for each edge of each polygon.
template <typename Visit>
void ForEachEdge(const Polygons& polygons, const Triangles& triangles, const Visit& visit)
{
  for (Index p = 0; p < polygons.Size(); ++p)
  {
    if (!HasArea(polygons, triangles, p))
    {
      continue;
    }
    Index i = polygons.corners.End(p)[-1];
    for (const Index* j = polygons.corners.Begin(p); j != polygons.corners.End(p); i = *j++)
    {
      if (i != *j)
      {
        visit(i, *j);
      }
    }
  }
}

/// Each neighbour once for each polygon of the edge, in ascending order.
AdjacencyLists NeighboursAlongEdges(
  Index vertices, const Polygons& polygons, const Triangles& triangles)
{
  AdjacencyLists lists;
  lists.offsets.assign(vertices + 1, 0);
  ForEachEdge(polygons, triangles,
    [&](Index i, Index j)
    {
      ++lists.offsets[i + 1];
      ++lists.offsets[j + 1];
    });
  std::partial_sum(lists.offsets.begin(), lists.offsets.end(), lists.offsets.begin());
  lists.ids.resize(lists.offsets.back());
  std::vector<Index> next(lists.offsets.begin(), lists.offsets.end() - 1);
  ForEachEdge(polygons, triangles,
    [&](Index i, Index j)
    {
      lists.ids[next[i]++] = j;
      lists.ids[next[j]++] = i;
    });
  ParallelFor(vertices, [&](Index i)
    { std::sort(lists.ids.begin() + lists.offsets[i], lists.ids.begin() + lists.offsets[i + 1]); });
  return lists;
}
}

Polygons::Polygons(AdjacencyLists corners)
  : corners(std::move(corners))
{
  const auto size = static_cast<Index>(this->corners.offsets.size()) - 1;
  for (Index p = 0; p < size; ++p)
  {
    this->ofTriangle.insert(this->ofTriangle.end(), this->corners.Size(p) - 2, p);
  }
}

PolygonEdges EdgesOfPolygons(Index vertices, const Polygons& polygons, const Triangles& triangles)
{
  const AdjacencyLists all = NeighboursAlongEdges(vertices, polygons, triangles);
  PolygonEdges edges;
  edges.neighbours.offsets.reserve(vertices + 1);
  edges.boundary.offsets.reserve(vertices + 1);
  edges.neighbours.ids.reserve(all.ids.size() / 2);
  for (Index i = 0; i < vertices; ++i)
  {
    edges.neighbours.offsets.push_back(static_cast<Index>(edges.neighbours.ids.size()));
    edges.boundary.offsets.push_back(static_cast<Index>(edges.boundary.ids.size()));
    for (const Index* first = all.Begin(i); first != all.End(i);)
    {
      const Index* last = std::upper_bound(first, all.End(i), *first);
      edges.neighbours.ids.push_back(*first);
      if (last - first == 1)
      {
        edges.boundary.ids.push_back(*first);
      }
      first = last;
    }
  }
  edges.neighbours.offsets.push_back(static_cast<Index>(edges.neighbours.ids.size()));
  edges.boundary.offsets.push_back(static_cast<Index>(edges.boundary.ids.size()));
  return edges;
}
}
