// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Deviation/SurfaceComparison.h"

#include "Core/Base/Threading.h"
#include "Core/Deviation/TriangleValidity.h"
#include "Core/Mesh/TriangleGeometry.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lmo
{
namespace
{
/// Sum over the triangles that are owned.
template <typename Term>
double SumOverTriangles(const Triangles& triangles, const Subdomain& subdomain, const Term& term)
{
  return subdomain.Sum(ParallelSum(static_cast<Index>(triangles.rows()), 0.0,
    [&](double& sum, Index t) { sum += subdomain.OwnsTriangle(t) ? term(t) : 0; }));
}

double RelativeVolumeChange(const Points& before, const Points& after, const Triangles& triangles,
  const Vector3& origin, const Subdomain& subdomain)
{
  const auto volumeOf = [&](const Points& V)
  {
    return SumOverTriangles(
      triangles, subdomain, [&](Index t) { return VolumeTo(origin, V, triangles, t); });
  };
  const double volume = volumeOf(before);
  return volume != 0 ? (volumeOf(after) - volume) / std::abs(volume) : 0;
}

double CountFlippedTriangles(const Points& before, const Points& after, const Triangles& triangles,
  const MeshTopology& topology, const Subdomain& subdomain)
{
  const Points normals = NormalsToKeep(before, triangles, topology);
  return SumOverTriangles(triangles, subdomain,
    [&](Index t) {
      return HasTurnedOver(normals.row(t), ScaledNormal(after, triangles, t).stableNormalized());
    });
}
}

double LargestDisplacement(const Points& before, const Points& after, const Subdomain& subdomain)
{
  struct Maximum
  {
    double square = 0;
    void operator+=(const Maximum& other) { this->square = std::max(this->square, other.square); }
  };
  const Maximum maximum = ParallelSum(static_cast<Index>(before.rows()), Maximum(),
    [&](Maximum& partial, Index i)
    {
      if (subdomain.OwnsVertex(i))
      {
        partial += { (after.row(i) - before.row(i)).squaredNorm() };
      }
    });
  return std::sqrt(subdomain.Maximum(maximum.square));
}

SurfaceComparison CompareSurfaces(const Points& before, const Points& after,
  const Triangles& triangles, const MeshTopology& topology,
  std::shared_ptr<const MeshQuality> quality, const Eigen::AlignedBox3d& box, bool isClosed,
  const Subdomain& subdomain)
{
  const double diagonal = box.isEmpty() ? 0 : box.diagonal().norm();
  SurfaceComparison comparison;
  comparison.before = std::move(quality);
  comparison.after = MeasureQuality(after, triangles, topology.polygons, subdomain);
  comparison.maximumDisplacement = LargestDisplacement(before, after, subdomain);
  comparison.relativeMaximumDisplacement =
    diagonal > 0 ? comparison.maximumDisplacement / diagonal : 0;
  comparison.isClosed = isClosed;
  comparison.relativeVolumeChange =
    isClosed ? RelativeVolumeChange(before, after, triangles, box.center().transpose(), subdomain)
             : 0;
  comparison.triangles =
    static_cast<std::int64_t>(SumOverTriangles(triangles, subdomain, [](Index) { return 1.0; }));
  comparison.flippedTriangles =
    static_cast<std::int64_t>(CountFlippedTriangles(before, after, triangles, topology, subdomain));
  return comparison;
}
}
