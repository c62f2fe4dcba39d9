// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Mesh/MeshTopology.h"

#include "Core/Base/Exceptions.h"
#include "Core/Base/Threading.h"

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

/// The neighbours of a vertex, and those across a boundary edge.
class RingCollector
{
public:
  /// Puts the corners into the order of their fan if they form one. A closed fan starts at its
  /// lowest neighbour, so that the order of the triangles does not matter.
  void Collect(Index* corners, Index size, const Triangles& triangles)
  {
    this->Neighbours.clear();
    this->Boundary.clear();
    this->IsFan = size <= LargestFan && this->OrderFan(corners, size, triangles);
    if (!this->IsFan)
    {
      this->CountTriangles(corners, size, triangles);
    }
  }

  const std::vector<Index>& GetNeighbours() const { return this->Neighbours; }
  const std::vector<Index>& GetBoundary() const { return this->Boundary; }
  bool GetIsFan() const { return this->IsFan; }

private:
  static constexpr Index LargestFan = 16; ///< the search for successors is quadratic

  bool OrderFan(Index* corners, Index size, const Triangles& triangles)
  {
    Index next[LargestFan];
    Index previous[LargestFan];
    for (Index k = 0; k < size; ++k)
    {
      next[k] = triangles.data()[NextCorner(corners[k])];
      previous[k] = triangles.data()[PreviousCorner(corners[k])];
    }
    Index successor[LargestFan];
    Index start = static_cast<Index>(std::min_element(next, next + size) - next);
    Index equal = 0;
    for (Index k = 0; k < size; ++k)
    {
      Index place = -1;
      Index predecessors = 0;
      for (Index l = 0; l < size; ++l) // no branch to mispredict
      {
        place += (next[l] == previous[k]) * (l + 1);
        predecessors += previous[l] == next[k];
        equal += next[l] == next[k];
      }
      successor[k] = place;
      start = predecessors == 0 ? k : start;
    }
    if (equal != size) // an edge of several triangles, or orientations that differ
    {
      return false;
    }
    Index ordered[LargestFan];
    Index count = 0;
    Index k = start;
    while (count < size && k >= 0 && (count == 0 || k != start))
    {
      this->Neighbours.push_back(next[k]);
      ordered[count++] = k;
      k = successor[k];
    }
    if (count < size || (k >= 0 && k != start)) // several fans
    {
      return false;
    }
    if (k < 0)
    {
      const Index last = previous[ordered[count - 1]];
      this->Boundary = { std::min(this->Neighbours[0], last), std::max(this->Neighbours[0], last) };
      this->Neighbours.push_back(last);
    }
    std::transform(ordered, ordered + size, ordered, [&](Index place) { return corners[place]; });
    std::copy(ordered, ordered + size, corners);
    return true;
  }

  /// A neighbour appears once for each triangle of its edge.
  void CountTriangles(const Index* corners, Index size, const Triangles& triangles)
  {
    this->Neighbours.clear();
    for (Index k = 0; k < size; ++k)
    {
      this->Neighbours.push_back(triangles.data()[NextCorner(corners[k])]);
      this->Neighbours.push_back(triangles.data()[PreviousCorner(corners[k])]);
    }
    std::sort(this->Neighbours.begin(), this->Neighbours.end());
    std::size_t neighbours = 0;
    for (auto first = this->Neighbours.begin(); first != this->Neighbours.end();)
    {
      const auto last = std::upper_bound(first, this->Neighbours.end(), *first);
      if (last - first == 1)
      {
        this->Boundary.push_back(*first);
      }
      this->Neighbours[neighbours++] = *first;
      first = last;
    }
    this->Neighbours.resize(neighbours);
  }

  std::vector<Index> Neighbours;
  std::vector<Index> Boundary;
  bool IsFan = false;
};

/// Lists collected for a range of vertices, until it is known where they belong.
struct RangeOfLists
{
  std::vector<Index> neighbours;
  std::vector<Index> boundary;
};

void Place(const std::vector<RangeOfLists>& ranges, std::vector<Index> RangeOfLists::*ids,
  AdjacencyLists& lists)
{
  AccumulateOffsets(lists.offsets);
  lists.ids.resize(lists.offsets.back());
  for (std::size_t block = 0; block < ranges.size(); ++block)
  {
    const std::vector<Index>& source = ranges[block].*ids;
    if (!source.empty())
    {
      std::copy(
        source.begin(), source.end(), lists.ids.begin() + lists.offsets[block * ParallelBlock]);
    }
  }
}

