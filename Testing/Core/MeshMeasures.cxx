// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshMeasures.h"

#include "Checks.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

using namespace lmo;

std::vector<Edge> BoundaryEdges(const TestMesh& mesh)
{
  std::map<Edge, int> trianglesAt;
  for (const auto& T : mesh.T.rowwise())
  {
    for (int k = 0; k < 3; ++k)
    {
      ++trianglesAt[EdgeBetween(T[k], T[(k + 1) % 3])];
    }
  }
  std::vector<Edge> edges;
  for (const auto& [edge, count] : trianglesAt)
  {
    if (count == 1)
    {
      edges.push_back(edge);
    }
  }
  return edges;
}

std::vector<bool> BoundaryVertices(const TestMesh& mesh)
{
  std::vector<bool> isBoundary(mesh.V.rows(), false);
  for (const auto& [i, j] : BoundaryEdges(mesh))
  {
    isBoundary[i] = isBoundary[j] = true;
  }
  return isBoundary;
}

std::vector<std::vector<Index>> Neighbours(const TestMesh& mesh)
{
  std::vector<std::set<Index>> sets(mesh.V.rows());
  for (const auto& T : mesh.T.rowwise())
  {
    for (int k = 0; k < 3; ++k)
    {
      sets[T[k]].insert({ T[(k + 1) % 3], T[(k + 2) % 3] });
    }
  }
  std::vector<std::vector<Index>> neighbours;
  for (const std::set<Index>& set : sets)
  {
    neighbours.emplace_back(set.begin(), set.end());
  }
  return neighbours;
}

double SurfaceArea(const TestMesh& mesh)
{
  double area = 0;
  for (const auto& T : mesh.T.rowwise())
  {
    const Vector3 a = mesh.V.row(T[0]), b = mesh.V.row(T[1]), c = mesh.V.row(T[2]);
    area += (b - a).cross(c - a).norm() / 2;
  }
  return area;
}

double LargestMagnitude(const Eigen::MatrixXd& x)
{
  return x.size() > 0 ? x.cwiseAbs().maxCoeff<Eigen::PropagateNaN>() : 0;
}

double MaximumDistance(const Points& a, const Points& b)
{
  return LargestMagnitude((a - b).rowwise().norm());
}

double DistanceToSegment(const Vector3& x, const Vector3& a, const Vector3& b)
{
  const Vector3 edge = b - a;
  const double along = edge.squaredNorm() > 0 ? (x - a).dot(edge) / edge.squaredNorm() : 0;
  return (a + std::clamp(along, 0.0, 1.0) * edge - x).norm();
}

double DistanceToTriangle(const Vector3& x, const Vector3& a, const Vector3& b, const Vector3& c)
{
  // x - a = u (b - a) + v (c - a) + w normal
  Matrix3 frame;
  frame << (b - a).transpose(), (c - a).transpose(), (b - a).cross(c - a).transpose();
  const Eigen::Vector3d uvw = frame.fullPivLu().solve((x - a).transpose());
  if (frame.determinant() != 0 && uvw[0] >= 0 && uvw[1] >= 0 && uvw[0] + uvw[1] <= 1)
  {
    return std::abs(uvw[2]) * frame.col(2).norm();
  }
  return std::min(
    { DistanceToSegment(x, a, b), DistanceToSegment(x, b, c), DistanceToSegment(x, c, a) });
}

double DistanceToTriangle(const Vector3& x, const TestMesh& mesh, Eigen::Index t)
{
  return DistanceToTriangle(
    x, mesh.V.row(mesh.T(t, 0)), mesh.V.row(mesh.T(t, 1)), mesh.V.row(mesh.T(t, 2)));
}

double DistanceToSurface(const Vector3& x, const TestMesh& mesh)
{
  double distance = INFINITY;
  for (Eigen::Index t = 0; t < mesh.T.rows(); ++t)
  {
    // No triangle is closer than its bounding box.
    Eigen::AlignedBox3d box(mesh.V.row(mesh.T(t, 0)).transpose());
    box.extend(mesh.V.row(mesh.T(t, 1)).transpose()).extend(mesh.V.row(mesh.T(t, 2)).transpose());
    if (!(box.exteriorDistance(Eigen::Vector3d(x)) > distance))
    {
      distance = std::min(distance, DistanceToTriangle(x, mesh, t));
    }
  }
  return distance;
}

Points GridOn(const TestMesh& mesh, Eigen::Index t)
{
  Points grid((GridSteps + 1) * (GridSteps + 2) / 2, 3);
  Eigen::Index row = 0;
  for (int i = 0; i <= GridSteps; ++i)
  {
    for (int j = 0; i + j <= GridSteps; ++j)
    {
      grid.row(row++) = (i * mesh.V.row(mesh.T(t, 0)) + j * mesh.V.row(mesh.T(t, 1)) +
                          (GridSteps - i - j) * mesh.V.row(mesh.T(t, 2))) /
                        GridSteps;
    }
  }
  return grid;
}

double LargestDistance(const TestMesh& from, const TestMesh& to)
{
  double largest = 0;
  for (Eigen::Index t = 0; t < from.T.rows(); ++t)
  {
    const Points grid = GridOn(from, t);
    for (const auto& x : grid.rowwise())
    {
      largest = Larger(largest, DistanceToSurface(x, to));
    }
  }
  return largest;
}

double DistanceToBoundary(const Vector3& x, const TestMesh& mesh)
{
  double distance = INFINITY;
  for (const auto& [i, j] : BoundaryEdges(mesh))
  {
    distance = std::min(distance, DistanceToSegment(x, mesh.V.row(i), mesh.V.row(j)));
  }
  return distance;
}
