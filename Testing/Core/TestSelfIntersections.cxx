// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause

// Surfaces that meet themselves: which pairs of triangles are found, and that the mode within a
// deviation makes no new ones.
#include "Checks.h"
#include "CrossingTriangles.h"
#include "MeshMeasures.h"
#include "RandomMeshes.h"

#include "Core/Deviation/SelfIntersections.h"
#include "Core/Mesh/TriangleSeparation.h"
#include "Core/Optimizer/Optimizer.h"

#include <cmath>

using namespace lmo;

namespace
{
/// Two triangles with random corners on a grid of integers, some of which they share.
TestMesh RandomPair(Seeded& seeded, int shared, int size)
{
  TestMesh mesh;
  mesh.V = Points::NullaryExpr(6, 3, [&] { return double(seeded.Take(size)); });
  mesh.T.resize(2, 3);
  mesh.T << 0, 1, 2, 3, 4, 5;
  for (int k = 0; k < shared; ++k)
  {
    mesh.T(1, k) = mesh.T(0, k);
  }
  if (seeded.Take(3) == 0)
  {
    mesh.V.col(2).setZero(); // both in a plane
  }
  return mesh;
}

bool HasArea(const TestMesh& mesh, Index t)
{
  const Vector3 a = mesh.V.row(mesh.T(t, 1)) - mesh.V.row(mesh.T(t, 0));
  const Vector3 b = mesh.V.row(mesh.T(t, 2)) - mesh.V.row(mesh.T(t, 0));
  return !a.cross(b).isZero(0);
}

void CheckPairs(Checks& c)
{
  for (int shared = 0; shared < 3; ++shared)
  {
    Seeded seeded(1 + shared);
    int wrong = 0;
    int meeting = 0;
    int apart = 0;
    for (int k = 0; k < 40000 / Thinning; ++k)
    {
      const TestMesh mesh = RandomPair(seeded, shared, 3 + k % 6);
      if (HasArea(mesh, 0) && HasArea(mesh, 1))
      {
        const bool meet = MeetExactly(mesh, 0, 1);
        wrong += AreSeparate(mesh.V, mesh.T, 0, 1) == meet;
        meeting += meet;
        apart += !meet;
      }
    }
    const std::string kind = " with " + std::to_string(shared) + " common corners";
    c.Equal("pairs" + kind + " are apart where exact arithmetic says so", wrong, 0);
    c.Greater("some pairs" + kind + " meet", meeting, 500 / Thinning);
    c.Greater("some pairs" + kind + " are apart", apart, 500 / Thinning);
  }
}

/// A vertex with a fan of triangles around it whose rim is the given one.
TestMesh Fan(const Points& rim, bool isClosed)
{
  const auto size = static_cast<Index>(rim.rows());
  TestMesh mesh;
  mesh.V.resize(size + 1, 3);
  mesh.V << Vector3::Zero(), rim;
  mesh.T.resize(isClosed ? size : size - 1, 3);
  for (Index t = 0; t < mesh.T.rows(); ++t)
  {
    mesh.T.row(t) << 0, 1 + t, 1 + (t + 1) % size;
  }
  return mesh;
}

/// Points around the z axis that make so many turns.
Points Rim(int points, double turns, double height)
{
  Points rim(points, 3);
  for (int k = 0; k < points; ++k)
  {
    const double angle = 2 * 3.14159265358979 * turns * k / points;
    rim.row(k) << std::cos(angle), std::sin(angle), height * (k % 2 ? 1 : -1);
  }
  return rim;
}

bool IsFlat(const TestMesh& mesh)
{
  return IsFlatFan(mesh.V, mesh.T, BuildTopology(Index(mesh.V.rows()), mesh.T), 0);
}

void CheckFans(Checks& c)
{
  c.True("a closed fan is flat", IsFlat(Fan(Rim(7, 1, 0), true)));
  c.True("an open fan is flat", IsFlat(Fan(Rim(7, 0.9, 0.1), false)));
  c.True("so is one of half a turn", IsFlat(Fan(Rim(5, 0.5, 0), false)));
  c.True("a closed fan of two turns is not", !IsFlat(Fan(Rim(11, 2, 0), true)));
  c.True("an open fan of more than a turn is not", !IsFlat(Fan(Rim(11, 1.3, 0), false)));
  Points folded = Rim(6, 1, 0);
  folded.row(2) << 1, -0.2, 0;
  c.True("a fan with a triangle that is turned over is not", !IsFlat(Fan(folded, true)));
  TestMesh backwards = Fan(Rim(11, 1.3, 0), false);
  backwards.T = backwards.T.rowwise().reverse().colwise().reverse().eval();
  c.True("nor is an open fan of more than a turn the other way round", !IsFlat(backwards));
}

TestMesh Reversed(TestMesh mesh)
{
  mesh.T.col(1).swap(mesh.T.col(2));
  return mesh;
}

/// Makes a square in the plane bumpy.
TestMesh Bumpy(TestMesh layer, double height, double frequency)
{
  for (Eigen::Index i = 0; i < layer.V.rows(); ++i)
  {
    layer.V(i, 2) =
      height * std::sin(frequency * layer.V(i, 0)) * std::cos(frequency * layer.V(i, 1));
  }
  return layer;
}

/// Two layers of a bumpy square with a gap between them, and irregular triangles.
TestMesh Layers(int cells, double height, double frequency, double gap)
{
  TestMesh layer = Grid(cells, 0.3);
  layer.V /= cells;
  layer = Bumpy(layer, height, frequency);
  return Joined(layer, Reversed(Transformed(layer, 1, { 0, 0, gap })));
}

/// A wing with a sharp trailing edge: two layers that share the vertices of a line.
TestMesh Blade(int cells, double thickness)
{
  TestMesh blade = Layers(cells, 0, 1, 0);
  const Eigen::Index half = blade.V.rows() / 2;
  for (Eigen::Index i = 0; i < half; ++i)
  {
    const double x = blade.V(i, 0);
    const double z = thickness * x * (1.2 - x);
    blade.V(i, 2) = -z + 0.02 * std::sin(30 * x);
    blade.V(half + i, 2) = z + 0.02 * std::sin(30 * x);
  }
  for (Index& corner : blade.T.reshaped())
  {
    corner -= corner >= half && blade.V(corner, 0) == 0 ? Index(half) : 0;
  }
  return blade;
}

OptimizerResult Optimized(const TestMesh& mesh, double deviation)
{
  OptimizerOptions options;
  options.deviation.maximum = deviation;
  options.deviation.isAbsolute = true;
  options.detectFeatures = false;
  options.boundaryCondition = BoundaryCondition::SLIDING;
  ProgressMonitor monitor;
  return Optimize(mesh.V, mesh.T, options, {}, monitor);
}

/// No pair crosses that did not before, and the triangles got better.
void CheckNoNewPairs(Checks& c, const std::string& name, const TestMesh& mesh, double deviation)
{
  const OptimizerResult result = Optimized(mesh, deviation);
  c.Equal("no new pair meets: " + name, CountNewCrossings(mesh, { result.positions, mesh.T }), 0u);
  c.Equal("none is reported: " + name, result.intersections.added, 0);
  c.Greater("the triangles get better: " + name, result.comparison.after.mean,
    result.comparison.before->mean + 0.01);
}

void CheckThinWalls(Checks& c)
{
  constexpr int cells = Thinning > 1 ? 10 : 24;
  constexpr double deviation = 0.01;
  for (const double gap : { 0.1, 0.3, 1.0, 2.0 })
  {
    const std::string name = ", gap of " + std::to_string(gap) + " deviations";
    CheckNoNewPairs(c, "flat layers" + name, Layers(cells, 0, 1, gap * deviation), deviation);
    CheckNoNewPairs(c, "bumpy layers" + name, Layers(cells, 0.02, 25, gap * deviation), deviation);
    const TestMesh shell = WithThinTriangles(Icosphere(Thinning > 1 ? 2 : 3), 7, 0.8);
    CheckNoNewPairs(c, "nested shells" + name,
      Joined(shell, Reversed(Transformed(shell, 1 + gap * deviation))), deviation);
  }
  CheckNoNewPairs(c, "a blade", Blade(cells, 0.05), deviation);
}

/// The guarantee decides there: a bound alone lets the layers pass through each other.
void CheckControl(Checks& c)
{
  constexpr double deviation = 0.01;
  const TestMesh layers = Layers(24, 0.02, 25, 0.1 * deviation);
  const Eigen::Index half = layers.V.rows() / 2;
  const TestMesh first{ layers.V.topRows(half), layers.T.topRows(layers.T.rows() / 2) };
  TestMesh second{ layers.V.bottomRows(half),
    layers.T.bottomRows(layers.T.rows() / 2).array() - Index(half) };
  c.Equal("layers with a gap do not cross", CrossingPairs(layers).size(), 0u);
  const TestMesh alone = Joined({ Optimized(first, deviation).positions, first.T },
    { Optimized(second, deviation).positions, second.T });
  c.Greater("layers that do not know of each other do", CrossingPairs(alone).size(), 20u);
}

void CheckRandomMeshes(Checks& c)
{
  Index added = 0;
  Index crossing = 0;
  for (unsigned seed = 1; seed <= 200 / Thinning; ++seed)
  {
    Seeded seeded(seed);
    const TestMesh mesh = MakeRandomMesh(seeded);
    const OptimizerResult result = Optimized(mesh, 0.02);
    const std::size_t found = CountNewCrossings(mesh, { result.positions, mesh.T });
    added += static_cast<Index>(found);
    crossing += result.intersections.before > 0;
  }
  c.Equal("no new pair meets in random meshes", added, 0);
  c.Greater("some of these meet themselves in the input", crossing, 20 / Thinning);
}

/// Two layers with folded triangles: such triangles have to stay or go back, and then others must
/// not be in their place.
void CheckFoldedLayers(Checks& c)
{
  std::size_t added = 0;
  for (unsigned seed = 225; seed <= 265; seed += Thinning)
  {
    Seeded seeded(seed);
    OptimizerOptions options;
    options.deviation.maximum = std::pow(10, seeded.Number(-3, -1.7));
    options.deviation.improveWorstTriangles = false;
    options.detectFeatures = seeded.Take(2);
    options.boundaryCondition = static_cast<BoundaryCondition>(seeded.Take(3));
    TestMesh layer = Grid(12, 0.5);
    layer.V = (layer.V + 0.1 * seeded.Vectors(layer.V.rows())) / 12;
    const double height = seeded.Number(0, 0.03);
    layer = Bumpy(layer, height, seeded.Number(5, 60));
    const double gap = seeded.Number(0.1, 2) * 1.4 * options.deviation.maximum;
    const TestMesh layers = Joined(layer, Transformed(layer, 1, { 0, 0, gap }));
    ProgressMonitor monitor;
    const OptimizerResult result = Optimize(layers.V, layers.T, options, {}, monitor);
    added += CountNewCrossings(layers, { result.positions, layers.T });
  }
  c.Equal("no new pair meets in layers with folded triangles", added, 0u);
}

void CheckReport(Checks& c)
{
  const TestMesh sphere = Icosphere(2);
  const TestMesh mesh = Joined(sphere, Transformed(sphere, 1, { 0.7, 0.1, 0.2 }));
  const auto crossing = CrossingPairs(mesh);
  const OptimizerResult result = Optimized(mesh, 0.001);
  c.Equal("the pairs of the input are counted", result.intersections.before, crossing.size());
  Mask isExpected(mesh.T.rows(), false);
  for (const auto& [s, t] : CrossingPairs({ result.positions, mesh.T }))
  {
    isExpected[s] = isExpected[t] = true;
  }
  c.Equal(
    "the triangles that meet others are marked", result.intersections.isIntersecting, isExpected);
  OptimizerOptions options;
  options.mode = Mode::SMOOTH;
  options.positionWeighting = PositionWeighting::CONSTANT;
  options.scaleFactor = 0.03;
  ProgressMonitor monitor;
  c.True("other modes do not look for pairs",
    !Optimize(mesh.V, mesh.T, options, {}, monitor).intersections.isKnown);
  options.checkSelfIntersections = true;
  const TestMesh near = Joined(Transformed(sphere, 0.24, { 0.25, 0.25, 0.25 }), Cube(2));
  VertexArrays arrays;
  arrays.fixedPoints = Vector::Zero(near.V.rows());
  arrays.fixedPoints->head(sphere.V.rows()).setOnes();
  const OptimizerResult smoothed = Optimize(near.V, near.T, options, arrays, monitor);
  c.Equal("with the check they count what is new", smoothed.intersections.added,
    CountNewCrossings(near, { smoothed.positions, near.T }));
  c.Greater("there is something new", smoothed.intersections.added, 5);
}
}

int TestSelfIntersections(int argc, char* argv[])
{
  Groups groups(argc, argv);
  groups.Run("Pairs", CheckPairs);
  groups.Run("Fans", CheckFans);
  groups.Run("ThinWalls", CheckThinWalls);
  groups.Run("Control", CheckControl);
  groups.Run("RandomMeshes", CheckRandomMeshes);
  groups.Run("FoldedLayers", CheckFoldedLayers);
  groups.Run("Report", CheckReport);
  return groups.Result();
}