/// Sets the edges of a mesh whose cells are its triangles, and sorts the corners of fans.
void FindTriangleEdges(const Triangles& triangles, MeshTopology& topology)
{
  const Index vertices = topology.vertices;
  topology.oneRings.offsets.assign(vertices + 1, 0);
  topology.boundaryEdges.offsets.assign(vertices + 1, 0);
  std::vector<RangeOfLists> ranges(vertices / ParallelBlock + 1);
  ParallelRanges(vertices,
    [&](Index begin, Index end)
    {
      RangeOfLists& range = ranges[begin / ParallelBlock];
      range.neighbours.reserve(7 * std::size_t(end - begin));
      RingCollector ring;
      for (Index i = begin; i < end; ++i)
      {
        ring.Collect(topology.cornersAt.ids.data() + topology.cornersAt.offsets[i],
          topology.cornersAt.Size(i), triangles);
        topology.isFan[i] = ring.GetIsFan();
        const std::vector<Index>& neighbours = ring.GetNeighbours();
        const std::vector<Index>& boundary = ring.GetBoundary();
        range.neighbours.insert(range.neighbours.end(), neighbours.begin(), neighbours.end());
        range.boundary.insert(range.boundary.end(), boundary.begin(), boundary.end());
        topology.oneRings.offsets[i + 1] = static_cast<Index>(neighbours.size());
        topology.boundaryEdges.offsets[i + 1] = static_cast<Index>(boundary.size());
        topology.isUsed[i] = !neighbours.empty();
        topology.isBoundary[i] = !boundary.empty();
      }
    });
  Place(ranges, &RangeOfLists::neighbours, topology.oneRings);
  Place(ranges, &RangeOfLists::boundary, topology.boundaryEdges);
}

void FindPolygonEdges(const Triangles& triangles, MeshTopology& topology)
{
  PolygonEdges edges = EdgesOfPolygons(topology.vertices, topology.polygons, triangles);
  topology.oneRings = std::move(edges.neighbours);
  topology.boundaryEdges = std::move(edges.boundary);
  for (Index i = 0; i < topology.vertices; ++i)
  {
    topology.isUsed[i] = topology.cornersAt.Size(i) > 0;
    topology.isBoundary[i] = topology.boundaryEdges.Size(i) > 0;
  }
}
}

AdjacencyLists CornersAtVertices(Index vertices, const Triangles& triangles)
{
  AdjacencyLists lists;
  lists.offsets.assign(vertices + 1, 0);
  const auto count = static_cast<Index>(triangles.rows());
  for (Index t = 0; t < count; ++t)
  {
    if (!IsDegenerate(triangles, t))
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
    if (!IsDegenerate(triangles, t))
    {
      for (int corner = 0; corner < 3; ++corner)
      {
        lists.ids[next[triangles(t, corner)]++] = 3 * t + corner;
      }
    }
  }
  return lists;
}

bool MeshTopology::IsClosed() const
{
  return !this->cornersAt.ids.empty() && this->boundaryEdges.ids.empty();
}

MeshTopology BuildTopology(Index vertices, const Triangles& triangles, Polygons polygons)
{
  if (triangles.rows() > std::numeric_limits<Index>::max() / 6)
  {
    throw InputError(
      "The mesh has " + std::to_string(triangles.rows()) +
      " triangles, more than this filter can count. Split it, or use the parallel filter.");
  }
  MeshTopology topology;
  topology.vertices = vertices;
  topology.polygons = std::move(polygons);
  topology.cornersAt = CornersAtVertices(vertices, triangles);
  topology.isBoundary.assign(vertices, 0);
  topology.isUsed.assign(vertices, 0);
  topology.isFan.assign(vertices, 0);
  if (topology.polygons.IsEmpty())
  {
    FindTriangleEdges(triangles, topology);
  }
  else
  {
    FindPolygonEdges(triangles, topology);
  }
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
      for (const Index j : oneRings[i])
      {
        if (component[j] < 0)
        {
          component[j] = components;
          front.push_back(j);
        }
      }
    }
    ++components;
  }
  return component;
}
}
