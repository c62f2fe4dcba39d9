// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Mesh/TriangleSeparation.h"

#include "Core/Mesh/TriangleGeometry.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

namespace lmo
{
namespace
{
/// Above the round-off of products of three differences of coordinates, in terms of the lengths
/// that are multiplied.
constexpr double Margin = 1e-14;

/// The corners of two triangles, relative to the first corner of the first triangle, and the
/// largest of their distances from there.
struct Pair
{
  Vector3 a[3];
  Vector3 b[3];
  double size = 0;

  Pair(const std::array<Vector3, 3>& cornersOfA, const std::array<Vector3, 3>& cornersOfB)
  {
    double largest = 0;
    for (int k = 0; k < 3; ++k)
    {
      this->a[k] = cornersOfA[k];
      this->b[k] = cornersOfB[k];
      largest = std::max({ largest, this->a[k].squaredNorm(), this->b[k].squaredNorm() });
    }
    this->size = std::sqrt(largest);
  }
};

/// True if the axis has all of one triangle on either side.
bool Separates(const Vector3& axis, const Pair& pair)
{
  double lowestA = HUGE_VAL;
  double highestA = -HUGE_VAL;
  double lowestB = HUGE_VAL;
  double highestB = -HUGE_VAL;
  for (int k = 0; k < 3; ++k)
  {
    const double a = axis.dot(pair.a[k]);
    const double b = axis.dot(pair.b[k]);
    lowestA = std::min(lowestA, a);
    highestA = std::max(highestA, a);
    lowestB = std::min(lowestB, b);
    highestB = std::max(highestB, b);
  }
  const double gap = std::max(lowestA - highestB, lowestB - highestA);
  return gap > 0 && gap > Margin * axis.norm() * pair.size;
}

/// Two triangles without a common corner: if they do not meet, one of these axes separates them.
bool AreApart(const Pair& pair)
{
  const Vector3 edgesA[3] = { pair.a[1] - pair.a[0], pair.a[2] - pair.a[1], pair.a[0] - pair.a[2] };
  const Vector3 edgesB[3] = { pair.b[1] - pair.b[0], pair.b[2] - pair.b[1], pair.b[0] - pair.b[2] };
  const Vector3 normalA = edgesA[0].cross(edgesA[1]);
  const Vector3 normalB = edgesB[0].cross(edgesB[1]);
  if (Separates(normalA, pair) || Separates(normalB, pair))
  {
    return true;
  }
  // Most neighbours lie nearly in a plane, where these decide; in a plane, the others vanish.
  for (int k = 0; k < 3; ++k)
  {
    if (Separates(normalA.cross(edgesA[k]), pair) || Separates(normalB.cross(edgesB[k]), pair))
    {
      return true;
    }
  }
  for (const Vector3& edgeA : edgesA)
  {
    for (const Vector3& edgeB : edgesB)
    {
      if (Separates(edgeA.cross(edgeB), pair))
      {
        return true;
      }
    }
  }
  return false;
}

/// Two triangles with a common corner, from which the other corners are seen in these directions:
/// whether a plane through it separates them.
bool AreConesApart(const Vector3& p, const Vector3& q, const Vector3& r, const Vector3& s)
{
  // The point closest to the corner of a tetrahedron that does not hold it is the plane's normal.
  const Vector3 tips[4] = { p.stableNormalized(), q.stableNormalized(), -r.stableNormalized(),
    -s.stableNormalized() };
  for (int k = 0; k < 4; ++k)
  {
    const Vector3 normal =
      ClosestPointOnTriangle(Vector3::Zero(), tips[k], tips[(k + 1) % 4], tips[(k + 2) % 4]);
    const double least = std::min(
      { normal.dot(tips[0]), normal.dot(tips[1]), normal.dot(tips[2]), normal.dot(tips[3]) });
    if (least > Margin * normal.norm())
    {
      return true;
    }
  }
  return false;
}

/// Two triangles with a common edge, from whose first end the third corners are seen in the
/// directions p and q: whether they do not lie on each other.
bool AreWingsApart(const Vector3& edge, const Vector3& p, const Vector3& q)
{
  const Vector3 normalP = edge.cross(p);
  const Vector3 normalQ = edge.cross(q);
  if (!(normalP.norm() > Margin * edge.norm() * p.norm() &&
        normalQ.norm() > Margin * edge.norm() * q.norm()))
  {
    return false;
  }
  const double size = Margin * normalP.norm() * normalQ.norm();
  return normalP.dot(normalQ) < -size || normalP.cross(normalQ).norm() > size;
}
}

bool AreSeparate(const Points& V, const Triangles& triangles, Index s, Index t)
{
  Index common[3];
  Index othersOfS[3];
  Index othersOfT[3];
  int shared = 0;
  int restOfS = 0;
  for (int k = 0; k < 3; ++k)
  {
    const Index i = triangles(s, k);
    const bool isShared = i == triangles(t, 0) || i == triangles(t, 1) || i == triangles(t, 2);
    (isShared ? common[shared++] : othersOfS[restOfS++]) = i;
  }
  int restOfT = 0;
  for (int k = 0; k < 3; ++k)
  {
    const Index i = triangles(t, k);
    if (std::find(common, common + shared, i) == common + shared)
    {
      othersOfT[restOfT++] = i;
    }
  }
  const Vector3 origin = V.row(shared > 0 ? common[0] : othersOfS[0]);
  const auto at = [&](Index i) -> Vector3 { return V.row(i) - origin; };
  if (shared == 0)
  {
    return AreApart({ { at(othersOfS[0]), at(othersOfS[1]), at(othersOfS[2]) },
      { at(othersOfT[0]), at(othersOfT[1]), at(othersOfT[2]) } });
  }
  if (shared == 1 && restOfS == 2 && restOfT == 2)
  {
    return AreConesApart(at(othersOfS[0]), at(othersOfS[1]), at(othersOfT[0]), at(othersOfT[1]));
  }
  return shared == 2 && restOfS == 1 && restOfT == 1 &&
         AreWingsApart(at(common[1]), at(othersOfS[0]), at(othersOfT[0]));
}

bool IsFlatFan(
  const Points& V, const Triangles& triangles, const MeshTopology& topology, Index vertex)
{
  const AdjacencyLists& cornersAt = topology.cornersAt;
  const Index size = cornersAt.Size(vertex);
  if (!topology.isFan[vertex] || size == 0)
  {
    return size == 0;
  }
  const Vector3 origin = V.row(vertex);
  const auto next = [&](Index corner) -> Index { return triangles.data()[NextCorner(corner)]; };
  const auto previous = [&](Index corner) -> Index
  { return triangles.data()[PreviousCorner(corner)]; };
  const auto at = [&](Index i) -> Vector3 { return V.row(i) - origin; };
  Vector3 normal = Vector3::Zero();
  for (const Index corner : cornersAt[vertex])
  {
    normal += at(next(corner)).cross(at(previous(corner)));
  }
  normal = normal.stableNormalized();
  // Each triangle turns counter-clockwise, and the fan does not turn past where it began.
  const Index* corners = cornersAt.Begin(vertex);
  const bool isForward = next(corners[0]) == *topology.oneRings.Begin(vertex);
  const Index first = next(corners[isForward ? 0 : size - 1]);
  const Vector3 ray = at(first);
  for (Index k = 0; k < size; ++k)
  {
    const Index corner = corners[k];
    const Vector3 p = at(next(corner));
    const Vector3 q = at(previous(corner));
    const double margin = Margin * p.norm() * q.norm();
    if (!(normal.dot(p.cross(q)) > margin))
    {
      return false;
    }
    if (next(corner) != first && previous(corner) != first)
    {
      const double left = normal.dot(p.cross(ray));
      const double right = normal.dot(ray.cross(q));
      const double rayMargin = Margin * ray.norm() * std::max(p.norm(), q.norm());
      if (left > -rayMargin && right > -rayMargin)
      {
        return false;
      }
    }
  }
  return true;
}
}
