// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceComparison.h"

#include "Parallel.h"
#include "TriangleGeometry.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lmo
{
namespace
{
double LargestDisplacement(const Points& before, const Points& after)
{
  struct Maximum
  {
    double square = 0;
    void operator+=(const Maximum& other) { this->square = std::max(this->square, other.square); }
  };
  return std::sqrt(ParallelSum(static_cast<Index>(before.rows()), Maximum(),
    [&](Maximum& maximum, Index i) {
      maximum += { (after.row(i) - before.row(i)).squaredNorm() };
    }).square);
}

double RelativeVolumeChange(const Points& before, const Points& after, const Triangles& triangles)
{
  const double volume = EnclosedVolume(before, triangles);
  return volume != 0 ? (EnclosedVolume(after, triangles) - volume) / std::abs(volume) : 0;
}

Index CountFlippedTriangles(const Points& before, const Points& after, const Triangles& triangles)
{
  return ParallelSum(static_cast<Index>(triangles.rows()), Index(0),
    [&](Index& flipped, Index t)
    { flipped += ScaledNormal(before, triangles, t).dot(ScaledNormal(after, triangles, t)) < 0; });
}
}

SurfaceComparison CompareSurfaces(const Points& before, const Points& after,
  const Triangles& triangles, std::shared_ptr<const MeshQuality> quality, double diagonal,
  bool isClosed)
{
  SurfaceComparison comparison;
  comparison.before = std::move(quality);
  comparison.after = MeasureQuality(after, triangles);
  comparison.maximumDisplacement = LargestDisplacement(before, after);
  comparison.relativeMaximumDisplacement =
    diagonal > 0 ? comparison.maximumDisplacement / diagonal : 0;
  comparison.relativeVolumeChange = isClosed ? RelativeVolumeChange(before, after, triangles) : 0;
  comparison.flippedTriangles = CountFlippedTriangles(before, after, triangles);
  return comparison;
}
}
