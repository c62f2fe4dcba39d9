// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CadFixtures.h"
#include "Checks.h"
#include "MeshMeasures.h"

#include "Core/Deviation/DeviationGuard.h"
#include "Core/Deviation/OverlayBound.h"
#include "Core/Mesh/TriangleBvh.h"
#include "Core/Optimizer/Optimizer.h"
#include "Core/WorstTriangles/DistantVertices.h"
#include "Core/WorstTriangles/WorstTriangles.h"

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace lmo;

namespace
{
constexpr double RoundOff = 1e-15;

OptimizerOptions WithinDeviation(double deviation)
{
  OptimizerOptions options;
  options.mode = Mode::OPTIMIZE_WITHIN_DEVIATION;
  options.deviation.maximum = deviation;
  return options;
}

struct Outcome
{
  OptimizerResult result;
  double relativeDistance = 0; ///< of the larger way
};

Outcome Run(const TestMesh& mesh, const OptimizerOptions& options, ProgressMonitor& monitor)
{
  Outcome outcome;
  outcome.result = Optimize(mesh.V, mesh.T, options, {}, monitor);
  const TestMesh moved{ outcome.result.positions, mesh.T };
  const double diagonal = (mesh.V.colwise().maxCoeff() - mesh.V.colwise().minCoeff()).norm();
  outcome.relativeDistance =
    std::max(LargestDistance(moved, mesh), LargestDistance(mesh, moved)) / diagonal;
  return outcome;
}

Outcome Run(const TestMesh& mesh, const OptimizerOptions& options)
{
  ProgressMonitor monitor;
  return Run(mesh, options, monitor);
}

/// The promises of the mode on a mesh.
void CheckPromises(Checks& c, const std::string& name, const TestMesh& mesh, double deviation)
{
  const Outcome outcome = Run(mesh, WithinDeviation(deviation));
  const DeviationReport& report = outcome.result.deviation;
  const SurfaceComparison& comparison = outcome.result.comparison;
  c.Error(name + " stays within the deviation", outcome.relativeDistance, deviation);
  c.Error(name + " stays within the bound reported", outcome.relativeDistance,
    report.relativeBound + RoundOff);
  c.Error(name + " has a bound within the deviation", report.relativeBound, deviation);
  c.Error(name + " keeps its least radius ratio",
    comparison.before->minimum - comparison.after.minimum, RoundOff);
  c.Error(name + " keeps its mean radius ratio", comparison.before->mean - comparison.after.mean,
    RoundOff);
}

void CheckDistances(Checks& c)
{
  const TestMesh mesh = Irregular(Icosphere(2), 0.1);
  ProgressMonitor monitor;
  const TriangleBvh tree(mesh.V, mesh.T, monitor);
  Random random;
  double error = 0;
  for (int k = 0; k < 200; ++k)
  {
    const Vector3 x(1.5 * random(), 1.5 * random(), 1.5 * random());
    const double radius = 10 * DistanceToSurface(x, mesh);
    const double found = std::sqrt(tree.FindClosest(x, radius, k).squaredDistance);
    error = Larger(error, std::abs(found - DistanceToSurface(x, mesh)));
  }
  c.Error("the tree finds the distance that a search of all triangles finds", error, 1e-14);
  c.Equal("the tree finds nothing beyond the radius",
    tree.FindClosest(Vector3(5, 0, 0), 1, -1).triangle, -1);
}

void CheckRefit(Checks& c)
{
  TestMesh mesh = Irregular(Icosphere(2), 0.1);
  ProgressMonitor monitor;
  TriangleBvh tree(mesh.V, mesh.T, monitor);
  const Index moved = 17;
  mesh.V.row(moved) *= 3;
  std::vector<Index> changed;
  for (Index t = 0; t < mesh.T.rows(); ++t)
  {
    if ((mesh.T.row(t).array() == moved).any())
    {
      changed.push_back(t);
    }
  }
  tree.Invalidate(changed);
  tree.Refit();
  const Vector3 x = 1.1 * mesh.V.row(moved);
  const double distance = DistanceToSurface(x, mesh);
  c.Error("the tree finds a vertex that has moved out of its box",
    std::abs(std::sqrt(tree.FindClosest(x, 2 * distance, -1).squaredDistance) - distance), 1e-14);
}

void CheckGuarantee(Checks& c)
{
  CheckPromises(c, "an irregular sphere", Irregular(Icosphere(2), 0.08), 0.005);
  CheckPromises(c, "an irregular sphere with a small error", Irregular(Icosphere(2), 0.08), 0.001);
  CheckPromises(c, "a sphere with thin triangles", WithThinTriangles(Icosphere(2)), 0.005);
  CheckPromises(c, "a folded sphere", Irregular(Icosphere(2), 0.2), 0.005);
  CheckPromises(c, "an open grid", Grid(10, 0.4), 0.01);
  CheckPromises(c, "a half sphere", Irregular(HalfSphere(2), 0.05), 0.004);
  CheckPromises(c, "three wings", ThreeWings(), 0.01);
  CheckPromises(c, "two components", TwoComponents(), 0.003);
  CheckPromises(c, "a coarse cube", Cube(), 0.01);
}

/// Scales a flat square in small steps until the guard forbids it.
void CheckGrowth(Checks& c, const std::string& name, double growth)
{
  constexpr double distance = 0.1;
  const TestMesh square = Grid(10, 0);
  const MeshTopology topology = BuildTopology(static_cast<Index>(square.V.rows()), square.T);
  ProgressMonitor monitor;
  DeviationGuard guard(square.V, square.T, topology, distance, monitor);
  std::vector<Index> all(square.V.rows());
  std::iota(all.begin(), all.end(), 0);
  const Vector3 centre = square.V.colwise().mean();
  double reached = 0;
  double excess = 0;
  for (int step = 1; step < 100; ++step)
  {
    for (const Index i : all)
    {
      guard.Propose(i, centre + (1 + step * growth) * (square.V.row(i) - centre));
    }
    if (!guard.Judge(all, 0, DeviationGuard::MANY_VERTICES, monitor).empty())
    {
      break;
    }
    guard.Accept();
    const TestMesh moved{ guard.GetAccepted(), square.T };
    reached = std::max(LargestDistance(square, moved), LargestDistance(moved, square));
    excess = Larger(excess, reached - guard.GetBound() - RoundOff);
  }
  c.Error(name + " stays within the guard's bound", excess, 0);
  c.True(name + " comes to its end at the distance",
    reached <= distance && reached > distance - 2 * std::abs(growth) * centre.norm());
}

void CheckSteps(Checks& c)
{
  constexpr double growth = Thinning > 1 ? 0.01 : 0.002;
  CheckGrowth(c, "a square that grows", growth);
  CheckGrowth(c, "a square that shrinks", -growth);
}

void CheckFeatures(Checks& c)
{
  constexpr int level = Thinning > 1 ? 2 : 3;
  const TestMesh cube = Cube(level);
  const Outcome outcome = Run(cube, WithinDeviation(0.02));
  const Points& moved = outcome.result.positions;
  double error = 0;
  for (Index i = 0; i < moved.rows(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      const bool wasOnFace = cube.V(i, k) == 0 || cube.V(i, k) == 1;
      error = wasOnFace ? Larger(error, std::abs(moved(i, k) - cube.V(i, k))) : error;
    }
  }
  c.Error("points on faces, edges and corners of a cube stay on them", error, 1e-12);
  const auto count = [&](double value)
  { return (outcome.result.featureClass->array() == value).count(); };
  c.Equal("a cube has 8 corners and no more", count(FeatureLines::CORNER), 8);
  c.Equal("a cube's edges are found", count(FeatureLines::EDGE), 12 * ((1 << level) - 1));
}

void CheckPasses(Checks& c)
{
  // Where all triangles are long, what is left of most displacements makes the mesh uneven.
  const TestMesh sphere = UvSphere(20, 50);
  double loss = 0;
  double previous = MeasureQuality(sphere.V, sphere.T).mean;
  for (int passes = 1; passes <= 5; ++passes)
  {
    OptimizerOptions options = WithinDeviation(0.02);
    options.deviation.passes = passes;
    options.deviation.improveWorstTriangles = false;
    ProgressMonitor monitor;
    const double mean = Optimize(sphere.V, sphere.T, options, {}, monitor).comparison.after.mean;
    loss = Larger(loss, previous - mean);
    previous = mean;
  }
  c.Error("no pass lowers the mean radius ratio", loss, RoundOff);
}

/// Gain in the mean radius ratio of a UV sphere, whose vertices have a long way to go.
double GainOfUvSphere(double deviation)
{
  const TestMesh sphere = UvSphere(12, 30);
  OptimizerOptions options = WithinDeviation(deviation);
  options.deviation.passes = 30;
  options.deviation.improveWorstTriangles = false;
  ProgressMonitor monitor;
  const SurfaceComparison comparison =
    Optimize(sphere.V, sphere.T, options, {}, monitor).comparison;
  return comparison.after.mean - comparison.before->mean;
}

/// Vertices that slide on a curved surface leave it, always to the same side; where they return to
/// the middle of the distance, they can go on.
void CheckCentring(Checks& c)
{
  c.AtLeast("a narrow distance leaves half of the gain that a wide one allows",
    GainOfUvSphere(0.004), 0.5 * GainOfUvSphere(0.05));
}

void CheckCurves(Checks& c)
{
  const TestMesh half = Irregular(HalfSphere(3), 0.02);
  OptimizerOptions options = WithinDeviation(0.02);
  options.boundaryCondition = BoundaryCondition::SLIDING;
  ProgressMonitor monitor;
  const Points moved = Optimize(half.V, half.T, options, {}, monitor).positions;
  double off = 0, farthest = 0;
  for (const Edge& edge : BoundaryEdges(half))
  {
    const Vector3 x = moved.row(edge.first);
    off = Larger(off, DistanceToBoundary(x, half));
    farthest = Larger(farthest, (x - half.V.row(edge.first)).norm());
  }
  c.Error("vertices that slide along a curved boundary stay on it", off, 1e-15);
  c.Greater("they slide", farthest, 0.001);
}

void CheckWorstTriangles(Checks& c)
{
  constexpr int size = Thinning > 1 ? 40 : 80;
  const TestMesh sphere = UvSphere(size, size); // has thousands of triangles below the goals
  OptimizerOptions options = WithinDeviation(0.01);
  ProgressMonitor monitor;
  const double raised = Optimize(sphere.V, sphere.T, options, {}, monitor).comparison.after.mean;
  options.deviation.improveWorstTriangles = false;
  const double mean = Optimize(sphere.V, sphere.T, options, {}, monitor).comparison.after.mean;
  c.Error("raising the worst triangles lowers the mean by .002 at most", mean - raised, 0.002);

  const TestMesh coarse = UvSphere(20, 50);
  const double without =
    Optimize(coarse.V, coarse.T, options, {}, monitor).comparison.after.minimum;
  options.deviation.improveWorstTriangles = true;
  const double least = Optimize(coarse.V, coarse.T, options, {}, monitor).comparison.after.minimum;
  c.Error("raising the worst triangles raises the least radius ratio of a coarse UV sphere by .03",
    without + 0.03 - least, 0);
}

/// A sphere, one triangle of which is cut into three at its centre.
TestMesh SphereWithCutTriangle()
{
  TestMesh mesh = Icosphere(3);
  const auto size = static_cast<Index>(mesh.V.rows());
  const Eigen::RowVector3i cut = mesh.T.row(0);
  mesh.V.conservativeResize(size + 1, 3);
  mesh.V.row(size) = (mesh.V.row(cut[0]) + mesh.V.row(cut[1]) + mesh.V.row(cut[2])) / 3;
  mesh.T.row(0) << cut[0], cut[1], size;
  return WithTriangle(WithTriangle(mesh, cut[1], cut[2], size), cut[2], cut[0], size);
}

void CheckLifting(Checks& c)
{
  const double most = 8 * std::pow(std::sin(Pi / 12), 2) * std::sin(Pi / 3); // angles 30, 120, 30
  c.Error("three equal triangles in a plane have t = .46", most - 0.4641, 1e-4);
  const TestMesh mesh = SphereWithCutTriangle();
  c.Greater("three triangles around a vertex, which cannot reach .46 in their plane, are lifted",
    Run(mesh, WithinDeviation(0.02)).result.comparison.after.minimum, most + 0.03);

  OptimizerOptions options = WithinDeviation(0.02);
  options.freeAxes = { 1, 1, 0 };
  const TestMesh sphere = UvSphere(20, 50);
  const Outcome outcome = Run(sphere, options);
  c.Error("z does not change if x and y alone are free",
    LargestMagnitude(outcome.result.positions.col(2) - sphere.V.col(2)), 0);
  c.Greater("x and y do",
    LargestMagnitude(outcome.result.positions.leftCols(2) - sphere.V.leftCols(2)), 1e-3);
}

void CheckEndOfPasses(Checks& c)
{
  OptimizerOptions options = WithinDeviation(0.002);
  options.deviation.passes = 100;
  options.deviation.improveWorstTriangles = false;
  const TestMesh mesh = Irregular(Icosphere(2), 0.05);
  ProgressMonitor monitor;
  c.AtLeast("passes that gain nothing end the mode", 50,
    double(Optimize(mesh.V, mesh.T, options, {}, monitor).deviation.passes));
}

void CheckDistantVertices(Checks& c)
{
  const TestMesh grid = Grid(8, 0); // nine points in a row
  const MeshTopology topology = BuildTopology(static_cast<Index>(grid.V.rows()), grid.T);
  DistantVertices distant(grid.T, topology, 2);
  const auto add = [&](Index column, std::vector<Index> below = {})
  { return distant.Add(9 * 4 + column, [&](Index) { return below; }); };
  c.True("a first vertex is distant from all others", add(4, { 0 }));
  c.True("a neighbour is not", !add(5));
  c.True("nor is a vertex with a common neighbour", !add(6));
  c.True("nor is one on which a triangle of the reference depends as well", !add(7, { 1, 0 }));
  c.True("a vertex is that has neither in common", add(7, { 1 }));
  distant.Clear();
  c.True("none is near when all have been forgotten", add(5, { 0 }));
}

/// Long triangles over a plate, of which hardly one may move, take no more than a certain effort.
void CheckEffort(Checks& c)
{
  const TestMesh plate = PlateWithHoles(8, 6, 24, 0.9, 1);
  const MeshTopology topology = BuildTopology(static_cast<Index>(plate.V.rows()), plate.T);
  DisplacementConstraints constraints;
  constraints.freedom.assign(plate.V.rows(), DisplacementConstraints::IN_PLANE);
  ProgressMonitor monitor;
  DeviationGuard guard(plate.V, plate.T, topology, 0.05, monitor);
  ImproveWorstTriangles(
    guard, plate.T, topology, constraints, [](Index, const Vector3& position) { return position; },
    monitor);
  c.Greater("the worst triangles of a plate are tried", double(guard.GetEffort()), 10000);
  c.AtLeast("with some tens of thousands of proofs", 65000, double(guard.GetEffort()));
}

void CheckCancel(Checks& c)
{
  /// Asks to stop after some questions.
  struct Impatient : ProgressMonitor
  {
    int Patience;
    explicit Impatient(int patience)
      : Patience(patience)
    {
    }
    bool IsCancelled() override { return --this->Patience < 0; }
  };
  const TestMesh mesh = Irregular(Icosphere(1), 0.08);
  Index cancelled = 0;
  double excess = 0;
  for (int patience = 2; patience < 100; patience += 5)
  {
    Impatient monitor(patience);
    const Outcome outcome = Run(mesh, WithinDeviation(0.002), monitor);
    cancelled += outcome.result.isCancelled;
    excess =
      Larger(excess, outcome.relativeDistance - outcome.result.deviation.relativeBound - RoundOff);
  }
  c.Greater("a cancelled run says so", cancelled, 5);
  c.Error("a cancelled run stays within the bound reported", excess, 0);
}
}

int TestDeviation(int argc, char* argv[])
{
  Groups groups(argc, argv);
  groups.Run("Distances", CheckDistances);
  groups.Run("Refit", CheckRefit);
  groups.Run("Guarantee", CheckGuarantee);
  groups.Run("Steps", CheckSteps);
  groups.Run("Features", CheckFeatures);
  groups.Run("Passes", CheckPasses);
  groups.Run("Centring", CheckCentring);
  groups.Run("Curves", CheckCurves);
  groups.Run("EndOfPasses", CheckEndOfPasses);
  groups.Run("DistantVertices", CheckDistantVertices);
  groups.Run("WorstTriangles", CheckWorstTriangles);
  groups.Run("Lifting", CheckLifting);
  groups.Run("Effort", CheckEffort);
  groups.Run("Cancel", CheckCancel);
  return groups.Result();
}
