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

AdjacencyLists BuildCornersAt(Index vertices, const Triangles& triangles)
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
        lists.ids[next[triangles(t, corner)]++] = 3 * t + corner;
      }
    }
  }
  return lists;
}

/// The neighbours of a vertex, and those across a boundary edge, both ascending.
class RingCollector
{
public:
  void Collect(const AdjacencyLists& cornersAt, const Triangles& triangles, Index i)
  {
    this->Next.clear();
    this->Previous.clear();
    for (const Index* corner = cornersAt.Begin(i); corner != cornersAt.End(i); ++corner)
    {
      this->Next.push_back(triangles.data()[NextCorner(*corner)]);
      this->Previous.push_back(triangles.data()[PreviousCorner(*corner)]);
    }
    SortShort(this->Next);
    SortShort(this->Previous);
    this->Boundary.clear();
    const bool isInside = this->Next == this->Previous && std::adjacent_find(this->Next.begin(),
                                                            this->Next.end()) == this->Next.end();
    if (!isInside)
    {
      this->CountTriangles();
    }
  }

  const std::vector<Index>& GetNeighbours() const { return this->Next; }
  const std::vector<Index>& GetBoundary() const { return this->Boundary; }

private:
  /// Insertion sort: one-rings are short, and std::sort takes twice as long for them.
  static void SortShort(std::vector<Index>& ids)
  {
    if (ids.size() > 32)
    {
      std::sort(ids.begin(), ids.end());
      return;
    }
    for (std::size_t k = 1; k < ids.size(); ++k)
    {
      const Index id = ids[k];
      std::size_t place = k;
      for (; place > 0 && ids[place - 1] > id; --place)
      {
        ids[place] = ids[place - 1];
      }
      ids[place] = id;
    }
  }

  /// At a boundary, where orientations differ and at non-manifold edges: a neighbour appears once
  /// for each triangle of its edge.
  void CountTriangles()
  {
    this->Next.insert(this->Next.end(), this->Previous.begin(), this->Previous.end());
    std::sort(this->Next.begin(), this->Next.end());
    std::size_t neighbours = 0;
    for (auto first = this->Next.begin(); first != this->Next.end();)
    {
      const auto last = std::upper_bound(first, this->Next.end(), *first);
      if (last - first == 1)
      {
        this->Boundary.push_back(*first);
      }
      this->Next[neighbours++] = *first;
      first = last;
    }
    this->Next.resize(neighbours);
  }

  std::vector<Index> Next;
  std::vector<Index> Previous;
  std::vector<Index> Boundary;
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
}

Index AdjacencyLists::Find(Index i, Index id) const
{
  const Index* begin = this->Begin(i);
  const Index size = this->Size(i);
  constexpr Index few = 16;
  if (size > few)
  {
    return static_cast<Index>(std::lower_bound(begin, begin + size, id) - begin);
  }
  Index place = 0;
  for (Index k = 0; k < size; ++k)
  {
    place += begin[k] < id; // no branch to mispredict
  }
  return place;
}

bool MeshTopology::IsClosed() const
{
  return !this->cornersAt.ids.empty() && this->boundaryEdges.ids.empty();
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
  topology.cornersAt = BuildCornersAt(vertices, triangles);
  topology.isBoundary.assign(vertices, 0);
  topology.isUsed.assign(vertices, 0);
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
        ring.Collect(topology.cornersAt, triangles, i);
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
