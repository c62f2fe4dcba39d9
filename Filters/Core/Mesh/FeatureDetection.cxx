// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Mesh/FeatureDetection.h"

#include "Core/Base/Threading.h"
#include "Core/Mesh/FeatureLines.h"
#include "Core/Mesh/SurfaceNormals.h"
#include "Core/Mesh/TriangleGeometry.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace lmo
{
namespace
{
constexpr Index FewestEdges = 10;                  ///< of a line that ends somewhere on the surface
constexpr double FlatShare = 0.25;                 ///< of the angle, below which edges are flat
constexpr double FlatSharePerEnd = FlatShare / 40; ///< the same for small groups of edges
constexpr double PlaneShare = 0.025; ///< of the angle, below which edges lie in a plane

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
    for (const Index c : topology.cornersAt[i])
    {
      const bool isAhead = T.data()[NextCorner(c)] == j;
      if ((isAhead || T.data()[PreviousCorner(c)] == j) && this->count < 3)
      {
        ahead += isAhead;
        this->triangles[this->count++] = c / 3;
      }
    }
    this->areOpposite = this->count == 2 && ahead == 1;
  }
};

/// The angles at which the surface turns at its edges, in radians.
class EdgeAngles
{
public:
  EdgeAngles(const Points& V, const Triangles& triangles, const MeshTopology& topology,
    const Vector& quality, double angle, const Subdomain& subdomain)
    : T(triangles)
    , Topology(topology)
    , Normals(V, triangles, topology, quality, angle, subdomain)
  {
  }

  /// A straight angle if there are not two triangles that agree in their orientation.
  double operator()(Index i, Index j) const { return this->Of({ this->T, this->Topology, i, j }); }

  /// True if the edge turns by more than an angle, whatever round-off does to the coordinates.
  bool IsSharp(Index i, Index j, double angle) const
  {
    const EdgeTriangles edge(this->T, this->Topology, i, j);
    const double error =
      edge.areOpposite ? this->Normals.Error(edge.triangles[0], edge.triangles[1]) : 0;
    return edge.count > 1 && this->Of(edge) - error > angle;
  }

  bool IsBesideThin(Index i, Index j) const
  {
    const EdgeTriangles edge(this->T, this->Topology, i, j);
    return std::any_of(edge.triangles, edge.triangles + edge.count,
      [&](Index t) { return this->Normals.IsThin(t); });
  }

private:
  double Of(const EdgeTriangles& edge) const
  {
    return edge.areOpposite ? this->Normals.Angle(edge.triangles[0], edge.triangles[1]) : Pi;
  }

  const Triangles& T;
  const MeshTopology& Topology;
  const SurfaceNormals Normals;
};

bool Contains(const AdjacencyLists& edges, Index i, Index j)
{
  return std::binary_search(edges.Begin(i), edges.End(i), j);
}

/// True if the edges at corner i of triangle t that are not its own would pin it.
bool IsPinnedWithout(
  const AdjacencyLists& edges, const Points& V, const Triangles& triangles, Index t, Index i)
{
  Index others[2];
  Index count = 0;
  for (const Index j : edges[i])
  {
    if (j != triangles(t, 0) && j != triangles(t, 1) && j != triangles(t, 2))
    {
      others[count++ % 2] = j;
    }
  }
  return count > 0 && (count != 2 || !IsSmoothTurn(V, others[0], i, others[1]));
}

/// Drops the edges at corners that are features of a triangle's own making.
AdjacencyLists DropOwnCorners(const AdjacencyLists& edges, const Points& V,
  const Triangles& triangles, const MeshTopology& topology)
{
  Eigen::Matrix<unsigned char, Eigen::Dynamic, 3, Eigen::RowMajor> isOwn(triangles.rows(), 3);
  ParallelFor(static_cast<Index>(triangles.rows()),
    [&](Index t)
    {
      bool isClosed = !IsDegenerate(triangles, t);
      for (int k = 0; k < 3; ++k)
      {
        isClosed = isClosed && Contains(edges, triangles(t, k), triangles(t, (k + 1) % 3));
      }
      for (int k = 0; k < 3; ++k)
      {
        isOwn(t, k) = isClosed && !IsPinnedWithout(edges, V, triangles, t, triangles(t, k));
      }
    });
  return ChooseEdges(topology,
    [&](Index i, Index j)
    {
      const auto isAtOwnCorner = [&](Index t)
      {
        for (int k = 0; k < 3; ++k)
        {
          if (isOwn(t, k) && (triangles(t, k) == i || triangles(t, k) == j))
          {
            return true;
          }
        }
        return false;
      };
      if (!Contains(edges, i, j))
      {
        return false;
      }
      const EdgeTriangles edge(triangles, topology, i, j);
      return std::none_of(edge.triangles, edge.triangles + edge.count, isAtOwnCorner);
    });
}

