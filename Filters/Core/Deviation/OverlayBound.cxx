// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Deviation/OverlayBound.h"

#include "Core/Deviation/SubdivisionBound.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace lmo
{
namespace
{
/// Round-off in barycentric coordinates, and the flattest triangle for which it is that small.
constexpr double Tolerance = 1e-9;
constexpr double FlattestTriangle = 1e-6;

/// Distances, in terms of the one allowed, at which no search for a closer triangle pays.
constexpr double HopelessReach = 3;

constexpr int LongestWalk = 32;
constexpr std::size_t LargestCover = 64;

/// Positive on the left of the edge from p to q.
double SideOf(const Eigen::Vector3d& p, const Eigen::Vector3d& q, double x, double y)
{
  return (q[0] - p[0]) * (y - p[1]) - (q[1] - p[1]) * (x - p[0]);
}

/// The third barycentric coordinate, or x or y.
double Barycentric(const Eigen::Vector3d& p, int k)
{
  return k == 2 ? 1 - p[0] - p[1] : p[k];
}

/// True if the edge from p to q passes through the inside of the triangle.
bool Crosses(const Eigen::Vector3d& p, const Eigen::Vector3d& q)
{
  const double a = SideOf(p, q, 0, 0);
  const double b = SideOf(p, q, 1, 0);
  const double c = SideOf(p, q, 0, 1);
  if (std::min({ a, b, c }) >= -Tolerance || std::max({ a, b, c }) <= Tolerance)
  {
    return false;
  }
  for (int k = 0; k < 3; ++k)
  {
    if (Barycentric(p, k) <= Tolerance && Barycentric(q, k) <= Tolerance)
    {
      return false;
    }
  }
  return true;
}

/// The part of a triangle that lies over the unit triangle: a convex polygon.
struct Piece
{
  Eigen::Vector3d corners[8];
  int size = 0;
};

/// Keeps what has the k-th barycentric coordinate >= 0.
void Clip(Piece& piece, int k)
{
  double sides[8];
  bool isOutside = false;
  for (int i = 0; i < piece.size; ++i)
  {
    sides[i] = Barycentric(piece.corners[i], k);
    isOutside = isOutside || sides[i] < 0;
  }
  if (!isOutside)
  {
    return;
  }
  const Piece whole = piece;
  piece.size = 0;
  for (int i = 0; i < whole.size; ++i)
  {
    const int next = i + 1 < whole.size ? i + 1 : 0;
    const Eigen::Vector3d& p = whole.corners[i];
    const Eigen::Vector3d& q = whole.corners[next];
    if (sides[i] >= 0)
    {
      piece.corners[piece.size++] = p;
    }
    if ((sides[i] >= 0) != (sides[next] >= 0))
    {
      piece.corners[piece.size++] = p + sides[i] / (sides[i] - sides[next]) * (q - p);
    }
  }
}

Piece Clip(const Eigen::Vector3d corners[3])
{
  Piece piece;
  piece.size = 3;
  std::copy(corners, corners + 3, piece.corners);
  for (int k = 0; k < 3; ++k)
  {
    Clip(piece, k);
  }
  return piece;
}
}

bool OverlayBound::SetFrame(const TriangleCorners& triangle)
{
  this->Origin = triangle.row(0);
  this->AB = triangle.row(1) - triangle.row(0);
  this->AC = triangle.row(2) - triangle.row(0);
  const Vector3 normal = this->AB.cross(this->AC);
  const double length = normal.norm();
  const double longest = std::max(
    { this->AB.squaredNorm(), this->AC.squaredNorm(), (this->AB - this->AC).eval().squaredNorm() });
  if (!(length > FlattestTriangle * longest))
  {
    return false;
  }
  const double scale = 1 / (length * length);
  this->Frame.row(0) = scale * this->AC.cross(normal);
  this->Frame.row(1) = scale * normal.cross(this->AB);
  this->Frame.row(2) = normal / length;
  return true;
}

OverlayBound::ProjectedTriangle OverlayBound::Project(const SurfaceView& mesh, Index t) const
{
  ProjectedTriangle part;
  for (int k = 0; k < 3; ++k)
  {
    part.corners[k] = this->Frame * (mesh.V.row(mesh.T(t, k)) - this->Origin).transpose();
  }
  part.orientation =
    SideOf(part.corners[0], part.corners[1], part.corners[2][0], part.corners[2][1]);
  return part;
}

Index OverlayBound::FindCentre(const SurfaceView& mesh, Index seed) const
{
  constexpr double centre = 1.0 / 3;
  Index t = seed;
  for (int step = 0; step < LongestWalk && t != NoNeighbour; ++step)
  {
    const ProjectedTriangle part = this->Project(mesh, t);
    if (!(part.orientation > Tolerance))
    {
      return -1;
    }
    int exit = 0;
    double farthest = 0;
    for (int k = 0; k < 3; ++k)
    {
      const double side = SideOf(part.corners[k], part.corners[(k + 1) % 3], centre, centre);
      if (side < farthest)
      {
        farthest = side;
        exit = k;
      }
    }
    if (farthest >= -Tolerance)
    {
      return t;
    }
    t = mesh.neighbours(t, exit);
  }
  return -1;
}

Index OverlayBound::FindCentre(const TriangleCorners& triangle, const SurfaceView& mesh, Index seed)
{
  return this->SetFrame(triangle) ? this->FindCentre(mesh, seed) : -1;
}

OverlayBound::Verdict OverlayBound::TestPiece(const SurfaceView& mesh, Subdivision* subdivision,
  Index t, const ProjectedTriangle& part, double distance)
{
  const Piece piece = Clip(part.corners);
  const TriangleCorners over = CornersOf(mesh.V, mesh.T, t);
  double reach = 0;
  for (int i = 0; i < piece.size; ++i)
  {
    const double height = piece.corners[i][2];
    this->Heights.Add(std::clamp(height, -distance, distance));
    if (std::abs(height) > distance)
    {
      const Vector3 point = this->PointAt(piece.corners[i]);
      const Vector3 closest = ClosestPointOnTriangle(point, over.row(0), over.row(1), over.row(2));
      reach = std::max(reach, (closest - point).norm());
    }
  }
  if (reach <= distance || reach > HopelessReach * distance || !subdivision)
  {
    return reach <= distance ? WITHIN : reach > HopelessReach * distance ? BEYOND : UNCLEAR;
  }
  for (int i = 2; i < piece.size; ++i)
  {
    TriangleCorners corners;
    corners << this->PointAt(piece.corners[0]), this->PointAt(piece.corners[i - 1]),
      this->PointAt(piece.corners[i]);
    const Nearness nearness = TestBySubdivision(corners, *subdivision, distance, t);
    if (!nearness.isProven)
    {
      return BEYOND;
    }
    this->Closer.insert(this->Closer.end(), nearness.used.begin(), nearness.used.end());
  }
  return WITHIN;
}

OverlayBound::Verdict OverlayBound::Test(const TriangleCorners& triangle, const SurfaceView& mesh,
  Subdivision* subdivision, Index seed, double distance)
{
  this->Used.clear();
  this->Closer.clear();
  this->Heights = {};
  const Index centre = this->FindCentre(triangle, mesh, seed);
  if (centre < 0)
  {
    return UNCLEAR;
  }
  this->Used.push_back(centre);
  for (std::size_t next = 0; next < this->Used.size(); ++next)
  {
    const Index t = this->Used[next];
    const ProjectedTriangle part = this->Project(mesh, t);
    if (!(part.orientation > Tolerance))
    {
      return UNCLEAR;
    }
    const Verdict verdict = this->TestPiece(mesh, subdivision, t, part, distance);
    if (verdict != WITHIN)
    {
      this->Used.push_back(t);
      return verdict;
    }
    for (int k = 0; k < 3; ++k)
    {
      if (Crosses(part.corners[k], part.corners[(k + 1) % 3]))
      {
        const Index neighbour = mesh.neighbours(t, k);
        if (neighbour == NoNeighbour || this->Used.size() == LargestCover)
        {
          return UNCLEAR;
        }
        if (std::find(this->Used.begin(), this->Used.end(), neighbour) == this->Used.end())
        {
          this->Used.push_back(neighbour);
        }
      }
    }
  }
  for (const Index t : this->Closer)
  {
    if (std::find(this->Used.begin(), this->Used.end(), t) == this->Used.end())
    {
      this->Used.push_back(t);
    }
  }
  return WITHIN;
}
}
