// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "TriangleGeometry.h"

#include "Parallel.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace lmo
{
namespace
{
constexpr double MaximumCotangent = 1e6;
constexpr double Pi = 3.14159265358979323846;

/// Corner of triangle t that is vertex i.
int CornerOf(const Triangles& triangles, Index t, Index i)
{
  return triangles(t, 0) == i ? 0 : (triangles(t, 1) == i ? 1 : 2);
}

/// Edges that leave a corner, in counter-clockwise order.
struct Corner
{
  Vector3 next;
  Vector3 previous;

  Corner(const Points& V, const Triangles& triangles, Index t, int corner)
    : next(V.row(triangles(t, (corner + 1) % 3)) - V.row(triangles(t, corner)))
    , previous(V.row(triangles(t, (corner + 2) % 3)) - V.row(triangles(t, corner)))
  {
  }
};

/// Share of triangle t in the mixed Voronoi area of its corner.
double MixedVoronoiArea(
  const Points& V, const Triangles& triangles, const CornerValues& cotangents, Index t, int corner)
{
  const bool isObtuse = cotangents.row(t).minCoeff() < 0;
  if (isObtuse)
  {
    const double area = 0.5 * ScaledNormal(V, triangles, t).norm();
    return cotangents(t, corner) < 0 ? area / 2 : area / 4;
  }
  const Corner edges(V, triangles, t, corner);
  return (edges.next.squaredNorm() * cotangents(t, (corner + 2) % 3) +
           edges.previous.squaredNorm() * cotangents(t, (corner + 1) % 3)) /
         8;
}
}

Vector3 ScaledNormal(const Points& V, const Triangles& triangles, Index t)
{
  const Corner edges(V, triangles, t, 0);
  return edges.next.cross(edges.previous);
}

CornerValues Cotangents(const Points& V, const Triangles& triangles)
{
  CornerValues cotangents(triangles.rows(), 3);
  ParallelFor(static_cast<Index>(triangles.rows()),
    [&](Index t)
    {
      const double sine = ScaledNormal(V, triangles, t).norm();
      for (int corner = 0; corner < 3; ++corner)
      {
        const Corner edges(V, triangles, t, corner);
        const double cotangent = sine > 0 ? edges.next.dot(edges.previous) / sine : 0;
        cotangents(t, corner) = std::clamp(cotangent, -MaximumCotangent, MaximumCotangent);
      }
    });
  return cotangents;
}

Vector MixedVoronoiAreas(const Points& V, const Triangles& triangles, const MeshTopology& topology,
  const CornerValues& cotangents)
{
  Vector areas(V.rows());
  ParallelFor(topology.vertices,
    [&](Index i)
    {
      areas[i] = 0;
      for (const Index* t = topology.trianglesAt.Begin(i); t != topology.trianglesAt.End(i); ++t)
      {
        areas[i] += MixedVoronoiArea(V, triangles, cotangents, *t, CornerOf(triangles, *t, i));
      }
    });
  return areas;
}

Vector AngleDefects(const Points& V, const Triangles& triangles, const MeshTopology& topology)
{
  Vector defects(V.rows());
  ParallelFor(topology.vertices,
    [&](Index i)
    {
      double angles = 0;
      for (const Index* t = topology.trianglesAt.Begin(i); t != topology.trianglesAt.End(i); ++t)
      {
        const Corner edges(V, triangles, *t, CornerOf(triangles, *t, i));
        angles +=
          std::atan2(edges.next.cross(edges.previous).norm(), edges.next.dot(edges.previous));
      }
      defects[i] = topology.isUsed[i] ? 2 * Pi - angles : 0;
    });
  return defects;
}

Points VertexNormals(const Points& V, const Triangles& triangles, const MeshTopology& topology)
{
  Points normals(V.rows(), 3);
  ParallelFor(topology.vertices,
    [&](Index i)
    {
      Vector3 sum = Vector3::Zero();
      for (const Index* t = topology.trianglesAt.Begin(i); t != topology.trianglesAt.End(i); ++t)
      {
        sum += ScaledNormal(V, triangles, *t);
      }
      normals.row(i) = sum.stableNormalized();
    });
  return normals;
}

double EnclosedVolume(const Points& V, const Triangles& triangles)
{
  if (triangles.rows() == 0)
  {
    return 0;
  }
  const Vector3 origin = V.row(triangles(0, 0));
  return ParallelSum(static_cast<Index>(triangles.rows()), 0.0,
           [&](double& sum, Index t)
           {
             const Vector3 a = V.row(triangles(t, 0)) - origin;
             const Vector3 b = V.row(triangles(t, 1)) - origin;
             const Vector3 c = V.row(triangles(t, 2)) - origin;
             sum += a.dot(b.cross(c));
           }) /
         6;
}

double BoundingBoxDiagonal(const Points& V, const MeshTopology& topology)
{
  Eigen::AlignedBox<double, 3> box;
  for (Index i = 0; i < topology.vertices; ++i)
  {
    if (topology.isUsed[i])
    {
      box.extend(V.row(i).transpose());
    }
  }
  return box.isEmpty() ? 0 : box.diagonal().norm();
}
}
