// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "TriangleCover.h"

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

/// Largest height, in magnitude, of the part of a triangle that lies over the unit triangle.
double LargestHeight(const Eigen::Vector3d corners[3])
{
  Eigen::Vector3d polygon[2][8];
  int size = 3;
  std::copy(corners, corners + 3, polygon[0]);
  for (int k = 0; k < 3; ++k)
  {
    const Eigen::Vector3d* in = polygon[k % 2];
    Eigen::Vector3d* out = polygon[(k + 1) % 2];
    int count = 0;
    for (int i = 0; i < size; ++i)
    {
      const Eigen::Vector3d& p = in[i];
      const Eigen::Vector3d& q = in[(i + 1) % size];
      const double atP = Barycentric(p, k);
      const double atQ = Barycentric(q, k);
      if (atP >= 0)
      {
        out[count++] = p;
      }
      if ((atP >= 0) != (atQ >= 0))
      {
        out[count++] = p + atP / (atP - atQ) * (q - p);
      }
    }
    size = count;
  }
  double height = 0;
  for (int i = 0; i < size; ++i)
  {
    height = std::max(height, std::abs(polygon[1][i][2]));
  }
  return height;
}
}

bool TriangleCover::SetFrame(const TriangleCorners& triangle)
{
  this->Origin = triangle.row(0);
  const Vector3 ab = triangle.row(1) - triangle.row(0);
  const Vector3 ac = triangle.row(2) - triangle.row(0);
  const Vector3 normal = ab.cross(ac);
  const double length = normal.norm();
  const double longest =
    std::max({ ab.squaredNorm(), ac.squaredNorm(), (ab - ac).eval().squaredNorm() });
  if (!(length > FlattestTriangle * longest))
  {
    return false;
  }
  const double scale = 1 / (length * length);
  this->Frame.row(0) = scale * ac.cross(normal);
  this->Frame.row(1) = scale * normal.cross(ab);
  this->Frame.row(2) = normal / length;
  return true;
}

TriangleCover::ProjectedTriangle TriangleCover::Project(const SurfaceView& mesh, Index t) const
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

Index TriangleCover::FindCentre(const SurfaceView& mesh, Index seed) const
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

TriangleCover::Verdict TriangleCover::TestPart(
  const SurfaceView& mesh, Index t, const ProjectedTriangle& part, double distance)
{
  double height = std::max({ std::abs(part.corners[0][2]), std::abs(part.corners[1][2]),
    std::abs(part.corners[2][2]) });
  if (height > distance)
  {
    height = LargestHeight(part.corners);
  }
  if (height <= distance)
  {
    this->Bound = std::max(this->Bound, height);
    return WITHIN;
  }
  const TriangleCorners corners = CornersOf(mesh.V, mesh.T, t);
  const Vector3 normal =
    (corners.row(1) - corners.row(0)).cross(corners.row(2) - corners.row(0)).stableNormalized();
  const double cosine = this->Frame.row(2).dot(normal);
  return height * cosine > distance ? BEYOND : UNCLEAR;
}

TriangleCover::Verdict TriangleCover::Test(
  const TriangleCorners& triangle, const SurfaceView& mesh, Index seed, double distance)
{
  this->Used.clear();
  this->Bound = 0;
  const Index centre = this->SetFrame(triangle) ? this->FindCentre(mesh, seed) : -1;
  if (centre < 0)
  {
    return UNCLEAR;
  }
  this->Used.push_back(centre);
  Verdict verdict = WITHIN;
  for (std::size_t next = 0; next < this->Used.size(); ++next)
  {
    const Index t = this->Used[next];
    const ProjectedTriangle part = this->Project(mesh, t);
    if (!(part.orientation > Tolerance))
    {
      return UNCLEAR;
    }
    const Verdict partVerdict = this->TestPart(mesh, t, part, distance);
    if (partVerdict == BEYOND)
    {
      this->Used.push_back(t);
      return BEYOND;
    }
    verdict = std::max(verdict, partVerdict);
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
  return verdict;
}
}
