// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Operators/Laplacian.h"

#include "Core/Base/Threading.h"

#include <algorithm>

namespace lmo
{
namespace
{
/// How many times too large the cotangents are; 1 for a triangle that is no needle.
double NeedleFactor(const Vector3& cotangents)
{
  constexpr double largestCotangent = 70;
  constexpr double largestShareOfCaps = 1. / 3; // of the obtuse angle's cotangent in the largest
  const double largest = cotangents.maxCoeff();
  const bool isCap = -cotangents.minCoeff() > largestShareOfCaps * largest;
  return isCap ? 1 : std::max(1.0, largest / largestCotangent);
}

Index RowCount(const AdjacencyLists& rings)
{
  return static_cast<Index>(rings.offsets.size()) - 1;
}

/// Eqn. 2: rows scaled by the reciprocal of their sum.
Vector NormalisedRows(const Laplacian& L)
{
  Vector rowScale(RowCount(*L.rings));
  ParallelFor(RowCount(*L.rings),
    [&](Index i)
    {
      const double sum = WeightSum(L, i);
      rowScale[i] = sum != 0 ? 1 / sum : 0;
    });
  return rowScale;
}

/// The angle across the edge to the next vertex is at the previous corner, and the other way round.
void SumFanCotangents(
  const MeshTopology& topology, Index i, const CornerValues& cotangents, double* row)
{
  const Index size = topology.oneRings.Size(i);
  const Index corners = topology.cornersAt.Size(i);
  double acrossPrevious = 0;
  for (Index k = 0; k < corners; ++k)
  {
    const Index corner = topology.cornersAt.Begin(i)[k];
    row[k] = acrossPrevious + cotangents.data()[PreviousCorner(corner)];
    acrossPrevious = cotangents.data()[NextCorner(corner)];
  }
  if (size > corners)
  {
    row[corners] = acrossPrevious;
  }
  else if (size > 0)
  {
    row[0] += acrossPrevious;
  }
}

/// The same where the corners are in any order.
void SumCotangents(const MeshTopology& topology, const Triangles& triangles, Index i,
  const CornerValues& cotangents, double* row)
{
  const Index* begin = topology.oneRings.Begin(i);
  const Index* end = topology.oneRings.End(i);
  const auto place = [&](Index id) { return std::lower_bound(begin, end, id) - begin; };
  std::fill(row, row + (end - begin), 0.0);
  for (const Index c : topology.cornersAt[i])
  {
    const Index next = NextCorner(c);
    const Index previous = PreviousCorner(c);
    row[place(triangles.data()[next])] += cotangents.data()[previous];
    row[place(triangles.data()[previous])] += cotangents.data()[next];
  }
}
}

Laplacian UniformLaplacian(std::shared_ptr<const AdjacencyLists> oneRings)
{
  Laplacian L{ std::move(oneRings), nullptr, {} };
  L.rowScale = NormalisedRows(L);
  return L;
}

std::shared_ptr<const Vector> CotangentEdgeWeights(
  const MeshTopology& topology, const Triangles& triangles, const CornerValues& cotangents)
{
  const AdjacencyLists& rings = topology.oneRings;
  auto weights = std::make_shared<Vector>(rings.ids.size());
  ParallelFor(topology.vertices,
    [&](Index i)
    {
      double* row = weights->data() + rings.offsets[i];
      if (topology.isFan[i])
      {
        SumFanCotangents(topology, i, cotangents, row);
      }
      else
      {
        SumCotangents(topology, triangles, i, cotangents, row);
      }
    });
  return weights;
}

std::shared_ptr<const Vector> ClampedEdgeWeights(
  const MeshTopology& topology, const Triangles& triangles, CornerValues cotangents)
{
  const Index needles = ParallelSum(static_cast<Index>(cotangents.rows()), Index(0),
    [&](Index& count, Index t)
    {
      const double factor = NeedleFactor(cotangents.row(t));
      cotangents.row(t) /= factor;
      count += factor > 1;
    });
  return needles > 0 ? CotangentEdgeWeights(topology, triangles, cotangents) : nullptr;
}

Laplacian CotangentLaplacian(
  std::shared_ptr<const AdjacencyLists> oneRings, std::shared_ptr<const Vector> edgeWeights)
{
  Laplacian L{ std::move(oneRings), std::move(edgeWeights), {} };
  L.rowScale = NormalisedRows(L);
  return L;
}

Laplacian MeanCurvatureLaplacian(std::shared_ptr<const AdjacencyLists> oneRings,
  std::shared_ptr<const Vector> edgeWeights, const Vector& voronoiAreas)
{
  return { std::move(oneRings), std::move(edgeWeights),
    (voronoiAreas.array() > 0).select(1 / (4 * voronoiAreas.array()), 0.0) };
}

double SquaredLengthScale(const Laplacian& meanCurvatureLaplacian, const Subdomain& subdomain)
{
  std::vector<double> scales;
  for (Index i = 0; i < RowCount(*meanCurvatureLaplacian.rings); ++i)
  {
    const double weightSum = WeightSum(meanCurvatureLaplacian, i);
    if (subdomain.OwnsVertex(i) && meanCurvatureLaplacian.rowScale[i] > 0 && weightSum > 0)
    {
      scales.push_back(1 / (meanCurvatureLaplacian.rowScale[i] * weightSum));
    }
  }
  return subdomain.Quantile(std::move(scales), 0.5);
}

double WeightSum(const Laplacian& L, Index i)
{
  const AdjacencyLists& rings = *L.rings;
  return L.edgeWeights ? L.edgeWeights->segment(rings.offsets[i], rings.Size(i)).sum()
                       : double(rings.Size(i));
}

Points Apply(const Laplacian& L, const Points& x)
{
  Points result(x.rows(), 3);
  ParallelFor(RowCount(*L.rings), [&](Index i) { result.row(i) = LaplacianRow(L, x, i); });
  return result;
}
}
