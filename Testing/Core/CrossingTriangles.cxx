// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CrossingTriangles.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

using namespace lmo;

namespace
{
using Integers = Eigen::Matrix<long long, 1, 3>;

Integers IntegerPoint(const TestMesh& mesh, Index i)
{
  return mesh.V.row(i).array().round().matrix().cast<long long>();
}

bool HasCorner(const TestMesh& mesh, Index t, Index i)
{
  return mesh.T(t, 0) == i || mesh.T(t, 1) == i || mesh.T(t, 2) == i;
}

int Sign(long long x)
{
  return (x > 0) - (x < 0);
}

long long Volume(const Integers& a, const Integers& b, const Integers& c, const Integers& d)
{
  return (b - a).cross(c - a).dot(d - a);
}

/// Points with rational coordinates on a segment: from + (to - from) numerator / denominator.
struct Cut
{
  Integers numerator; ///< of the point itself
  long long denominator;
};

/// Whether a point in the plane of a triangle lies in it.
bool IsInside(const Cut& x, const Integers triangle[3])
{
  const Integers normal = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
  bool isInside = true;
  for (int k = 0; k < 3; ++k)
  {
    const Integers edge = triangle[(k + 1) % 3] - triangle[k];
    const Integers offset = x.numerator - x.denominator * triangle[k];
    isInside = isInside && Sign(edge.cross(offset).dot(normal)) * Sign(x.denominator) >= 0;
  }
  return isInside;
}

bool IsCornerOf(const Cut& x, const Integers& corner)
{
  return x.numerator == x.denominator * corner;
}

/// The points where the segment meets the triangle's plane, or its ends if it lies in it, and where
/// it meets the triangle's edges then.
std::vector<Cut> CutsOf(const Integers& from, const Integers& to, const Integers triangle[3])
{
  const Integers normal = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
  const long long a = normal.dot(from - triangle[0]);
  const long long b = normal.dot(to - triangle[0]);
  std::vector<Cut> cuts;
  if (a == 0 && b == 0)
  {
    cuts = { { from, 1 }, { to, 1 }, { from + to, 2 } };
    for (int k = 0; k < 3; ++k)
    {
      const Integers edge = triangle[(k + 1) % 3] - triangle[k];
      const Integers across = edge.cross(normal);
      const long long c = across.dot(from - triangle[k]);
      const long long d = across.dot(to - triangle[k]);
      if (c != d && Sign(c) * Sign(d) <= 0)
      {
        cuts.push_back({ c * to - d * from, c - d });
      }
    }
  }
  else if (Sign(a) * Sign(b) <= 0)
  {
    cuts.push_back({ a * to - b * from, a - b });
  }
  return cuts;
}

bool IsOnEdge(const Cut& x, const Integers& from, const Integers& to)
{
  const Integers offset = x.numerator - x.denominator * from;
  const Integers edge = to - from;
  const long long along = offset.dot(edge) * Sign(x.denominator);
  return edge.cross(offset).isZero() && along >= 0 &&
         along <= edge.squaredNorm() * std::abs(x.denominator);
}

/// Whether the edges of triangle s meet triangle t where they may not.
bool EdgesMeet(const TestMesh& mesh, Index s, Index t)
{
  Integers triangle[3];
  std::vector<Integers> common;
  for (int k = 0; k < 3; ++k)
  {
    triangle[k] = IntegerPoint(mesh, mesh.T(t, k));
    if (HasCorner(mesh, s, mesh.T(t, k)))
    {
      common.push_back(triangle[k]);
    }
  }
  for (int k = 0; k < 3; ++k)
  {
    const Integers from = IntegerPoint(mesh, mesh.T(s, k));
    const Integers to = IntegerPoint(mesh, mesh.T(s, (k + 1) % 3));
    for (const Cut& x : CutsOf(from, to, triangle))
    {
      const bool isCommon = std::any_of(common.begin(), common.end(),
                              [&](const Integers& i) { return IsCornerOf(x, i); }) ||
                            (common.size() == 2 && IsOnEdge(x, common[0], common[1]));
      if (x.denominator != 0 && !isCommon && IsOnEdge(x, from, to) && IsInside(x, triangle))
      {
        return true;
      }
    }
  }
  return false;
}

/// Whether the segment passes through the inside of the triangle, by a share of it at least.
bool PassesThrough(
  const Vector3& from, const Vector3& to, const Vector3& a, const Vector3& b, const Vector3& c)
{
  constexpr double share = 1e-9;
  const Vector3 direction = to - from;
  const Vector3 normal = (b - a).cross(c - a);
  const double height = normal.dot(direction);
  if (!(std::abs(height) > 1e-12 * normal.norm() * direction.norm()))
  {
    return false;
  }
  const double t = normal.dot(a - from) / height;
  const Vector3 x = from + t * direction;
  const double u = (c - b).cross(x - b).dot(normal) / normal.squaredNorm();
  const double v = (a - c).cross(x - c).dot(normal) / normal.squaredNorm();
  return t > share && t < 1 - share && u > share && v > share && u + v < 1 - share;
}

bool EdgePassesThrough(const TestMesh& mesh, Index s, Index t)
{
  for (int k = 0; k < 3; ++k)
  {
    const Index i = mesh.T(s, k);
    const Index j = mesh.T(s, (k + 1) % 3);
    if (!HasCorner(mesh, t, i) && !HasCorner(mesh, t, j) &&
        PassesThrough(mesh.V.row(i), mesh.V.row(j), mesh.V.row(mesh.T(t, 0)),
          mesh.V.row(mesh.T(t, 1)), mesh.V.row(mesh.T(t, 2))))
    {
      return true;
    }
  }
  return false;
}

Eigen::AlignedBox3d BoxOf(const TestMesh& mesh, Index t)
{
  Eigen::AlignedBox3d box;
  for (int k = 0; k < 3; ++k)
  {
    box.extend(mesh.V.row(mesh.T(t, k)).transpose());
  }
  return box;
}
}

bool MeetExactly(const TestMesh& mesh, Index s, Index t)
{
  return EdgesMeet(mesh, s, t) || EdgesMeet(mesh, t, s);
}

std::vector<std::pair<Index, Index>> CrossingPairs(const TestMesh& mesh)
{
  std::vector<std::pair<Index, Index>> pairs;
  std::vector<Eigen::AlignedBox3d> boxes;
  for (Index t = 0; t < mesh.T.rows(); ++t)
  {
    boxes.push_back(BoxOf(mesh, t));
    for (Index s = 0; s < t; ++s)
    {
      if (boxes[s].intersects(boxes[t]) &&
          (EdgePassesThrough(mesh, s, t) || EdgePassesThrough(mesh, t, s)))
      {
        pairs.emplace_back(s, t);
      }
    }
  }
  return pairs;
}

std::size_t CountNewCrossings(const TestMesh& before, const TestMesh& after)
{
  const auto old = CrossingPairs(before);
  const auto now = CrossingPairs(after);
  return static_cast<std::size_t>(std::count_if(now.begin(), now.end(),
    [&](const auto& pair) { return std::find(old.begin(), old.end(), pair) == old.end(); }));
}
