// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshTopology.h"

#include "Exceptions.h"
#include "Parallel.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace lmo
{
namespace
{
/// Turns the list sizes in offsets[1..] into offsets.
void AccumulateOffsets(std::vector<Index>& offsets)
{
  std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
}

AdjacencyLists BuildTrianglesAt(Index vertices, const Triangles& triangles)
{
  AdjacencyLists lists;
  lists.offsets.assign(vertices + 1, 0);
  const auto count = static_cast<Index>(triangles.rows());
  for (Index t = 0; t < count; ++t)
  {
    if (!IsCollapsed(triangles, t))
    {
      for (int corner = 0; corner < 3; ++corner)
      {
        ++lists.offsets[triangles(t, corner) + 1];
      }
    }
  }
  AccumulateOffsets(lists.offsets);
  lists.ids.resize(lists.offsets.back());
  std::vector<Index> next(lists.offsets.begin(), lists.offsets.end() - 1);
  for (Index t = 0; t < count; ++t)
  {
    if (!IsCollapsed(triangles, t))
    {
      for (int corner = 0; corner < 3; ++corner)
      {
        lists.ids[next[triangles(t, corner)]++] = t;
      }
    }
  }
  return lists;
}

/// The other two vertices of each triangle at vertex i, ascending: a neighbour appears once per
/// triangle of its edge.
void GatherNeighbours(
  const AdjacencyLists& trianglesAt, const Triangles& triangles, Index i, std::vector<Index>& ring)
{
  ring.clear();
  for (const Index* t = trianglesAt.Begin(i); t != trianglesAt.End(i); ++t)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      if (triangles(*t, corner) != i)
      {
        ring.push_back(triangles(*t, corner));
      }
    }
  }
  std::sort(ring.begin(), ring.end());
}

/// Calls visit(neighbour, triangles of the edge) for each distinct neighbour.
template <typename Visit>
void ForEachEdge(const std::vector<Index>& ring, const Visit& visit)
{
  for (auto first = ring.begin(); first != ring.end();)
  {
    const auto last = std::upper_bound(first, ring.end(), *first);
    visit(*first, last - first);
    first = last;
  }
}
}

Index AdjacencyLists::Find(Index i, Index id) const
{
  return static_cast<Index>(std::lower_bound(this->Begin(i), this->End(i), id) - this->Begin(i));
}

bool MeshTopology::IsClosed() const
{
  return !this->trianglesAt.ids.empty() && this->boundaryEdges.ids.empty();
}

MeshTopology BuildTopology(Index vertices, const Triangles& triangles)
{
  if (triangles.rows() > std::numeric_limits<Index>::max() / 6)
  {
    throw InputError(
      "The mesh has " + std::to_string(triangles.rows()) +
      " triangles, more than this filter can count. Split it, or use the parallel filter.");
  }
  MeshTopology topology;
  topology.vertices = vertices;
  topology.trianglesAt = BuildTrianglesAt(vertices, triangles);
  topology.isBoundary.assign(vertices, 0);
  topology.isUsed.assign(vertices, 0);
  topology.oneRings.offsets.assign(vertices + 1, 0);
  topology.boundaryEdges.offsets.assign(vertices + 1, 0);

  ParallelFor(vertices,
    [&](Index i)
    {
      thread_local std::vector<Index> ring;
      GatherNeighbours(topology.trianglesAt, triangles, i, ring);
      ForEachEdge(ring,
        [&](Index, std::ptrdiff_t trianglesAtEdge)
        {
          ++topology.oneRings.offsets[i + 1];
          topology.boundaryEdges.offsets[i + 1] += trianglesAtEdge == 1;
        });
      topology.isUsed[i] = !ring.empty();
      topology.isBoundary[i] = topology.boundaryEdges.offsets[i + 1] > 0;
    });
  AccumulateOffsets(topology.oneRings.offsets);
  AccumulateOffsets(topology.boundaryEdges.offsets);
  topology.oneRings.ids.resize(topology.oneRings.offsets.back());
  topology.boundaryEdges.ids.resize(topology.boundaryEdges.offsets.back());

  ParallelFor(vertices,
    [&](Index i)
    {
      thread_local std::vector<Index> ring;
      GatherNeighbours(topology.trianglesAt, triangles, i, ring);
      Index* neighbour = topology.oneRings.ids.data() + topology.oneRings.offsets[i];
      Index* boundary = topology.boundaryEdges.ids.data() + topology.boundaryEdges.offsets[i];
      ForEachEdge(ring,
        [&](Index j, std::ptrdiff_t trianglesAtEdge)
        {
          *neighbour++ = j;
          if (trianglesAtEdge == 1)
          {
            *boundary++ = j;
          }
        });
    });
  return topology;
}

std::vector<Index> ConnectedComponents(const AdjacencyLists& oneRings)
{
  const auto vertices = static_cast<Index>(oneRings.offsets.size()) - 1;
  std::vector<Index> component(vertices, -1);
  std::vector<Index> front;
  Index components = 0;
  for (Index seed = 0; seed < vertices; ++seed)
  {
    if (component[seed] >= 0)
    {
      continue;
    }
    component[seed] = components;
    front.assign(1, seed);
    while (!front.empty())
    {
      const Index i = front.back();
      front.pop_back();
      for (const Index* j = oneRings.Begin(i); j != oneRings.End(i); ++j)
      {
        if (component[*j] < 0)
        {
          component[*j] = components;
          front.push_back(*j);
        }
      }
    }
    ++components;
  }
  return component;
}
}
