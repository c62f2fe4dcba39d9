// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceComparison.h"

#include "Parallel.h"
#include "TriangleGeometry.h"

#include <cmath>

namespace lmo
{
namespace
{
double RelativeVolumeChange(const Points& before, const Points& after, const Triangles& triangles,
  const MeshTopology& topology)
{
  const double volume = topology.IsClosed() ? EnclosedVolume(before, triangles) : 0;
  return volume != 0 ? (EnclosedVolume(after, triangles) - volume) / std::abs(volume) : 0;
}

Index CountFlippedTriangles(const Points& before, const Points& after, const Triangles& triangles)
{
  return ParallelSum(static_cast<Index>(triangles.rows()), Index(0),
    [&](Index& flipped, Index t)
    {
      const Vector3 normal = ScaledNormal(before, triangles, t).stableNormalized();
      flipped += normal.dot(ScaledNormal(after, triangles, t)) < 0;
    });
}
}

SurfaceComparison CompareSurfaces(const Points& before, const Points& after,
  const Triangles& triangles, const MeshTopology& topology)
{
  SurfaceComparison comparison;
  comparison.radiusRatiosBefore = RadiusRatios(before, triangles);
  comparison.radiusRatiosAfter = RadiusRatios(after, triangles);
  comparison.before = Summarize(comparison.radiusRatiosBefore);
  comparison.after = Summarize(comparison.radiusRatiosAfter);
  if (before.rows() > 0)
  {
    comparison.maximumDisplacement = (after - before).rowwise().norm().maxCoeff();
  }
  const double diagonal = BoundingBoxDiagonal(before, topology);
  if (diagonal > 0)
  {
    comparison.relativeMaximumDisplacement = comparison.maximumDisplacement / diagonal;
  }
  comparison.relativeVolumeChange = RelativeVolumeChange(before, after, triangles, topology);
  comparison.flippedTriangles = CountFlippedTriangles(before, after, triangles);
  return comparison;
}
}
