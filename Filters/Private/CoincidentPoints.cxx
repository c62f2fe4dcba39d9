// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CoincidentPoints.h"

#include "Core/Base/Threading.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <utility>

namespace lmo
{
namespace
{
bool HaveSameCoordinates(const Points& V, Index i, Index j)
{
  return V.row(i) == V.row(j);
}

/// Points whose coordinates fall in the same bucket of a hash table as those of another one: few
/// where no two are the same, so that not all need sorting.
std::vector<Index> PointsThatShareBuckets(const Points& V)
{
  std::size_t buckets = 1;
  while (buckets < 16 * static_cast<std::size_t>(V.rows()))
  {
    buckets *= 2;
  }
  const std::hash<double> hash;
  std::vector<std::size_t> bucketOf(V.rows());
  ParallelFor(static_cast<Index>(V.rows()),
    [&](Index i)
    {
      constexpr std::size_t factor = 31;
      bucketOf[i] =
        ((hash(V(i, 0)) * factor + hash(V(i, 1))) * factor + hash(V(i, 2))) & (buckets - 1);
    });
  std::vector<bool> isUsed(buckets, false);
  std::vector<bool> isShared(buckets, false);
  for (const std::size_t bucket : bucketOf)
  {
    isShared[bucket] = isUsed[bucket];
    isUsed[bucket] = true;
  }
  std::vector<Index> points;
  for (Index i = 0; i < static_cast<Index>(V.rows()); ++i)
  {
    if (isShared[bucketOf[i]])
    {
      points.push_back(i);
    }
  }
  return points;
}
}

std::vector<Index> PointsWithTwins(const Points& V)
{
  std::vector<Index> points = PointsThatShareBuckets(V);
  std::sort(points.begin(), points.end(),
    [&](Index i, Index j)
    {
      for (int c = 0; c < 3; ++c)
      {
        if (V(i, c) != V(j, c))
        {
          return V(i, c) < V(j, c);
        }
      }
      return i < j;
    });
  std::vector<Index> twins;
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    const bool hasPrevious = k > 0 && HaveSameCoordinates(V, points[k - 1], points[k]);
    const bool hasNext = k + 1 < points.size() && HaveSameCoordinates(V, points[k], points[k + 1]);
    if (hasPrevious || hasNext)
    {
      twins.push_back(points[k]);
    }
  }
  return twins;
}

bool IsOnBoundary(const AdjacencyLists& cornersAt, const Triangles& triangles, Index point)
{
  std::vector<Index> neighbours;
  for (const Index corner : cornersAt[point])
  {
    neighbours.push_back(triangles.data()[NextCorner(corner)]);
    neighbours.push_back(triangles.data()[PreviousCorner(corner)]);
  }
  std::sort(neighbours.begin(), neighbours.end());
  for (auto first = neighbours.begin(); first != neighbours.end();)
  {
    const auto last = std::upper_bound(first, neighbours.end(), *first);
    if (last - first == 1)
    {
      return true;
    }
    first = last;
  }
  return false;
}

std::vector<Index> FindCoincidentBoundaryPoints(const Points& V, const Triangles& triangles)
{
  std::vector<Index> candidates = PointsWithTwins(V);
  if (candidates.empty())
  {
    return {};
  }
  const auto size = static_cast<Index>(V.rows());
  const AdjacencyLists cornersAt = CornersAtVertices(size, triangles);
  candidates.erase(std::remove_if(candidates.begin(), candidates.end(),
                     [&](Index i) { return !IsOnBoundary(cornersAt, triangles, i); }),
    candidates.end());
  std::vector<Index> vertices(size);
  std::iota(vertices.begin(), vertices.end(), Index(0));
  bool hasTwins = false;
  for (std::size_t k = 1; k < candidates.size(); ++k)
  {
    if (HaveSameCoordinates(V, candidates[k - 1], candidates[k]))
    {
      vertices[candidates[k]] = vertices[candidates[k - 1]];
      hasTwins = true;
    }
  }
  return hasTwins ? vertices : std::vector<Index>();
}
}
