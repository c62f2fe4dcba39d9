// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Mesh/FeatureDetection.h"

#include "Core/Base/Threading.h"
#include "Core/Mesh/FeatureLines.h"
#include "Core/Mesh/TriangleGeometry.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace lmo
{
namespace
{
constexpr double WorstQuality = 0.1;
constexpr Index FewestEdges = 10;
constexpr double FlatShare = 0.25; ///< of the angle, below which edges are flat

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
    if (topology.cornersAt.Size(i) > topology.cornersAt.Size(j))
    {
      std::swap(i, j);
    }
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

/// Angle between the normals of an edge's triangles, in radians, or a straight one if there are not
/// two that agree in their orientation.
double DihedralAngle(const Points& V, const Triangles& T, const EdgeTriangles& edge)
{
  if (!edge.areOpposite)
  {
    return Pi;
  }
  const Vector3 a = ScaledNormal(V, T, edge.triangles[0]).stableNormalized();
  const Vector3 b = ScaledNormal(V, T, edge.triangles[1]).stableNormalized();
  return std::acos(std::clamp(a.dot(b), -1.0, 1.0));
}

bool Contains(const AdjacencyLists& edges, Index i, Index j)
{
  return std::binary_search(edges.Begin(i), edges.End(i), j);
}

/// Connected edges.
struct Group
{
  Index ends = 0; ///< twice the number of edges
  Index corners = 0;
  Index inner = 0; ///< vertices inside lines
  double angleBeside = 0;
  Index beside = 0; ///< other edges at the vertices

  bool IsFeature(double angle) const
  {
    const bool isLine = 4 * this->corners <= this->inner;
    const bool isBesideFlat = this->angleBeside < FlatShare * angle * this->beside;
    return this->ends >= 2 * FewestEdges && (isLine || isBesideFlat);
  }
};

/// Drops the groups of connected edges that are no feature.
AdjacencyLists DropNoise(const AdjacencyLists& edges, const Points& V, const Triangles& triangles,
  const MeshTopology& topology, double angle)
{
  const std::vector<Index> groupOf = ConnectedComponents(edges);
  const FeatureLines lines = ClassifyLines(std::make_shared<AdjacencyLists>(edges), V);
  std::vector<Group> groups(topology.vertices);
  for (Index i = 0; i < topology.vertices; ++i)
  {
    if (edges.Size(i) > 0)
    {
      Group& group = groups[groupOf[i]];
      group.ends += edges.Size(i);
      group.corners += lines.pointClass[i] == FeatureLines::CORNER;
      group.inner += lines.pointClass[i] == FeatureLines::EDGE;
      for (const Index* j = topology.oneRings.Begin(i); j != topology.oneRings.End(i); ++j)
      {
        if (!Contains(edges, i, *j))
        {
          group.angleBeside +=
            DihedralAngle(V, triangles, EdgeTriangles(triangles, topology, i, *j));
          ++group.beside;
        }
      }
    }
  }
  return ChooseEdges(topology,
    [&](Index i, Index j) { return Contains(edges, i, j) && groups[groupOf[i]].IsFeature(angle); });
}
}

AdjacencyLists DetectFeatureEdges(const Points& V, const Triangles& triangles,
  const MeshTopology& topology, const Vector& quality, double angle)
{
  const double radians = angle * Pi / 180;
  const AdjacencyLists sharp = ChooseEdges(topology,
    [&](Index i, Index j)
    {
      const EdgeTriangles edge(triangles, topology, i, j);
      const bool isBoundary = edge.count == 1;
      const bool isBad = edge.areOpposite && std::min(quality[edge.triangles[0]],
                                               quality[edge.triangles[1]]) < WorstQuality;
      return !isBoundary && !isBad && DihedralAngle(V, triangles, edge) > radians;
    });
  return DropNoise(sharp, V, triangles, topology, radians);
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