/// What is counted of connected edges.
enum Tally
{
  ENDS,         ///< twice the number of edges
  SOLID_ENDS,   ///< the same without those beside thin triangles
  FREE_ENDS,    ///< vertices at which a line ends inside the surface
  JUNCTIONS,    ///< vertices of more than two edges
  CORNERS,      ///< vertices
  INNER,        ///< vertices inside lines
  ANGLE_BESIDE, ///< sum over the other edges at the vertices
  BESIDE,       ///< number of these
  IN_PLANES,    ///< those of them that lie in a plane
  TALLIES
};

/// \param group a row of tallies
template <typename Tallies>
bool IsFeature(const Tallies& group, double angle)
{
  const bool isWhole = group[FREE_ENDS] == 0;
  const bool isLoop = isWhole && group[JUNCTIONS] == 0;
  const bool isLine = 4 * group[CORNERS] <= group[INNER];
  const double flat = isLoop ? FlatShare : std::min(FlatShare, group[ENDS] * FlatSharePerEnd);
  const bool isBesideFlat = group[ANGLE_BESIDE] < flat * angle * group[BESIDE];
  const bool isBesidePlanes = 2 * group[IN_PLANES] >= group[BESIDE];
  return (isWhole || group[SOLID_ENDS] >= 2 * FewestEdges) &&
         (isLine || isBesideFlat || isBesidePlanes);
}

/// The tallies of each connected component of the edges.
Eigen::ArrayXXd CountGroups(const AdjacencyLists& edges, const std::vector<Index>& groupOf,
  const FeatureLines& lines, const MeshTopology& topology, const EdgeAngles& angles, double angle,
  const Subdomain& subdomain)
{
  const Index count = groupOf.empty() ? 0 : *std::max_element(groupOf.begin(), groupOf.end()) + 1;
  Eigen::ArrayXXd groups = Eigen::ArrayXXd::Zero(count, TALLIES);
  for (Index i = 0; i < topology.vertices; ++i)
  {
    if (edges.Size(i) > 0 && subdomain.OwnsVertex(i))
    {
      auto group = groups.row(groupOf[i]);
      group[ENDS] += edges.Size(i);
      group[FREE_ENDS] += edges.Size(i) == 1 && !topology.isBoundary[i];
      group[SOLID_ENDS] += static_cast<double>(std::count_if(
        edges.Begin(i), edges.End(i), [&](Index j) { return !angles.IsBesideThin(i, j); }));
      group[JUNCTIONS] += edges.Size(i) > 2;
      group[CORNERS] += lines.pointClass[i] == FeatureLines::CORNER;
      group[INNER] += lines.pointClass[i] == FeatureLines::EDGE;
      for (const Index j : topology.oneRings[i])
      {
        if (!Contains(edges, i, j))
        {
          const double angleBeside = angles(i, j);
          group[ANGLE_BESIDE] += angleBeside;
          group[IN_PLANES] += angleBeside < PlaneShare * angle;
          ++group[BESIDE];
        }
      }
    }
  }
  subdomain.SumOverComponents(groupOf, groups);
  return groups;
}

/// Drops the groups of connected edges that are no feature.
AdjacencyLists DropNoise(const AdjacencyLists& edges, const Points& V, const MeshTopology& topology,
  const EdgeAngles& angles, double angle, const Subdomain& subdomain)
{
  const std::vector<Index> groupOf = ConnectedComponents(edges);
  const FeatureLines lines = ClassifyLines(std::make_shared<AdjacencyLists>(edges), V);
  const Eigen::ArrayXXd groups =
    CountGroups(edges, groupOf, lines, topology, angles, angle, subdomain);
  return ChooseEdges(topology, [&](Index i, Index j)
    { return Contains(edges, i, j) && IsFeature(groups.row(groupOf[i]), angle); });
}
}

AdjacencyLists DetectFeatureEdges(const Points& V, const Triangles& triangles,
  const MeshTopology& topology, const Vector& quality, double angle, const Subdomain& subdomain)
{
  const double radians = angle * Pi / 180;
  const EdgeAngles angles(V, triangles, topology, quality, radians, subdomain);
  const AdjacencyLists sharp =
    ChooseEdges(topology, [&](Index i, Index j) { return angles.IsSharp(i, j, radians); });
  return DropNoise(
    DropOwnCorners(sharp, V, triangles, topology), V, topology, angles, radians, subdomain);
}

AdjacencyLists EdgesBetweenLabels(
  const TriangleLabels& labels, const Triangles& triangles, const MeshTopology& topology)
{
  return ChooseEdges(topology,
    [&](Index i, Index j)
    {
      const EdgeTriangles edge(triangles, topology, i, j);
      for (Index k = 1; k < edge.count; ++k)
      {
        if (labels.row(edge.triangles[k]) != labels.row(edge.triangles[0]))
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
