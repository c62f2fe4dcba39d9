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

/// Random triangles, in general position.
TestMesh RandomTriangles(Random& random, int triangles)
{
  TestMesh mesh{ random.Displacements(3 * triangles), Triangles(triangles, 3) };
  for (int k = 0; k < 3 * triangles; ++k)
  {
    mesh.T(k / 3, k % 3) = k;
  }
  return mesh;
}

double LargestErrorAtVertices(const TestMesh& surface, const TestMesh& reference)
{
  const Vector distances = Measure(surface, reference).atVertices;
  double error = 0;
  for (Index i = 0; i < distances.size(); ++i)
  {
    error =
      std::max(error, std::abs(distances[i] - DistanceToSurface(surface.V.row(i), reference)));
  }
  return error;
}

void CheckAgainstTrial(Checks& c)
{
  Random random;
  for (const int triangles : { 1, 3, 50, 700 })
  {
    c.Error("distances at the vertices are those found by trial",
      LargestErrorAtVertices(RandomTriangles(random, 60), RandomTriangles(random, triangles)),
      1e-14);
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

void CheckEmptySurfaces(Checks& c)
{
  TestMesh nothing = Grid(1, 0);
  nothing.T.resize(0, 3);
  c.True("a surface without triangles has no distance", Measure(nothing, Cube()).hausdorff == 0);
  c.Throws<InputError>(
    "a reference without triangles is an error", [&] { Measure(Cube(), nothing); });
}
}

int TestSurfaceDistance(int, char*[])
{
  Checks c;
  CheckAgainstTrial(c);
  CheckDirections(c);
  CheckEmptySurfaces(c);
  return c.Result();
}
