// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause

// A mesh that is optimized within a deviation of another surface. Distances are measured at a grid
// of points over each triangle, to each triangle.
#include "Checks.h"
#include "CurvedSurfaces.h"
#include "MeshFixtures.h"
#include "MeshMeasures.h"

#include "Core/Deviation/ReferenceSurface.h"
#include "Core/Mesh/TriangleNeighbours.h"
#include "Core/Optimizer/Optimizer.h"

#include <algorithm>

using namespace lmo;

namespace
{
constexpr double RoundOff = 1e-12;
constexpr double Deviation = 0.02; ///< a length

std::shared_ptr<const MeshQuantities> AsReference(const TestMesh& mesh)
{
  return std::make_shared<MeshQuantities>(mesh.V, mesh.T);
}

OptimizerResult Run(const TestMesh& mesh, std::shared_ptr<const MeshQuantities> reference,
  double deviation, int passes = OptimizerOptions().deviation.passes)
{
  OptimizerOptions options;
  options.deviation.passes = passes;
  options.deviation.maximum = deviation;
  options.deviation.isAbsolute = true;
  VertexArrays arrays;
  arrays.reference = std::move(reference);
  ProgressMonitor monitor;
  return Optimize(mesh.V, mesh.T, options, arrays, monitor);
}

double LargestDistanceBothWays(const TestMesh& a, const TestMesh& b)
{
  return Larger(LargestDistance(a, b), LargestDistance(b, a));
}

/// A torus with thin triangles, and another tessellation of it that is near it.
const TestMesh& Input()
{
  static const TestMesh mesh =
    WithThinTriangles(Thinning > 1 ? Torus(12, 7, 0.2) : Torus(16, 8, 0.2), 4, 0.7);
  return mesh;
}

const TestMesh& Reference()
{
  static const TestMesh mesh = Thinning > 1 ? Torus(17, 9, 0.3) : Torus(23, 11, 0.3);
  return mesh;
}

void CheckOtherSurface(Checks& c)
{
  const double before = LargestDistanceBothWays(Input(), Reference());
  const double allowed = 1.2 * before;
  const OptimizerResult result = Run(Input(), AsReference(Reference()), allowed);
  const double after = LargestDistanceBothWays({ result.positions, Input().T }, Reference());
  c.Equal("no triangle begins beyond the distance", result.deviation.beyond, 0);
  c.Greater("the triangles get better", result.comparison.after.mean,
    result.comparison.before->mean + 0.05);
  c.AtMost("the surfaces stay within the distance allowed", after, allowed);
  c.AtMost("they stay within the bound", after, result.deviation.bound + RoundOff);
  c.AtMost("the bound is no more than the distance allowed", result.deviation.bound, allowed);
  c.Equal("no triangle flips", result.comparison.flippedTriangles, 0);
}

void CheckItself(Checks& c)
{
  const OptimizerResult with = Run(Input(), AsReference(Input()), Deviation);
  const OptimizerResult without = Run(Input(), nullptr, Deviation);
  c.Error("a copy of the input as the reference is no reference at all",
    MaximumDistance(with.positions, without.positions), RoundOff);
}

/// Distance to the first mesh after six runs, each on the result of the last.
double DistanceAfterRuns(const std::shared_ptr<const MeshQuantities>& reference)
{
  TestMesh mesh = Input();
  for (int run = 0; run < 6; ++run)
  {
    mesh.V = Run(mesh, reference, Deviation).positions;
  }
  return LargestDistanceBothWays(mesh, Input());
}

void CheckRepeated(Checks& c)
{
  c.AtMost("six runs with a reference stay within its distance",
    DistanceAfterRuns(AsReference(Input())), Deviation);
  c.Greater("six runs without it do not", DistanceAfterRuns(nullptr), Deviation);
}

void CheckSecondRun(Checks& c)
{
  double largest = 0;
  for (const int thinning : { 1, 4, 6 })
  {
    const TestMesh mesh = WithThinTriangles(Torus(24, 10, 0.2), thinning, 0.7);
    const OptimizerResult first = Run(mesh, nullptr, Deviation);
    const OptimizerResult second = Run({ first.positions, mesh.T }, AsReference(mesh), Deviation);
    largest = Larger(largest, std::abs(second.comparison.after.mean - first.comparison.after.mean));
  }
  c.Error(
    "the mode changes its own results by less than 1e-3 of the mean radius ratio", largest, 1e-3);
}

void CheckContinued(Checks& c)
{
  const TestMesh mesh = WithThinTriangles(Torus(24, 10, 0.2), 4, 0.7);
  const OptimizerResult once = Run(mesh, nullptr, Deviation, 1);
  const OptimizerResult again = Run({ once.positions, mesh.T }, AsReference(mesh), Deviation);
  c.Greater("what one pass alone has left to gain is gained by the next run",
    again.comparison.after.mean, once.comparison.after.mean + 0.01);
}

/// The cube's points on the sphere around it: no edge is sharp, but for those of the reference.
void CheckFeatures(Checks& c)
{
  const TestMesh cube = Cube(2);
  TestMesh round = cube;
  for (Eigen::Index i = 0; i < round.V.rows(); ++i)
  {
    round.V.row(i) = (cube.V.row(i) - cube.V.colwise().mean()).normalized();
  }
  OptimizerOptions options;
  options.detectFeatures = true;
  VertexArrays arrays;
  arrays.reference = AsReference(cube);
  ProgressMonitor monitor;
  const auto corners = [&]
  {
    const OptimizerResult result = Optimize(round.V, round.T, options, arrays, monitor);
    return (result.featureClass->array() == FeatureLines::CORNER).count();
  };
  c.Equal("an earlier result has the features of its reference", corners(), 8);
  arrays.reference = nullptr;
  c.Equal("without it, it has its own", corners(), 0);
}

void CheckBeyond(Checks& c)
{
  const TestMesh mesh = Transformed(Input(), 1.02);
  const OptimizerResult result = Run(mesh, AsReference(Reference()), Deviation);
  double excess = 0;
  Index beyond = 0;
  for (Eigen::Index i = 0; i < mesh.V.rows(); ++i)
  {
    const double before = DistanceToSurface(mesh.V.row(i), Reference());
    const double after = DistanceToSurface(result.positions.row(i), Reference());
    beyond += before > Deviation;
    excess = Larger(excess, after - std::max(before, Deviation));
  }
  c.Greater("the input has points beyond the distance", beyond, 10);
  c.Greater("triangles that begin beyond the distance are counted", result.deviation.beyond, 10);
  c.Error("points that begin beyond the distance do not go farther", excess, RoundOff);
  const double before = LargestDistanceBothWays(mesh, Reference());
  const double after = LargestDistanceBothWays({ result.positions, mesh.T }, Reference());
  c.AtMost("nor do the surfaces", after, 1.002 * before);
  c.AtMost("the bound counts them", after, result.deviation.bound + RoundOff);
  c.Greater("the triangles get better all the same", result.comparison.after.mean,
    result.comparison.before->mean + 0.01);
}

/// A mesh at a height above a plane, whose triangles lie elsewhere.
struct AbovePlane
{
  static constexpr double Height = 0.3;
  const TestMesh mesh = Transformed(Grid(4, 0.2), 1, { 0, 0, Height });
  const TestMesh plane = Transformed(Grid(3, 0), 2, { 0, 0, 0 });
  const MeshTopology topology = BuildTopology(static_cast<Index>(mesh.V.rows()), mesh.T);
  const MeshTopology planeTopology = BuildTopology(static_cast<Index>(plane.V.rows()), plane.T);
  const Triangles neighbours = FindTriangleNeighbours(mesh.T, topology);
  const Triangles planeNeighbours = FindTriangleNeighbours(plane.T, planeTopology);
  ProgressMonitor monitor;
  TriangleBvh tree{ plane.V, plane.T, monitor };
};

void CheckVertexLimits(Checks& c)
{
  AbovePlane above;
  const auto isExceeded = [&](double distance, double height)
  {
    const VertexLimits limits(above.mesh.V, above.tree, distance, above.monitor);
    return limits.IsExceeded(0, { above.mesh.V(0, 0), above.mesh.V(0, 1), height }, above.tree);
  };
  constexpr double height = AbovePlane::Height;
  c.True("what begins beyond the distance may come nearer", !isExceeded(0.1, 0.999 * height));
  c.True("but not go farther", isExceeded(0.1, 1.001 * height));
  c.True("what begins within the distance may use it", !isExceeded(0.5, 0.499));
  c.True("but no more", isExceeded(0.5, 0.501));
}

void CheckTriangleLimits(Checks& c)
{
  AbovePlane above;
  const SurfaceView mesh{ above.mesh.V, above.mesh.T, above.neighbours };
  const SurfaceView plane{ above.plane.V, above.plane.T, above.planeNeighbours };
  DeviationCertificates certificates(
    FindSeeds(mesh, above.tree, above.monitor), DeviationCertificates::BOUNDS);
  const DistanceLimits limits =
    CertifyInput(certificates, mesh, {}, plane, above.tree, 0.1, above.monitor);
  constexpr double height = AbovePlane::Height;
  for (Index t = 0; t < static_cast<Index>(above.mesh.T.rows()); ++t)
  {
    c.Greater(
      "the limit of a triangle is no smaller than its distance", limits(t), height - RoundOff);
    c.AtMost("and hardly larger", limits(t), 1.003 * height);
  }
}

void CheckFarAway(Checks& c)
{
  const TestMesh far = Transformed(Reference(), 1, { 50, 0, 0 });
  const OptimizerResult result = Run(Input(), AsReference(far), Deviation);
  c.Equal("all triangles may begin beyond the distance", result.deviation.beyond,
    Input().T.rows() + far.T.rows());
  c.AtMost("a reference far away keeps the surface from going farther",
    LargestDistanceBothWays({ result.positions, Input().T }, far),
    1.002 * LargestDistanceBothWays(Input(), far));
}
}

int TestReference(int argc, char* argv[])
{
  Groups groups(argc, argv);
  groups.Run("OtherSurface", CheckOtherSurface);
  groups.Run("Itself", CheckItself);
  groups.Run("Repeated", CheckRepeated);
  groups.Run("SecondRun", CheckSecondRun);
  groups.Run("Continued", CheckContinued);
  groups.Run("Features", CheckFeatures);
  groups.Run("Beyond", CheckBeyond);
  groups.Run("FarAway", CheckFarAway);
  groups.Run("VertexLimits", CheckVertexLimits);
  groups.Run("TriangleLimits", CheckTriangleLimits);
  return groups.Result();
}
