// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "MeshMeasures.h"

#include "Core/Deviation/SurfaceSampler.h"

#include <algorithm>
#include <cmath>

using namespace lmo;

namespace
{
Points Samples(const TestMesh& mesh, Index count)
{
  const SurfaceSampler sampler(mesh.V, mesh.T);
  Points samples(count, 3);
  for (Index k = 0; k < count; ++k)
  {
    samples.row(k) = sampler.Sample(k, count);
  }
  return samples;
}

double OffSurface(const TestMesh& mesh)
{
  double distance = 0;
  const Points samples = Samples(mesh, 500);
  for (const auto& sample : samples.rowwise())
  {
    distance = Larger(distance, DistanceToSurface(sample, mesh));
  }
  return distance;
}

/// The triangles of a mesh without common vertices, one above the other.
TestMesh Separated(const TestMesh& mesh)
{
  TestMesh result{ Points(3 * mesh.T.rows(), 3), mesh.T };
  for (Index t = 0; t < mesh.T.rows(); ++t)
  {
    for (Index corner = 0; corner < 3; ++corner)
    {
      result.T(t, corner) = 3 * t + corner;
      result.V.row(3 * t + corner) = mesh.V.row(mesh.T(t, corner)) + Vector3(0, 0, t);
    }
  }
  return result;
}

/// Largest difference of a triangle's number of samples from its share of the area.
double UnevennessOverTriangles(const TestMesh& mesh, Index count)
{
  const Points samples = Samples(mesh, count);
  double unevenness = 0;
  for (Eigen::Index t = 0; t < mesh.T.rows(); ++t)
  {
    const double inside =
      static_cast<double>(std::count_if(samples.rowwise().begin(), samples.rowwise().end(),
        [&](const auto& sample) { return DistanceToTriangle(sample, mesh, t) < 1e-12; }));
    const double share = SurfaceArea({ mesh.V, mesh.T.row(t) }) / SurfaceArea(mesh);
    unevenness = Larger(unevenness, std::abs(inside - share * count));
  }
  return unevenness;
}

/// Largest difference from a quarter of the share of samples in a quarter of a triangle.
double UnevennessWithinTriangle(Index count)
{
  const Points samples = Samples(EquilateralTriangle(), count);
  const Points corners = EquilateralTriangle().V;
  double unevenness = 0;
  for (int corner = 0; corner < 3; ++corner)
  {
    const Points quarter = (corners.rowwise() + corners.row(corner)) / 2;
    const double inside =
      static_cast<double>(std::count_if(samples.rowwise().begin(), samples.rowwise().end(),
        [&](const auto& sample) {
          return DistanceToTriangle(sample, quarter.row(0), quarter.row(1), quarter.row(2)) < 1e-12;
        }));
    unevenness = Larger(unevenness, std::abs(inside / count - 0.25));
  }
  return unevenness;
}

void CheckAllMeshes(Checks& c)
{
  for (const auto& [name, mesh] : AllTestMeshes())
  {
    c.Error("samples lie on the surface: " + name, OffSurface(mesh), 1e-12);
    c.Error("the sampler's area is the surface's: " + name,
      std::abs(SurfaceSampler(mesh.V, mesh.T).Area() / SurfaceArea(mesh) - 1), 1e-14);
  }
}

void CheckDistribution(Checks& c)
{
  const TestMesh grid = Grid(4, 0.3);
  c.Error(
    "equal areas get equal numbers of samples", UnevennessOverTriangles(Separated(grid), 2000), 1);
  c.Error("samples are spread evenly within a triangle", UnevennessWithinTriangle(2000), 0.005);
  c.Error("the samples are the same in every run",
    MaximumDistance(Samples(grid, 100), Samples(grid, 100)), 0);
  c.Error("no triangles have no area", SurfaceSampler(Points(0, 3), Triangles(0, 3)).Area(), 0);
}
}

int TestSurfaceSampler(int argc, char* argv[])
{
  Groups groups(argc, argv);
  groups.Run("AllMeshes", CheckAllMeshes);
  groups.Run("Distribution", CheckDistribution);
  return groups.Result();
}
