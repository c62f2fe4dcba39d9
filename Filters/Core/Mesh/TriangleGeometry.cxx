// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Mesh/TriangleGeometry.h"

#include "Core/Base/Threading.h"

#include <algorithm>
#include <cmath>

namespace lmo
{
namespace
{
/// Edges that leave a corner, in counter-clockwise order.
struct CornerEdges
{
  Vector3 next;
  Vector3 previous;

  CornerEdges(const Points& V, const Triangles& triangles, Index corner)
    : next(V.row(triangles.data()[NextCorner(corner)]) - V.row(triangles.data()[corner]))
    , previous(V.row(triangles.data()[PreviousCorner(corner)]) - V.row(triangles.data()[corner]))
  {
  }

  CornerEdges(const TriangleCorners& corners, int k)
    : next(corners.row((k + 1) % 3) - corners.row(k))
    , previous(corners.row((k + 2) % 3) - corners.row(k))
  {
  }
};

/// Sum over the corners at vertex i of value(corner).
template <typename Value>
auto SumOverCorners(const MeshTopology& topology, Index i, const Value& value)
{
  std::decay_t<decltype(value(0))> sum{};
  for (const Index c : topology.cornersAt[i])
  {
    sum += value(c);
  }
  return sum;
}

/// Share of a corner's triangle in the mixed Voronoi area of its vertex.
/// \param edges that leave the corner
/// \param here cotangent at the corner
/// \param next, previous cotangents at the corners where \a edges end
double MixedVoronoiShare(const CornerEdges& edges, double here, double next, double previous)
{
  if (std::min({ here, next, previous }) < 0)
  {
    const double area = 0.5 * edges.next.cross(edges.previous).norm();
    return here < 0 ? area / 2 : area / 4;
  }
  return (edges.next.squaredNorm() * previous + edges.previous.squaredNorm() * next) / 8;
}

double Angle(const CornerEdges& edges)
{
  return std::atan2(edges.next.cross(edges.previous).norm(), edges.next.dot(edges.previous));
}
}

Vector3 ScaledNormal(const Points& V, const Triangles& triangles, Index t)
{
  const CornerEdges edges(V, triangles, 3 * t);
  return edges.next.cross(edges.previous);
}

namespace
{
/// Calls the method of \a result for the part of triangle abc that is closest to x: AtCorner(k),
/// OnEdge(from, to, fraction of the way) or Inside(weights of the corners, not normalised). By the
/// Voronoi regions of the parts (Ericson, Real-Time Collision Detection, 5.1.5).
template <typename Result>
auto AtClosestPoint(
  const Vector3& x, const Vector3& a, const Vector3& b, const Vector3& c, const Result& result)
{
  const Vector3 ab = b - a;
  const Vector3 ac = c - a;
  const Vector3 ax = x - a;
  const double abax = ab.dot(ax);
  const double acax = ac.dot(ax);
  if (abax <= 0 && acax <= 0)
  {
    return result.AtCorner(0);
  }
  const Vector3 bx = x - b;
  const double abbx = ab.dot(bx);
  const double acbx = ac.dot(bx);
  if (abbx >= 0 && acbx <= abbx)
  {
    return result.AtCorner(1);
  }
  const double weightOfC = abax * acbx - abbx * acax;
  if (weightOfC <= 0 && abax >= 0 && abbx <= 0)
  {
    return abax > abbx ? result.OnEdge(0, 1, abax / (abax - abbx)) : result.AtCorner(0);
  }
  const Vector3 cx = x - c;
  const double abcx = ab.dot(cx);
  const double accx = ac.dot(cx);
  if (accx >= 0 && abcx <= accx)
  {
    return result.AtCorner(2);
  }
  const double weightOfB = abcx * acax - abax * accx;
  if (weightOfB <= 0 && acax >= 0 && accx <= 0)
  {
    return acax > accx ? result.OnEdge(0, 2, acax / (acax - accx)) : result.AtCorner(0);
  }
  const double weightOfA = abbx * accx - abcx * acbx;
  const double towardsC = acbx - abbx;
  const double towardsB = abcx - accx;
  if (weightOfA <= 0 && towardsC >= 0 && towardsB >= 0)
  {
    const double sum = towardsC + towardsB;
    return sum > 0 ? result.OnEdge(1, 2, towardsC / sum) : result.AtCorner(1);
  }
  return result.Inside(weightOfA, weightOfB, weightOfC);
}

/// The closest point by its coordinates.
struct ByPosition
{
  const Vector3 corners[3];

