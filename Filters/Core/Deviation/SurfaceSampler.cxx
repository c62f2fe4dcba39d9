// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Deviation/SurfaceSampler.h"

#include "Core/Mesh/TriangleGeometry.h"

#include <algorithm>
#include <cmath>

namespace lmo
{
namespace
{
/// Term k of the additive sequence with the generalised golden ratio in two dimensions, which fills
/// the unit square evenly.
Eigen::Array2d EvenlySpread(Index k)
{
  constexpr double plastic = 1.32471795724474602596;
  const Eigen::Array2d sum = 0.5 + double(k) * Eigen::Array2d(1 / plastic, 1 / (plastic * plastic));
  return sum - sum.floor();
}
}

SurfaceSampler::SurfaceSampler(const Points& V, const Triangles& triangles)
  : V(V)
  , T(triangles)
{
  double area = 0;
  for (Index t = 0; t < triangles.rows(); ++t)
  {
    area += 0.5 * ScaledNormal(V, triangles, t).norm();
    this->AreaUpTo.push_back(area);
  }
}

Vector3 SurfaceSampler::Sample(Index k, Index count) const
{
  const double area = (k + 0.5) / count * this->Area();
  const auto found = std::upper_bound(this->AreaUpTo.begin(), this->AreaUpTo.end(), area);
  const auto t = std::min<Eigen::Index>(found - this->AreaUpTo.begin(), this->T.rows() - 1);
  Eigen::Array2d uv = EvenlySpread(k);
  if (uv.sum() > 1)
  {
    uv = 1 - uv;
  }
  return (1 - uv.sum()) * this->V.row(this->T(t, 0)) + uv[0] * this->V.row(this->T(t, 1)) +
         uv[1] * this->V.row(this->T(t, 2));
}
}
