// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Operators/NormalFilter.h"

#include "Core/Base/Threading.h"
#include "Core/Mesh/TriangleGeometry.h"

#include <algorithm>
#include <cmath>

namespace lmo
{
namespace
{
/// Calls visit(neighbour) once for each triangle that shares a vertex of no high valence with t.
template <typename Visit>
void ForEachAround(
  const Triangles& triangles, const MeshTopology& topology, Index t, const Visit& visit)
{
  const AdjacencyLists& cornersAt = topology.cornersAt;
  const auto isNear = [&](Index neighbour, Index i)
  {
    return !topology.HasHighValence(i) &&
           (triangles(neighbour, 0) == i || triangles(neighbour, 1) == i ||
             triangles(neighbour, 2) == i);
  };
  for (int k = 0; k < 3; ++k)
  {
    const Index i = triangles(t, k);
    if (topology.HasHighValence(i))
    {
      continue;
    }
    for (const Index corner : cornersAt[i])
    {
      const Index neighbour = corner / 3;
      const bool isVisited = (k > 0 && isNear(neighbour, triangles(t, 0))) ||
                             (k > 1 && isNear(neighbour, triangles(t, 1)));
      if (neighbour != t && !isVisited)
      {
        visit(neighbour);
      }
    }
  }
}

/// Mean distance of the centroids of neighbours.
double MeanDistance(
  const Points& centroids, const Triangles& triangles, const MeshTopology& topology)
{
  const Eigen::Array2d sum =
    ParallelSum(static_cast<Index>(triangles.rows()), Eigen::Array2d(Eigen::Array2d::Zero()),
      [&](Eigen::Array2d& partial, Index t)
      {
        ForEachAround(triangles, topology, t,
          [&](Index neighbour)
          {
            partial[0] += (centroids.row(neighbour) - centroids.row(t)).norm();
            partial[1] += 1;
          });
      });
  return sum[1] > 0 ? sum[0] / sum[1] : 0;
}
}

Points FilterNormals(const Points& V, const Triangles& triangles, const MeshTopology& topology,
  int iterations, double width, ProgressMonitor& monitor)
{
  const auto count = static_cast<Index>(triangles.rows());
  Points centroids(count, 3);
  Points normals(count, 3);
  Vector areas(count);
  ParallelFor(count,
    [&](Index t)
    {
      const Vector3 normal = ScaledNormal(V, triangles, t);
      centroids.row(t) =
        (V.row(triangles(t, 0)) + V.row(triangles(t, 1)) + V.row(triangles(t, 2))) / 3;
      normals.row(t) = normal.stableNormalized();
      areas[t] = 0.5 * normal.norm();
    });
  const double distance = MeanDistance(centroids, triangles, topology);
  const double likeness = 0.5 / std::max(width * width, 1e-300); // finite
  const double nearness = distance > 0 ? 0.5 / (distance * distance) : 0;
  Points filtered(count, 3);
  for (int iteration = 0; iteration < iterations; ++iteration)
  {
    monitor.Report(double(iteration) / iterations);
    ParallelFor(count,
      [&](Index t)
      {
        Vector3 sum = areas[t] * normals.row(t);
        ForEachAround(triangles, topology, t,
          [&](Index neighbour)
          {
            const double exponent =
              nearness * (centroids.row(neighbour) - centroids.row(t)).squaredNorm() +
              likeness * (normals.row(neighbour) - normals.row(t)).squaredNorm();
            sum += areas[neighbour] * std::exp(-exponent) * normals.row(neighbour);
          });
        filtered.row(t) = sum.stableNormalized();
      });
    std::swap(normals, filtered);
  }
  return normals;
}
}
