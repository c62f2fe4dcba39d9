// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Mesh/VertexOrder.h"

#include "Core/Base/Threading.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>

namespace lmo
{
namespace
{
/// Number of vertices whose data fill a processor's second-level cache.
constexpr std::int64_t CachedVertices = 16384;

std::vector<Index> Inverse(const std::vector<Index>& order)
{
  std::vector<Index> inverse(order.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    inverse[order[i]] = static_cast<Index>(i);
  }
  return inverse;
}

/// The triangles of each polygon one after the other, where the first of them is in the list.
std::vector<Index> GroupByPolygon(const std::vector<Index>& triangles, const Polygons& polygons)
{
  std::vector<Index> grouped;
  grouped.reserve(triangles.size());
  Mask isDone(polygons.Size(), 0);
  for (const Index triangle : triangles)
  {
    const Index p = polygons.ofTriangle[triangle];
    for (Index t = polygons.FirstTriangle(p); !isDone[p] && t < polygons.FirstTriangle(p + 1); ++t)
    {
      grouped.push_back(t);
    }
    isDone[p] = 1;
  }
  return grouped;
}
}

bool IsScattered(const Triangles& triangles)
{
  const std::int64_t distance = ParallelSum(static_cast<Index>(triangles.rows()), std::int64_t(0),
    [&](std::int64_t& sum, Index t)
    {
      for (int corner = 0; corner < 3; ++corner)
      {
        sum += std::abs(std::int64_t(triangles(t, corner)) - triangles(t, (corner + 1) % 3));
      }
    });
  return distance > CachedVertices * std::int64_t(triangles.size());
}

MeshOrder BreadthFirstOrder(Index vertices, const Triangles& triangles, const Polygons& polygons)
{
  const AdjacencyLists cornersAt = CornersAtVertices(vertices, triangles);
  MeshOrder order;
  order.vertices.reserve(vertices);
  order.triangles.reserve(triangles.rows());
  Mask isNumbered(vertices, 0);
  Mask isTriangleNumbered(triangles.rows(), 0);
  const auto number = [](std::vector<Index>& list, Mask& mask, Index id)
  {
    if (!mask[id])
    {
      mask[id] = 1;
      list.push_back(id);
    }
  };
  for (Index seed = 0; seed < vertices; ++seed)
  {
    std::size_t next = order.vertices.size();
    number(order.vertices, isNumbered, seed);
    for (; next < order.vertices.size(); ++next)
    {
      const Index i = order.vertices[next];
      for (const Index corner : cornersAt[i])
      {
        number(order.triangles, isTriangleNumbered, corner / 3);
        number(order.vertices, isNumbered, triangles.data()[NextCorner(corner)]);
        number(order.vertices, isNumbered, triangles.data()[PreviousCorner(corner)]);
      }
    }
  }
  for (Index t = 0; t < triangles.rows(); ++t) // degenerate ones are at no vertex
  {
    number(order.triangles, isTriangleNumbered, t);
  }
  if (!polygons.IsEmpty())
  {
    order.triangles = GroupByPolygon(order.triangles, polygons);
  }
  return order;
}

Triangles Renumber(const MeshOrder& order, const Triangles& triangles)
{
  const std::vector<Index> newNumber = Inverse(order.vertices);
  Triangles result(triangles.rows(), 3);
  ParallelFor(static_cast<Index>(triangles.rows()),
    [&](Index t)
    {
      for (int corner = 0; corner < 3; ++corner)
      {
        result(t, corner) = newNumber[triangles(order.triangles[t], corner)];
      }
    });
  return result;
}

Polygons Renumber(const MeshOrder& order, const Polygons& polygons)
{
  if (polygons.IsEmpty())
  {
    return {};
  }
  const std::vector<Index> newNumber = Inverse(order.vertices);
  AdjacencyLists corners;
  corners.offsets.push_back(0);
  corners.ids.reserve(polygons.corners.ids.size());
  for (const Index t : order.triangles)
  {
    if (polygons.IsFirstTriangle(t))
    {
      const Index p = polygons.ofTriangle[t];
      std::transform(polygons.corners.Begin(p), polygons.corners.End(p),
        std::back_inserter(corners.ids), [&](Index i) { return newNumber[i]; });
      corners.offsets.push_back(static_cast<Index>(corners.ids.size()));
    }
  }
  return Polygons(std::move(corners));
}
}
