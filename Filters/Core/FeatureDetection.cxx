// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FeatureDetection.h"

#include "Parallel.h"
#include "TriangleGeometry.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace lmo
{
namespace
{
constexpr double WorstQuality = 0.1;
constexpr Index FewestEdges = 10;

/// The neighbours j of each vertex i for which isChosen(i, j), in ascending order.
template <typename IsChosen>
AdjacencyLists ChooseEdges(const MeshTopology& topology, const IsChosen& isChosen)
{
  const AdjacencyLists& rings = topology.oneRings;
  Mask chosen(rings.ids.size());
  AdjacencyLists edges;
  edges.offsets.assign(topology.vertices + 1, 0);
  ParallelFor(topology.vertices,
    [&](Index i)
    {
      for (Index k = rings.offsets[i]; k < rings.offsets[i + 1]; ++k)
      {
        chosen[k] = isChosen(i, rings.ids[k]);
        edges.offsets[i + 1] += chosen[k];
      }
    });
  std::partial_sum(edges.offsets.begin(), edges.offsets.end(), edges.offsets.begin());
  edges.ids.reserve(edges.offsets.back());
  for (Index i = 0; i < topology.vertices; ++i)
  {
    for (Index k = rings.offsets[i]; k < rings.offsets[i + 1]; ++k)
    {
      if (chosen[k])
      {
        edges.ids.push_back(rings.ids[k]);
      }
    }
    std::sort(edges.ids.begin() + edges.offsets[i], edges.ids.end());
  }
  return edges;
}

/// The triangles of the edge between two vertices, at most three.
struct EdgeTriangles
{
  Index count = 0;
  Index triangles[3];
  bool areOpposite = false; ///< the first two run along the edge in opposite directions

  EdgeTriangles(const Triangles& T, const MeshTopology& topology, Index i, Index j)
  {
    Index ahead = 0;
    for (const Index* c = topology.cornersAt.Begin(i); c != topology.cornersAt.End(i); ++c)
    {
      const bool isAhead = T.data()[NextCorner(*c)] == j;
      if ((isAhead || T.data()[PreviousCorner(*c)] == j) && this->count < 3)
      {
        ahead += isAhead;
        this->triangles[this->count++] = *c / 3;
      }
    }
    this->areOpposite = this->count == 2 && ahead == 1;
  }
};

/// Drops the groups of connected edges that are too few to be a feature.
AdjacencyLists DropSmallGroups(const AdjacencyLists& edges, const MeshTopology& topology)
{
  const std::vector<Index> group = ConnectedComponents(edges);
  std::vector<Index> ends(group.size(), 0);
  for (Index i = 0; i < topology.vertices; ++i)
  {
    ends[group[i]] += edges.Size(i);
  }
  const auto contains = [&edges](Index i, Index j)
  { return std::binary_search(edges.Begin(i), edges.End(i), j); };
  return ChooseEdges(topology,
    [&](Index i, Index j) { return contains(i, j) && ends[group[i]] >= 2 * FewestEdges; });
}
}

AdjacencyLists DetectFeatureEdges(const Points& V, const Triangles& triangles,
  const MeshTopology& topology, const Vector& quality, double angle)
{
  const double cosine = std::cos(angle * Pi / 180);
  const AdjacencyLists sharp = ChooseEdges(topology,
    [&](Index i, Index j)
    {
      const EdgeTriangles edge(triangles, topology, i, j);
      if (edge.count == 1 || (edge.count == 2 && edge.areOpposite &&
                               std::min(quality[edge.triangles[0]], quality[edge.triangles[1]]) <
                                 WorstQuality))
      {
        return false;
      }
      return !edge.areOpposite ||
             ScaledNormal(V, triangles, edge.triangles[0])
                 .stableNormalized()
                 .dot(ScaledNormal(V, triangles, edge.triangles[1]).stableNormalized()) < cosine;
    });
  return DropSmallGroups(sharp, topology);
}

AdjacencyLists EdgesBetweenRegions(
  const Vector& labels, const Triangles& triangles, const MeshTopology& topology)
{
  return ChooseEdges(topology,
    [&](Index i, Index j)
    {
      const EdgeTriangles edge(triangles, topology, i, j);
      for (Index k = 1; k < edge.count; ++k)
      {
        if (labels[edge.triangles[k]] != labels[edge.triangles[0]])
        {
          return true;
        }
      }
      return false;
    });
}

AdjacencyLists EdgesBetweenTagged(const Vector& tags, const MeshTopology& topology)
{
  return ChooseEdges(topology, [&](Index i, Index j) { return tags[i] != 0 && tags[j] != 0; });
}

AdjacencyLists MergeEdges(const AdjacencyLists& a, const AdjacencyLists& b)
{
  AdjacencyLists merged;
  merged.offsets.assign(a.offsets.size(), 0);
  for (std::size_t i = 0; i + 1 < a.offsets.size(); ++i)
  {
    const auto vertex = static_cast<Index>(i);
    std::set_union(a.Begin(vertex), a.End(vertex), b.Begin(vertex), b.End(vertex),
      std::back_inserter(merged.ids));
    merged.offsets[i + 1] = static_cast<Index>(merged.ids.size());
  }
  return merged;
}
}
