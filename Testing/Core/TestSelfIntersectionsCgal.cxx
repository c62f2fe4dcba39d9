// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause

// CGAL's exact predicates find the pairs of triangles that the code under test finds, and none
// that are new within a deviation.
#include "Checks.h"
#include "ExactIntersections.h"
#include "RandomMeshes.h"

#include "Core/Optimizer/Optimizer.h"

#include <cmath>
#include <utility>

using namespace lmo;

namespace
{
void CheckRandomMeshes(Checks& c)
{
  std::size_t added = 0;
  std::size_t meeting = 0;
  Index improved = 0;
  for (unsigned seed = 1; seed <= 400 / Thinning; ++seed)
  {
    Seeded seeded(seed);
    const TestMesh mesh = MakeRandomMesh(seeded);
    const ExactPairs before = FindExactIntersections(mesh);
    OptimizerOptions options;
    options.deviation.maximum = seeded.Number(0.001, 0.03);
    options.detectFeatures = seeded.Take(2);
    options.boundaryCondition = static_cast<BoundaryCondition>(seeded.Take(3));
    ProgressMonitor monitor;
    const OptimizerResult result = Optimize(mesh.V, mesh.T, options, {}, monitor);
    for (const auto& pair : FindExactIntersections({ result.positions, mesh.T }))
    {
      added += before.count(pair) == 0;
    }
    meeting += before.size();
    improved += result.comparison.after.mean > result.comparison.before->mean + 0.001;
  }
  c.Equal("no pair of triangles meets that did not before, in exact arithmetic", added, 0u);
  c.Greater("many meet in the input", meeting, 1000u / Thinning);
  c.Greater("many meshes get better", improved, 50 / Thinning);
}

/// Two layers of the same sampling.
TestMesh Layers(double height, double frequency, double gap)
{
  TestMesh layer = Grid(30, 0.3);
  layer.V /= 30;
  for (Eigen::Index i = 0; i < layer.V.rows(); ++i)
  {
    layer.V(i, 2) =
      height * std::sin(frequency * layer.V(i, 0)) * std::cos(frequency * layer.V(i, 1));
  }
  TestMesh mesh;
  mesh.V.resize(2 * layer.V.rows(), 3);
  mesh.V << layer.V, layer.V.rowwise() + Vector3(0, 0, gap);
  mesh.T.resize(2 * layer.T.rows(), 3);
  mesh.T << layer.T, layer.T.array() + Index(layer.V.rows());
  return mesh;
}

void CheckLayers(Checks& c)
{
  for (const auto& [mesh, deviation] : { std::make_pair(Layers(0.02, 25, 0.001), 0.005),
         std::make_pair(Layers(0.01, 60, 0.003), 0.005) })
  {
    OptimizerOptions options;
    options.deviation.maximum = deviation;
    options.detectFeatures = false;
    ProgressMonitor monitor;
    const OptimizerResult result = Optimize(mesh.V, mesh.T, options, {}, monitor);
    c.Equal("two layers do not meet before", FindExactIntersections(mesh).size(), 0u);
    c.Equal("nor after", FindExactIntersections({ result.positions, mesh.T }).size(), 0u);
    c.Greater("their triangles get better", result.comparison.after.mean,
      result.comparison.before->mean + 0.01);
  }
}
}

int TestSelfIntersectionsCgal(int argc, char* argv[])
{
  Groups groups(argc, argv);
  groups.Run("RandomMeshes", CheckRandomMeshes);
  groups.Run("Layers", CheckLayers);
  return groups.Result();
}
