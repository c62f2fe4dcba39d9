// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause

// What Mode::OPTIMIZE_WITHIN_DEVIATION promises of single triangles and of sharp edges.
#include "Checks.h"
#include "MeshFixtures.h"

#include "Core/Mesh/TriangleGeometry.h"
#include "Core/Optimizer/Optimizer.h"

#include <algorithm>
#include <string>
#include <vector>

using namespace lmo;

namespace
{
OptimizerOptions WithinDeviation(double deviation)
{
  OptimizerOptions options;
  options.mode = Mode::OPTIMIZE_WITHIN_DEVIATION;
  options.deviation.maximum = deviation;
  return options;
}

/// A square bar of length 10 along x with k points on each of its four long edges and none
/// elsewhere: its faces are strips of needles.
TestMesh Bar(int k, std::vector<int>& faces)
{
  Random random;
  TestMesh bar{ Points(4 * k, 3), Triangles(8 * (k - 1) + 4, 3) };
  const double y[] = { 0, 0, 1, 1 };
  const double z[] = { 0, 1, 1, 0 };
  for (int j = 0; j < 4; ++j)
  {
    std::vector<double> x{ 0, 10 };
    while (int(x.size()) < k)
    {
      x.push_back(5 + 5 * random());
    }
    std::sort(x.begin(), x.end());
    for (int i = 0; i < k; ++i)
    {
      bar.V.row(k * j + i) << x[i], y[j], z[j];
    }
  }
  Index t = 0;
  for (int j = 0; j < 4; ++j)
  {
    const Index a = k * j;
    const Index b = k * ((j + 1) % 4);
    for (int i = 0, l = 0; i < k - 1 || l < k - 1;)
    {
      const bool isNextOnA = l == k - 1 || (i < k - 1 && bar.V(a + i + 1, 0) < bar.V(b + l + 1, 0));
      bar.T.row(t++) << a + i, (isNextOnA ? a + i + 1 : b + l + 1), b + l;
      ++(isNextOnA ? i : l);
      faces.push_back(j);
    }
  }
  bar.T.bottomRows(4) << 0, k, 2 * k, 0, 2 * k, 3 * k, k - 1, 4 * k - 1, 3 * k - 1, k - 1,
    3 * k - 1, 2 * k - 1;
  faces.insert(faces.end(), { 4, 4, 5, 5 });
  return bar;
}

/// Triangles whose normals have turned by more than a right angle.
Index CountTurned(const TestMesh& mesh, const Points& moved)
{
  Index count = 0;
  for (Index t = 0; t < mesh.T.rows(); ++t)
  {
    count += ScaledNormal(mesh.V, mesh.T, t).dot(ScaledNormal(moved, mesh.T, t)) < 0;
  }
  return count;
}

void CheckBars(Checks& c)
{
  for (const int k : { 12, 60 })
  {
    std::vector<int> faces;
    const TestMesh bar = Bar(k, faces);
    OptimizerOptions options = WithinDeviation(0.02);
    options.detectFeatures = false;
    ProgressMonitor monitor;
    const OptimizerResult free = Optimize(bar.V, bar.T, options, {}, monitor);
    const std::string name = "a bar of " + std::to_string(k) + " points an edge";
    c.True("no triangle turns over on " + name,
      CountTurned(bar, free.positions) == 0 && free.comparison.flippedTriangles == 0);

    VertexArrays arrays;
    arrays.labels = Eigen::Map<Eigen::VectorXi>(faces.data(), Index(faces.size())).cast<double>();
    const OptimizerResult fixed = Optimize(bar.V, bar.T, options, arrays, monitor);
    c.Error("no point of an edge leaves it on " + name,
      (fixed.positions - bar.V).rightCols(2).cwiseAbs().maxCoeff(), 1e-9 * 10);
    c.True("points slide along the edges of " + name,
      (fixed.positions - bar.V).col(0).cwiseAbs().maxCoeff() > 1e-3 &&
        (fixed.featureClass->array() == FeatureLines::CORNER).count() == 8);
  }
}

void CheckTurns(Checks& c)
{
  const auto check = [&](const std::string& name, const TestMesh& mesh)
  {
    ProgressMonitor monitor;
    const OptimizerResult result = Optimize(mesh.V, mesh.T, WithinDeviation(0.05), {}, monitor);
    c.True("no triangle turns over on " + name, result.comparison.flippedTriangles == 0);
    c.Error("the bound is at most the displacement on " + name,
      result.deviation.relativeBound - result.comparison.relativeMaximumDisplacement, 0);
  };
  check("a cylinder", CylinderPatch(1));
  check("a rough sphere", Irregular(Icosphere(2), 0.15));
  check("a sphere with degenerate triangles", WithThinTriangles(Icosphere(2), 20, 1));
  TestMesh inverted = Irregular(Icosphere(2), 0.05);
  inverted.T.row(5).reverseInPlace();
  check("a sphere with an inverted triangle", inverted);
}
}

int TestTurnedTriangles(int argc, char* argv[])
{
  Groups groups(argc, argv);
  groups.Run("Bars", CheckBars);
  groups.Run("Turns", CheckTurns);
  return groups.Result();
}
