// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Operators/RobustLaplacian.h"

#include "Core/Operators/IntrinsicTriangulation.h"

#include <algorithm>
#include <utility>

namespace lmo
{
namespace
{
using Neighbour = std::pair<Index, double>;

/// Adds up the weights of the edges to the same neighbour. Both ends of an edge have them in one
/// order, so that the sums are equal to the last digit.
void MergeEqual(std::vector<Neighbour>& neighbours)
{
  const auto isBefore = [](const Neighbour& a, const Neighbour& b) { return a.first < b.first; };
  std::stable_sort(neighbours.begin(), neighbours.end(), isBefore);
  std::size_t count = 0;
  for (const Neighbour& next : neighbours)
  {
    if (count > 0 && neighbours[count - 1].first == next.first)
    {
      neighbours[count - 1].second += next.second;
    }
    else
    {
      neighbours[count++] = next;
    }
  }
  neighbours.resize(count);
}
}

CotangentParts ComputeRobustWeights(const Points& V, const Triangles& triangles)
{
  IntrinsicTriangulation surface = TuftedCover(V, triangles);
  Mollify(surface);
  FlipToDelaunay(surface);

  std::vector<std::vector<Neighbour>> neighbours(V.rows());
  CotangentParts result;
  result.voronoiAreas = Vector::Zero(V.rows());
  for (Index side = 0; side < surface.Size(); ++side)
  {
    const Index twin = surface.twins[side];
    if (side < twin)
    {
      const Index i = surface.tails[side];
      const Index j = surface.tails[twin];
      const double weight = std::max(0.0, surface.CotangentSum(side)) / 2;
      const double length = surface.lengths[side] * surface.unit;
      result.voronoiAreas[i] += weight * length * length / 8;
      result.voronoiAreas[j] += weight * length * length / 8;
      if (i != j)
      {
        neighbours[i].emplace_back(j, weight);
        neighbours[j].emplace_back(i, weight);
      }
    }
  }

  auto rings = std::make_shared<AdjacencyLists>();
  rings->offsets.push_back(0);
  std::vector<double> weights;
  for (std::vector<Neighbour>& ring : neighbours)
  {
    MergeEqual(ring);
    for (const auto& [j, weight] : ring)
    {
      rings->ids.push_back(j);
      weights.push_back(weight);
    }
    rings->offsets.push_back(static_cast<Index>(rings->ids.size()));
  }
  result.rings = std::move(rings);
  result.edgeWeights = std::make_shared<Vector>(
    Eigen::Map<const Vector>(weights.data(), Eigen::Index(weights.size())));
  return result;
}
}