  Vector3 AtCorner(int k) const { return this->corners[k]; }
  Vector3 OnEdge(int from, int to, double fraction) const
  {
    return this->corners[from] + fraction * (this->corners[to] - this->corners[from]);
  }
  Vector3 Inside(double a, double b, double c) const
  {
    const Vector3 ab = this->corners[1] - this->corners[0];
    const Vector3 ac = this->corners[2] - this->corners[0];
    return this->corners[0] + (b * ab + c * ac) / (a + b + c);
  }
};

/// The closest point by its barycentric coordinates.
struct ByWeights
{
  Vector3 AtCorner(int k) const { return Vector3::Unit(k); }
  Vector3 OnEdge(int from, int to, double fraction) const
  {
    return (1 - fraction) * Vector3::Unit(from) + fraction * Vector3::Unit(to);
  }
  Vector3 Inside(double a, double b, double c) const { return Vector3(a, b, c) / (a + b + c); }
};
}

Vector3 ClosestPointOnTriangle(
  const Vector3& x, const Vector3& a, const Vector3& b, const Vector3& c)
{
  return AtClosestPoint(x, a, b, c, ByPosition{ { a, b, c } });
}

Vector3 ClosestBarycentricCoordinates(
  const Vector3& x, const Vector3& a, const Vector3& b, const Vector3& c)
{
  return AtClosestPoint(x, a, b, c, ByWeights{});
}

Vector3 TriangleCotangents(const TriangleCorners& corners)
{
  const Vector3 ab = corners.row(1) - corners.row(0);
  const Vector3 bc = corners.row(2) - corners.row(1);
  const Vector3 ca = corners.row(0) - corners.row(2);
  const double sine = ab.cross(ca).norm();
  const Vector3 cosines(-ab.dot(ca), -bc.dot(ab), -ca.dot(bc));
  const double scale = sine > 0 ? 1 / sine : 0;
  return (cosines * scale).cwiseMax(-MaximumCotangent).cwiseMin(MaximumCotangent);
}

Vector3 MixedVoronoiShares(const TriangleCorners& corners, const Vector3& cotangents)
{
  Vector3 shares;
  for (int k = 0; k < 3; ++k)
  {
    shares[k] = MixedVoronoiShare(
      CornerEdges(corners, k), cotangents[k], cotangents[(k + 1) % 3], cotangents[(k + 2) % 3]);
  }
  return shares;
}

Vector3 TriangleAngles(const TriangleCorners& corners)
{
  return { Angle(CornerEdges(corners, 0)), Angle(CornerEdges(corners, 1)),
    Angle(CornerEdges(corners, 2)) };
}

CornerValues Cotangents(const Points& V, const Triangles& triangles)
{
  CornerValues cotangents(triangles.rows(), 3);
  ParallelFor(static_cast<Index>(triangles.rows()),
    [&](Index t) { cotangents.row(t) = TriangleCotangents(CornersOf(V, triangles, t)); });
  return cotangents;
}

Vector MixedVoronoiAreas(const Points& V, const Triangles& triangles, const MeshTopology& topology,
  const CornerValues& cotangents)
{
  Vector areas(V.rows());
  ParallelFor(topology.vertices,
    [&](Index i)
    {
      areas[i] = SumOverCorners(topology, i,
        [&](Index corner)
        {
          return MixedVoronoiShare(CornerEdges(V, triangles, corner), cotangents.data()[corner],
            cotangents.data()[NextCorner(corner)], cotangents.data()[PreviousCorner(corner)]);
        });
    });
  return areas;
}

Vector AngleDefects(const Points& V, const Triangles& triangles, const MeshTopology& topology)
{
  Vector defects(V.rows());
  ParallelFor(topology.vertices,
    [&](Index i)
    {
      const double angles = SumOverCorners(
        topology, i, [&](Index corner) { return Angle(CornerEdges(V, triangles, corner)); });
      defects[i] = topology.isUsed[i] ? 2 * Pi - angles : 0;
    });
  return defects;
}

Vector3 VertexNormal(
  const Points& V, const Triangles& triangles, const MeshTopology& topology, Index i)
{
  Vector3 sum = Vector3::Zero();
  if (topology.polygons.IsEmpty())
  {
    for (const Index c : topology.cornersAt[i])
    {
      const CornerEdges edges(V, triangles, c);
      sum += edges.next.cross(edges.previous);
    }
  }
  else
  {
    ForEachTriangleOfCellsAt(topology.cornersAt, topology.polygons, i,
      [&](Index t) { sum += ScaledNormal(V, triangles, t); });
  }
  const double length = sum.norm();
  return length > 0 ? Vector3(sum / length) : Vector3(Vector3::Zero());
}

Points VertexNormals(const Points& V, const Triangles& triangles, const MeshTopology& topology)
{
  Points normals(V.rows(), 3);
  ParallelFor(
    topology.vertices, [&](Index i) { normals.row(i) = VertexNormal(V, triangles, topology, i); });
  return normals;
}

double VolumeTo(const Vector3& point, const Points& V, const Triangles& triangles, Index t)
{
  const Vector3 a = V.row(triangles(t, 0)) - point;
  const Vector3 b = V.row(triangles(t, 1)) - point;
  const Vector3 c = V.row(triangles(t, 2)) - point;
  return a.dot(b.cross(c)) / 6;
}

double EnclosedVolume(const Points& V, const Triangles& triangles)
{
  if (triangles.rows() == 0)
  {
    return 0;
  }
  const Vector3 origin = V.row(triangles(0, 0));
  return ParallelSum(static_cast<Index>(triangles.rows()), 0.0,
    [&](double& sum, Index t) { sum += VolumeTo(origin, V, triangles, t); });
}

Eigen::AlignedBox3d BoundingBox(const Points& V, const MeshTopology& topology)
{
  Eigen::AlignedBox3d box;
  for (Index i = 0; i < topology.vertices; ++i)
  {
    if (topology.isUsed[i])
    {
      box.extend(V.row(i).transpose());
    }
  }
  return box;
}

double BoundingBoxDiagonal(const Points& V, const MeshTopology& topology)
{
  const Eigen::AlignedBox3d box = BoundingBox(V, topology);
  return box.isEmpty() ? 0 : box.diagonal().norm();
}
}
