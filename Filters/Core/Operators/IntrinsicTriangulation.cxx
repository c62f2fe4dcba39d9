// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Operators/IntrinsicTriangulation.h"

#include "Core/Mesh/MeshTopology.h"
#include "Core/Mesh/TriangleGeometry.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace lmo
{
namespace
{
/// A side of a triangle of the mesh and the edge it lies on.
struct EdgeSide
{
  Index low;
  Index high;
  Index side;

  bool operator<(const EdgeSide& other) const
  {
    return std::tie(this->low, this->high, this->side) <
           std::tie(other.low, other.high, other.side);
  }
  bool SharesEdge(const EdgeSide& other) const
  {
    return this->low == other.low && this->high == other.high;
  }
};

/// Sides of the cover: triangle 2 t is the front of t, 2 t + 1 its back with the corners 0, 2, 1.
Index FrontSide(Index side)
{
  return 6 * (side / 3) + side % 3;
}
Index BackSide(Index side)
{
  return 6 * (side / 3) + 5 - side % 3;
}

Triangles WithoutDegenerate(const Triangles& triangles)
{
  Triangles kept(triangles.rows(), 3);
  Index count = 0;
  for (Index t = 0; t < triangles.rows(); ++t)
  {
    if (!IsDegenerate(triangles, t))
    {
      kept.row(count++) = triangles.row(t);
    }
  }
  return kept.topRows(count);
}

std::vector<EdgeSide> SidesByEdge(const Triangles& triangles)
{
  std::vector<EdgeSide> sides;
  sides.reserve(triangles.size());
  for (Index t = 0; t < triangles.rows(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      const auto [low, high] = std::minmax(triangles(t, k), triangles(t, (k + 1) % 3));
      sides.push_back({ low, high, 3 * t + k });
    }
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}

/// Sorts the triangles at one edge by their angle around it, counter-clockwise.
void SortAroundEdge(
  const Points& V, const Triangles& triangles, EdgeSide* begin, const EdgeSide* end)
{
  const Vector3 start = V.row(begin->low);
  const Vector3 axis = (V.row(begin->high) - start).stableNormalized();
  const auto arm = [&](const EdgeSide& at) -> Vector3
  {
    const Vector3 x = V.row(triangles.data()[PreviousCorner(at.side)]) - start;
    return x - x.dot(axis) * axis;
  };
  const Vector3 reference = arm(*begin);
  std::vector<std::pair<double, EdgeSide>> sorted;
  for (const EdgeSide* at = begin; at != end; ++at)
  {
    const Vector3 x = arm(*at);
    sorted.emplace_back(std::atan2(axis.dot(reference.cross(x)), reference.dot(x)), *at);
  }
  std::sort(sorted.begin(), sorted.end());
  std::transform(
    sorted.begin(), sorted.end(), begin, [](const auto& entry) { return entry.second; });
}

/// Glues the triangles at one edge in a circle: the copy of each that leads up the edge faces the
/// copy of the next that leads down.
void GlueAroundEdge(
  const Triangles& triangles, const EdgeSide* begin, const EdgeSide* end, std::vector<Index>& twins)
{
  for (const EdgeSide* at = begin; at != end; ++at)
  {
    const EdgeSide* next = at + 1 == end ? begin : at + 1;
    const bool isUp = triangles.data()[at->side] == at->low;
    const bool isNextUp = triangles.data()[next->side] == next->low;
    const Index up = isUp ? FrontSide(at->side) : BackSide(at->side);
    const Index down = isNextUp ? BackSide(next->side) : FrontSide(next->side);
    twins[up] = down;
    twins[down] = up;
  }
}

/// Four times the area of a triangle with these sides (Kahan 2014), 0 if there is none.
double FourAreas(double a, double b, double c)
{
  if (a < b)
  {
    std::swap(a, b);
  }
  if (a < c)
  {
    std::swap(a, c);
  }
  if (b < c)
  {
    std::swap(b, c);
  }
  const double square = (a + (b + c)) * (c - (a - b)) * (c + (a - b)) * (a + (b - c));
  return square > 0 ? std::sqrt(square) : 0;
}

/// Cotangent of the angle opposite to a side.
double OppositeCotangent(const IntrinsicTriangulation& triangulation, Index side)
{
  const double a = triangulation.lengths[side];
  const double b = triangulation.lengths[NextCorner(side)];
  const double c = triangulation.lengths[PreviousCorner(side)];
  const double fourAreas = FourAreas(a, b, c);
  return fourAreas > 0 ? std::clamp((b * b + (c - a) * (c + a)) / fourAreas, -MaximumCotangent,
                           MaximumCotangent)
                       : 0;
}

/// Position of the corner opposite to a side that lies on the x axis, from its tail.
Eigen::Vector2d OppositeCorner(const IntrinsicTriangulation& triangulation, Index side)
{
  const double a = triangulation.lengths[side];
  const double b = triangulation.lengths[NextCorner(side)];
  const double c = triangulation.lengths[PreviousCorner(side)];
  return { (a * a + (c - b) * (c + b)) / (2 * a), FourAreas(a, b, c) / (2 * a) };
}

/// Length of the other diagonal of the two triangles at a side, unfolded.
double OtherDiagonal(const IntrinsicTriangulation& triangulation, Index side)
{
  const Eigen::Vector2d above = OppositeCorner(triangulation, side);
  const Eigen::Vector2d turned = OppositeCorner(triangulation, triangulation.twins[side]);
  const Eigen::Vector2d below(triangulation.lengths[side] - turned.x(), -turned.y());
  return (above - below).norm();
}

/// Replaces an edge by the other diagonal. Its two sides keep their numbers; the four around them
/// move on by one place, clockwise.
void Flip(IntrinsicTriangulation& triangulation, Index side, double length)
{
  std::vector<Index>& twins = triangulation.twins;
  const Index twin = twins[side];
  const Index from[4] = { NextCorner(side), PreviousCorner(side), NextCorner(twin),
    PreviousCorner(twin) };
  const Index to[4] = { from[1], from[2], from[3], from[0] };
  const auto moved = [&](Index old)
  {
    const Index* found = std::find(from, from + 4, old);
    return found == from + 4 ? old : to[found - from];
  };
  Index tails[4];
  Index partners[4];
  double lengths[4];
  for (int k = 0; k < 4; ++k)
  {
    tails[k] = triangulation.tails[from[k]];
    lengths[k] = triangulation.lengths[from[k]];
    partners[k] = moved(twins[from[k]]);
  }
  for (int k = 0; k < 4; ++k)
  {
    triangulation.tails[to[k]] = tails[k];
    triangulation.lengths[to[k]] = lengths[k];
    twins[to[k]] = partners[k];
    twins[partners[k]] = to[k];
  }
  triangulation.tails[side] = tails[1];
  triangulation.tails[twin] = tails[3];
  triangulation.lengths[side] = triangulation.lengths[twin] = length;
}
}

double IntrinsicTriangulation::CotangentSum(Index side) const
{
  return OppositeCotangent(*this, side) + OppositeCotangent(*this, this->twins[side]);
}

IntrinsicTriangulation TuftedCover(const Points& V, const Triangles& all)
{
  const Triangles triangles = WithoutDegenerate(all);
  std::vector<EdgeSide> sides = SidesByEdge(triangles);
  IntrinsicTriangulation cover;
  const std::size_t size = 6 * std::size_t(triangles.rows());
  cover.tails.assign(size, 0);
  cover.twins.assign(size, -1);
  cover.lengths.assign(size, 0);
  for (const EdgeSide& at : sides)
  {
    const double length = (V.row(at.high) - V.row(at.low)).stableNorm();
    cover.unit += length / double(sides.size());
    for (const Index copy : { FrontSide(at.side), BackSide(at.side) })
    {
      cover.lengths[copy] = length;
    }
    cover.tails[FrontSide(at.side)] = triangles.data()[at.side];
    cover.tails[BackSide(at.side)] = triangles.data()[NextCorner(at.side)];
  }
  for (double& length : cover.lengths)
  {
    length /= cover.unit > 0 ? cover.unit : 1;
  }
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end)
  {
    while (end < sides.size() && sides[end].SharesEdge(sides[begin]))
    {
      ++end;
    }
    if (end - begin > 2)
    {
      SortAroundEdge(V, triangles, sides.data() + begin, sides.data() + end);
    }
    GlueAroundEdge(triangles, sides.data() + begin, sides.data() + end, cover.twins);
  }
  return cover;
}

void Mollify(IntrinsicTriangulation& triangulation)
{
  constexpr double margin = 1e-5;
  double missing = 0;
  for (Index side = 0; side < triangulation.Size(); ++side)
  {
    const double detour =
      triangulation.lengths[NextCorner(side)] + triangulation.lengths[PreviousCorner(side)];
    missing = std::max(missing, margin + triangulation.lengths[side] - detour);
  }
  for (double& length : triangulation.lengths)
  {
    length += missing;
  }
}

std::int64_t FlipToDelaunay(IntrinsicTriangulation& triangulation)
{
  constexpr double roundOff = 1e-10;
  const std::int64_t affordableFlips = 100 * std::int64_t(triangulation.Size());
  std::vector<Index> stack;
  Mask isOnStack(triangulation.Size(), 1);
  for (Index side = triangulation.Size() - 1; side >= 0; --side)
  {
    stack.push_back(side);
  }
  std::int64_t flips = 0;
  while (!stack.empty() && flips < affordableFlips)
  {
    const Index side = stack.back();
    stack.pop_back();
    isOnStack[side] = 0;
    const Index twin = triangulation.twins[side];
    if (side / 3 == twin / 3 || triangulation.CotangentSum(side) >= -roundOff)
    {
      continue;
    }
    const double length = OtherDiagonal(triangulation, side);
    if (!(length > 0))
    {
      continue;
    }
    Flip(triangulation, side, length);
    ++flips;
    for (const Index other :
      { NextCorner(side), PreviousCorner(side), NextCorner(twin), PreviousCorner(twin) })
    {
      if (!isOnStack[other])
      {
        isOnStack[other] = 1;
        stack.push_back(other);
      }
    }
  }
  return flips;
}
}
