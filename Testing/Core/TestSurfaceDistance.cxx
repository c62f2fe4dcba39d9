// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "MeshMeasures.h"

#include "Core/Deviation/SurfaceDistance.h"
#include "Core/Mesh/TriangleBvh.h"

#include <cmath>

using namespace lmo;

namespace
{
SurfaceDistance Measure(const TestMesh& surface, const TestMesh& reference, Index samples = 1000)
{
  ProgressMonitor monitor;
  return MeasureSurfaceDistance(surface.V, surface.T, reference.V, reference.T, samples, monitor);
}

/// Points of a fine grid over each triangle.
Points FineGrid(const TestMesh& mesh, int cells)
{
  std::vector<Vector3> points;
  for (const auto& T : mesh.T.rowwise())
  {
    for (int i = 0; i <= cells; ++i)
    {
      for (int j = 0; i + j <= cells; ++j)
      {
        points.emplace_back(
          (i * mesh.V.row(T[0]) + j * mesh.V.row(T[1]) + (cells - i - j) * mesh.V.row(T[2])) /
          cells);
      }
    }
  }
  Points result(points.size(), 3);
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    result.row(k) = points[k];
  }
  return result;
}

Vector DistancesByTrial(const Points& points, const TestMesh& mesh)
{
  Vector distances(points.rows());
  for (Eigen::Index i = 0; i < points.rows(); ++i)
  {
    distances[i] = DistanceToSurface(points.row(i), mesh);
  }
  return distances;
}

void CheckAgainstTrial(Checks& c)
{
  Random random;
  for (const int triangles : { 1, 3, 50, 700 })
  {
    const TestMesh surface = RandomTriangles(random, 60);
    const TestMesh reference = RandomTriangles(random, triangles);
    c.Error("distances at the vertices are those found by trial",
      LargestMagnitude(
        Measure(surface, reference).atVertices - DistancesByTrial(surface.V, reference)),
      1e-14);
  }
}

void CheckHausdorffAgainstTrial(Checks& c)
{
  Random random;
  for (int k = 0; k < 5; ++k)
  {
    const TestMesh a = RandomTriangles(random, 8), b = RandomTriangles(random, 5);
    const double forth = Measure(a, b, 10000).hausdorff, back = Measure(b, a, 10000).hausdorff;
    const double hausdorff = std::max(DistancesByTrial(FineGrid(a, 50), b).maxCoeff(),
      DistancesByTrial(FineGrid(b, 50), a).maxCoeff());
    // Both are lower bounds, from points that are about 0.03 apart.
    c.Error("the Hausdorff distance is that found by trial", std::abs(forth - hausdorff), 0.02);
    c.Error("the Hausdorff distance is the same in both directions", std::abs(forth - back), 1e-15);
  }
}

void CheckDirections(Checks& c)
{
  const TestMesh part = Grid(1, 0);
  TestMesh whole = Grid(3, 0);
  const SurfaceDistance forth = Measure(part, whole, 100000);
  const SurfaceDistance back = Measure(whole, part, 100000);
  c.Error("a part has no distance to the whole", LargestMagnitude(forth.atVertices), 1e-15);
  c.Error("the Hausdorff distance is that of both directions",
    std::abs(forth.hausdorff - 2 * std::sqrt(2)) + std::abs(forth.hausdorff - back.hausdorff),
    1e-14);
  c.Error("the mean is that of both directions", std::abs(forth.mean - back.mean), 1e-15);
  c.Error("the diagonal is the reference's",
    std::abs(forth.diagonal - 3 * std::sqrt(2)) + std::abs(back.diagonal - std::sqrt(2)), 1e-15);
}

void CheckInterior(Checks& c)
{
  const TestMesh triangle = EquilateralTriangle();
  TestMesh rim{ Points(6, 3), Triangles(3, 3) };
  rim.V.topRows(3) = triangle.V;
  const Vector3 centre = triangle.V.colwise().mean();
  for (int k = 0; k < 3; ++k)
  {
    rim.V.row(3 + k) = 0.98 * (triangle.V.row(k) + triangle.V.row((k + 1) % 3)) / 2 + 0.02 * centre;
    rim.T.row(k) << k, (k + 1) % 3, 3 + k;
  }
  const double edge = (triangle.V.row(1) - triangle.V.row(0)).norm();
  c.Error("the largest distance to the rim of a triangle is that of its centre",
    std::abs(Measure(triangle, rim, 10000).hausdorff - 0.98 * edge / std::sqrt(12)), 0.02 * edge);
}

void CheckEmptySurfaces(Checks& c)
{
  TestMesh nothing = Grid(1, 0);
  nothing.T.resize(0, 3);
  c.Equal("a surface without triangles has no distance", Measure(nothing, Cube()).hausdorff, 0);
  c.Throws<InputError>(
    "a reference without triangles is an error", [&] { Measure(Cube(), nothing); });
}
}

int TestSurfaceDistance(int argc, char* argv[])
{
  Groups groups(argc, argv);
  groups.Run("AgainstTrial", CheckAgainstTrial);
  groups.Run("HausdorffAgainstTrial", CheckHausdorffAgainstTrial);
  groups.Run("Directions", CheckDirections);
  groups.Run("Interior", CheckInterior);
  groups.Run("EmptySurfaces", CheckEmptySurfaces);
  return groups.Result();
}
