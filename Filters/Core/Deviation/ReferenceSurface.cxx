// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Deviation/ReferenceSurface.h"

#include "Core/Base/Threading.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace lmo
{
namespace
{
/// Points at which a triangle is sampled: those of a grid of so many edges along a side.
constexpr int SamplesAlongSide = 6;

/// By how much a limit exceeds the largest distance of these points at first, in terms of it;
/// doubled until the triangle can be certified.
constexpr double FirstExcess = 1e-3;

/// Of squared distances.
constexpr double RoundOff = 1e-12;

double LargestSampledDistance(const TriangleCorners& triangle, const TriangleBvh& tree)
{
  double largest = 0;
  for (int i = 0; i <= SamplesAlongSide; ++i)
  {
    for (int j = 0; i + j <= SamplesAlongSide; ++j)
    {
      const Vector3 weights(i, j, SamplesAlongSide - i - j);
      const Vector3 x = weights / SamplesAlongSide * triangle;
      largest = std::max(largest, tree.FindClosest(x).squaredDistance);
    }
  }
  return std::sqrt(largest);
}
}

DistanceLimits CertifyInput(DeviationCertificates& certificates, const SurfaceView& from,
  const Mask& isSettled, const SurfaceView& to, TriangleBvh& tree, double distance,
  ProgressMonitor& monitor)
{
  DistanceLimits limits(distance, static_cast<Index>(from.T.rows()));
  std::vector<Index> open(tree.IsEmpty() ? 0 : from.T.rows());
  std::iota(open.begin(), open.end(), Index(0));
  open.erase(std::remove_if(open.begin(), open.end(),
               [&](Index t) { return !isSettled.empty() && isSettled[t]; }),
    open.end());
  std::vector<double> base;
  for (double excess = FirstExcess;; excess *= 2)
  {
    const auto failures = certificates.Check(
      open, from, to, tree, limits, DeviationCertificates::MANY_VERTICES, {}, monitor);
    if (failures.empty())
    {
      return limits;
    }
    if (base.empty())
    {
      base.assign(from.T.rows(), distance);
    }
    open.clear();
    for (const DeviationCertificates::Failure& failure : failures)
    {
      open.push_back(failure.triangle);
    }
    if (excess == FirstExcess)
    {
      InterruptibleFor(static_cast<Index>(open.size()), monitor,
        [&](Index k)
        {
          base[open[k]] =
            std::max(distance, LargestSampledDistance(CornersOf(from.V, from.T, open[k]), tree));
        });
    }
    for (const Index t : open)
    {
      limits.Raise(t, (1 + excess) * base[t]);
    }
  }
}

std::vector<Index> FindSeeds(
  const SurfaceView& from, const TriangleBvh& tree, ProgressMonitor& monitor)
{
  std::vector<Index> seeds(from.T.rows());
  InterruptibleFor(static_cast<Index>(from.T.rows()), monitor,
    [&](Index t)
    {
      const Vector3 centre = CornersOf(from.V, from.T, t).colwise().mean();
      seeds[t] = tree.FindClosest(centre).triangle;
    });
  return seeds;
}

VertexLimits::VertexLimits(
  const Points& V, const TriangleBvh& tree, double distance, ProgressMonitor& monitor)
  : Squared(V.rows())
{
  InterruptibleFor(static_cast<Index>(V.rows()), monitor,
    [&](Index i) {
      this->Squared[i] = std::max(distance * distance, tree.FindClosest(V.row(i)).squaredDistance);
    });
}

bool VertexLimits::IsExceeded(Index vertex, const Vector3& position, const TriangleBvh& tree) const
{
  return !this->Squared.empty() &&
         tree.FindClosest(position).squaredDistance > (1 + RoundOff) * this->Squared[vertex];
}
}
