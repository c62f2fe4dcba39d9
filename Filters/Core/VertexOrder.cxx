// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "VertexOrder.h"

#include "Parallel.h"

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
}

bool IsScattered(const AdjacencyLists& oneRings)
{
  const auto vertices = static_cast<Index>(oneRings.offsets.size()) - 1;
  const std::int64_t distance = ParallelSum(vertices, std::int64_t(0),
    [&](std::int64_t& sum, Index i)
    {
      for (const Index* j = oneRings.Begin(i); j != oneRings.End(i); ++j)
      {
        sum += std::abs(std::int64_t(i) - *j);
      }
    });
  return distance > CachedVertices * std::int64_t(oneRings.ids.size());
}

MeshOrder BreadthFirstOrder(const AdjacencyLists& oneRings, const Triangles& triangles)
{
  const auto vertices = static_cast<Index>(oneRings.offsets.size()) - 1;
  MeshOrder order;
  order.vertices.reserve(vertices);
  Mask isNumbered(vertices, 0);
  for (Index seed = 0; seed < vertices; ++seed)
  {
    if (isNumbered[seed])
    {
      continue;
    }
    isNumbered[seed] = 1;
    order.vertices.push_back(seed);
    for (std::size_t next = order.vertices.size() - 1; next < order.vertices.size(); ++next)
    {
      const Index i = order.vertices[next];
      for (const Index* j = oneRings.Begin(i); j != oneRings.End(i); ++j)
      {
        if (!isNumbered[*j])
        {
          isNumbered[*j] = 1;
          order.vertices.push_back(*j);
        }
      }
    }
  }

  const std::vector<Index> newNumber = Inverse(order.vertices);
  const auto firstVertex = [&](Index t)
  {
    return std::min(
      { newNumber[triangles(t, 0)], newNumber[triangles(t, 1)], newNumber[triangles(t, 2)] });
  };
  std::vector<Index> next(vertices + 1, 0);
  for (Index t = 0; t < triangles.rows(); ++t)
  {
    ++next[firstVertex(t) + 1];
  }
  std::partial_sum(next.begin(), next.end(), next.begin());
  order.triangles.resize(triangles.rows());
  for (Index t = 0; t < triangles.rows(); ++t)
  {
    order.triangles[next[firstVertex(t)]++] = t;
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
}
