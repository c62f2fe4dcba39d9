// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Mesh/TriangleQuality.h"

#include "Core/Base/Threading.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lmo
{
double RadiusRatio(const Vector3& a, const Vector3& b, const Vector3& c)
{
  const Vector3 ab = b - a;
  const Vector3 bc = c - b;
  const Vector3 ca = a - c;
  const double lab = ab.norm();
  const double lbc = bc.norm();
  const double lca = ca.norm();
  if (!(std::min({ lab, lbc, lca }) > 0))
  {
    return 0;
  }
  // r = 2A / (a + b + c) and R = abc / 4A: t = 16 A^2 / (abc (a + b + c)), in units of the longest
  // edge so that no power under- or overflows.
  const double unit = 1 / std::max({ lab, lbc, lca });
  const double twiceAreaSquared = (ab * unit).cross(ca * unit).squaredNorm();
  const double t = 4 * twiceAreaSquared /
                   ((lab * unit) * (lbc * unit) * (lca * unit) * ((lab + lbc + lca) * unit));
  return std::min(t, 1.0);
}

Vector RadiusRatios(const Points& V, const Triangles& triangles)
{
  Vector ratios(triangles.rows());
  ParallelFor(static_cast<Index>(triangles.rows()),
    [&](Index t)
    {
      ratios[t] =
        RadiusRatio(V.row(triangles(t, 0)), V.row(triangles(t, 1)), V.row(triangles(t, 2)));
    });
  return ratios;
}

double CornerShape(const Vector3& a, const Vector3& b)
{
  const double la = a.norm();
  const double lb = b.norm();
  if (!(std::min(la, lb) > 0))
  {
    return 0;
  }
  // By unit vectors, so that no power under- or overflows.
  return 2 * (a / la).cross(b / lb).norm() / (la / lb + lb / la);
}

double SineOfRegularPolygon(Index corners)
{
  constexpr double turn = 6.283185307179586;
  return corners == 4 ? 1 : std::sin(turn / corners);
}

double PolygonQuality(const Points& V, const Polygons& polygons, Index p)
{
  const Index* corners = polygons.corners.Begin(p);
  return CellQuality(
    polygons.corners.Size(p), [&](Index k) -> Vector3 { return V.row(corners[k]); });
}

Index CountReflexCorners(const Points& V, const Polygons& polygons, Index p)
{
  const Index size = polygons.corners.Size(p);
  const Index* corners = polygons.corners.Begin(p);
  const auto edgeTo = [&](Index from, Index to) -> Vector3
  { return V.row(corners[to % size]) - V.row(corners[from % size]); };
  Vector3 normal = Vector3::Zero();
  for (Index k = 1; k + 1 < size; ++k)
  {
    normal += edgeTo(0, k).cross(edgeTo(0, k + 1));
  }
  Index count = 0;
  for (Index k = 0; k < size; ++k)
  {
    count += edgeTo(k, k + 1).cross(edgeTo(k + 1, k + 2)).dot(normal) < 0;
  }
  return count;
}

Vector CellQualities(const Points& V, const Triangles& triangles, const Polygons& polygons)
{
  if (polygons.IsEmpty())
  {
    return RadiusRatios(V, triangles);
  }
  Vector qualities(triangles.rows());
  ParallelFor(polygons.Size(),
    [&](Index p)
    {
      const Index first = polygons.FirstTriangle(p);
      qualities.segment(first, polygons.FirstTriangle(p + 1) - first)
        .setConstant(PolygonQuality(V, polygons, p));
    });
  return qualities;
}

Vector MinimumAtVertices(const Vector& triangleValues, const Triangles& triangles, Index vertices)
{
  constexpr double none = std::numeric_limits<double>::infinity();
  Vector minimum = Vector::Constant(vertices, none);
  for (Eigen::Index t = 0; t < triangles.rows(); ++t)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      double& value = minimum[triangles(t, corner)];
      value = std::min(value, triangleValues[t]);
    }
  }
  ParallelFor(
    vertices, [&](Index i) { minimum[i] = minimum[i] == none ? UndefinedQuality : minimum[i]; });
  return minimum;
}

MeshQuality MeasureQuality(
  const Points& V, const Triangles& triangles, const Polygons& polygons, const Subdomain& subdomain)
{
  MeshQuality quality;
  quality.triangles = CellQualities(V, triangles, polygons);
  quality.vertices = MinimumAtVertices(quality.triangles, triangles, static_cast<Index>(V.rows()));
  struct Summary
  {
    Index count = 0;
    double sum = 0;
    double minimum = 1;
    void operator+=(const Summary& other)
    {
      this->count += other.count;
      this->sum += other.sum;
      this->minimum = std::min(this->minimum, other.minimum);
    }
  };
  const Summary summary = ParallelSum(static_cast<Index>(triangles.rows()), Summary(),
    [&](Summary& partial, Index t)
    {
      if (subdomain.OwnsTriangle(t) && polygons.IsFirstTriangle(t))
      {
        partial += { 1, quality.triangles[t], quality.triangles[t] };
      }
    });
  const double count = subdomain.Sum(summary.count);
  const double sum = subdomain.Sum(summary.sum);
  const double minimum = -subdomain.Maximum(-summary.minimum);
  if (count > 0)
  {
    quality.mean = sum / count;
    quality.minimum = minimum;
  }
  return quality;
}
}
