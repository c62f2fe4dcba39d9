// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "MeshFixtures.h"

#include "Core/Mesh/MeshTopology.h"
#include "Core/Mesh/SurfaceWalk.h"
#include "Core/Mesh/TriangleGeometry.h"

#include <algorithm>
#include <limits>

using namespace lmo;

namespace
{
Vector3 PointAt(const TestMesh& mesh, const SurfaceLocation& location)
{
  return location.weights * CornersOf(mesh.V, mesh.T, location.triangle);
}

/// The smallest distance between x and any triangle.
double DistanceByBruteForce(const TestMesh& mesh, const Vector3& x)
{
  double distance = std::numeric_limits<double>::infinity();
  for (Index t = 0; t < mesh.T.rows(); ++t)
  {
    const TriangleCorners abc = CornersOf(mesh.V, mesh.T, t);
    distance = std::min(
      distance, (ClosestPointOnTriangle(x, abc.row(0), abc.row(1), abc.row(2)) - x).norm());
  }
  return distance;
}

/// The largest difference between the distances that the walk and brute force find, for points that
/// lie up to \a displacement beside the vertices, drawn together to \a scale, that the walk begins
/// at.
double WalkError(const TestMesh& mesh, double displacement, double scale = 1)
{
  const auto size = static_cast<Index>(mesh.V.rows());
  const AdjacencyLists cornersAt = CornersAtVertices(size, mesh.T);
  const Points moved = scale * mesh.V + displacement * Random().Displacements(size);
  double error = 0;
  for (Index i = 0; i < size; ++i)
  {
    const Vector3 x = moved.row(i);
    const SurfaceLocation location = WalkToClosestPoint({ mesh.V, mesh.T, cornersAt }, i, x);
    error =
      Larger(error, std::abs((PointAt(mesh, location) - x).norm() - DistanceByBruteForce(mesh, x)));
  }
  return error;
}

/// How far the weights are from those of a point inside its triangle.
double WeightError(const SurfaceLocation& location)
{
  return Larger(std::abs(location.weights.sum() - 1), -location.weights.minCoeff());
}

SurfaceLocation Walk(const TestMesh& mesh, Index vertex, const Vector3& x)
{
  const auto size = static_cast<Index>(mesh.V.rows());
  const AdjacencyLists cornersAt = CornersAtVertices(size, mesh.T);
  return WalkToClosestPoint({ mesh.V, mesh.T, cornersAt }, vertex, x);
}

/// Two squares of 8 x 8 cells, one .1 above the other.
TestMesh TwoSheets()
{
  const TestMesh sheet = Grid(8, 0);
  return Joined(sheet, Transformed(sheet, 1, { 0, 0, 0.1 }));
}
}

int TestSurfaceWalk(int, char*[])
{
  Checks c;
  c.Error("the walk finds the closest point of a sphere", WalkError(Icosphere(3), 0.1), 1e-14);
  const TestMesh uneven = Irregular(Icosphere(2), 0.03);
  c.Error("the walk finds the closest point of an uneven surface", WalkError(uneven, 0.05), 1e-14);
  c.Error("so it does for points below the vertex", WalkError(uneven, 0.003, 0.97), 1e-14);
  c.Error(
    "the walk leads across many triangles of a flat square", WalkError(Grid(24, 0.3), 5), 1e-14);
  c.Error(
    "the walk goes around vertices of many triangles", WalkError(UvSphere(150, 40), 0.005), 1e-14);
  c.Error("a vertex that did not move stays at its corner",
    std::abs(Walk(Grid(8, 0.2), 40, Grid(8, 0.2).V.row(40)).weights.maxCoeff() - 1), 0);

  const TestMesh sheets = TwoSheets();
  const Vector3 x(5.3, 2.4, 0.09);
  const SurfaceLocation below = Walk(sheets, 20, x);
  c.Error("the walk stays on its sheet", std::abs(PointAt(sheets, below)[2]), 0);
  c.Error("the weights are those of a point inside the triangle", WeightError(below), 1e-15);
  c.Error("the weights give the closest point",
    (PointAt(sheets, below) - Vector3(5.3, 2.4, 0)).norm(), 1e-14);
  c.Less("an isolated vertex has no triangle", Walk(WithIsolatedPoint(Cube()), 0, x).triangle, 0);
  return c.Result();
}
