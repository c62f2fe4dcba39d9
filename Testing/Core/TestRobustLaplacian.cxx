// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "MeshMeasures.h"
#include "OperatorFixtures.h"

#include "Core/Operators/CotangentQuantities.h"
#include "Core/Operators/IntrinsicTriangulation.h"
#include "Core/Operators/RobustLaplacian.h"

#include <algorithm>
#include <cmath>

using namespace lmo;

namespace
{
/// L_c and L_ck of the robust weights.
struct RobustOperators
{
  explicit RobustOperators(const TestMesh& mesh)
  {
    const CotangentParts weights = ComputeRobustWeights(mesh.V, mesh.T);
    this->areas = weights.voronoiAreas;
    this->cotangent = CotangentLaplacian(weights.rings, weights.edgeWeights);
    this->meanCurvature = MeanCurvatureLaplacian(weights.rings, weights.edgeWeights, this->areas);
  }

  Vector areas;
  Laplacian cotangent;
  Laplacian meanCurvature;
};

/// Two triangles over the edge from (0, 0) to (4, 0) with the tips (2, height), (2, -height).
TestMesh Kite(double height)
{
  TestMesh mesh{ Points(4, 3), Triangles(2, 3) };
  mesh.V << 0, 0, 0, 4, 0, 0, 2, height, 0, 2, -height, 0;
  mesh.T << 0, 1, 2, 1, 0, 3;
  return mesh;
}

TestMesh Moebius()
{
  TestMesh mesh{ Irregular(Icosphere(0), 0.1).V.topRows(5), Triangles(5, 3) };
  mesh.T << 0, 1, 2, 1, 3, 2, 2, 3, 4, 3, 0, 4, 4, 0, 1;
  return mesh;
}

/// A flat grid of obtuse triangles, 30 x 30 cells.
TestMesh Slivers()
{
  TestMesh mesh = Grid(30, 0.2);
  mesh.V.col(0) *= 6;
  return mesh;
}

TestMesh Triangle(double x, double y)
{
  TestMesh mesh{ Points(3, 3), Triangles(1, 3) };
  mesh.V << 0, 0, 0, 1, 0, 0, x, y, 0;
  mesh.T << 0, 1, 2;
  return mesh;
}

std::vector<std::pair<std::string, TestMesh>> DifficultMeshes()
{
  auto meshes = AllTestMeshes();
  meshes.insert(meshes.end(),
    { { "kite of obtuse triangles", Kite(0.1) }, { "Moebius strip", Moebius() },
      { "slivers", Slivers() },
      { "thin triangles", WithThinTriangles(Irregular(Icosphere(2), 0.05)) },
      { "fin", WithTriangle(Cube(), 0, 1, 7) },
      { "repeated triangle", WithTriangle(Cube(), 0, 2, 1) },
      { "repeated vertex", WithTriangle(Cube(), 0, 0, 1) },
      { "triangle without area", Triangle(2, 0) }, { "one point", Transformed(Cube(), 0) },
      { "nothing", { Points(0, 3), Triangles(0, 3) } } });
  return meshes;
}

/// Difference between two matrices relative to the entries of the second.
double MatrixError(const Laplacian& L, const Laplacian& expected)
{
  const Eigen::MatrixXd matrix = DenseMatrix(expected);
  return LargestMagnitude(DenseMatrix(L) - matrix) / LargestMagnitude(matrix);
}

/// Difference from the operators of Eqns. 4 and 7.
double PlainError(const TestMesh& mesh)
{
  const OperatorFixtures plain(mesh);
  const RobustOperators robust(mesh);
  return Larger(MatrixError(robust.cotangent, plain.cotangent),
    MatrixError(robust.meanCurvature, plain.meanCurvature));
}

double LeastWeight(const Laplacian& L)
{
  return L.edgeWeights->size() > 0 ? L.edgeWeights->minCoeff() : 0;
}

/// Largest |L x| of the coordinates x, at vertices ten cells from the boundary and more: flips go
/// around the boundary to the back of the surface, where x is mirrored.
double DeepLaplacian(const TestMesh& grid, const Laplacian& L)
{
  const Points Lx = Apply(L, grid.V);
  double largest = 0;
  for (int row = 10; row <= 20; ++row)
  {
    largest = Larger(largest, LargestMagnitude(Lx.middleRows(31 * row + 10, 11)));
  }
  return largest;
}

/// True if each side is the twin of its twin, leads back and is as long.
bool IsGlued(const IntrinsicTriangulation& surface)
{
  bool isGlued = true;
  for (Index side = 0; side < surface.Size(); ++side)
  {
    const Index twin = surface.twins[side];
    const Index next = side % 3 == 2 ? side - 2 : side + 1;
    isGlued = isGlued && twin != side && surface.twins[twin] == side &&
              surface.tails[twin] == surface.tails[next] &&
              surface.lengths[twin] == surface.lengths[side];
  }
  return isGlued;
}

double LeastCotangentSum(const IntrinsicTriangulation& surface)
{
  double least = 0;
  for (Index side = 0; side < surface.Size(); ++side)
  {
    least = std::min(least, surface.CotangentSum(side));
  }
  return least;
}

/// Least of a + b - c over the sides of the triangles.
double LeastDetour(const IntrinsicTriangulation& surface)
{
  double least = HUGE_VAL;
  for (Index t = 0; t < surface.Size() / 3; ++t)
  {
    const double* sides = surface.lengths.data() + 3 * t;
    least =
      std::min(least, sides[0] + sides[1] + sides[2] - 2 * *std::max_element(sides, sides + 3));
  }
  return least;
}

void CheckMesh(Checks& c, const std::string& name, const TestMesh& mesh)
{
  const RobustOperators robust(mesh);
  c.AtLeast("no weight is negative: " + name, LeastWeight(robust.cotangent), 0);
  c.True("weights and areas are finite: " + name,
    robust.cotangent.edgeWeights->allFinite() && robust.areas.allFinite());
  const Eigen::MatrixXd K = StiffnessMatrix(robust.cotangent);
  c.Error("weights are symmetric: " + name, LargestMagnitude(K - K.transpose()), 0);
  if (SurfaceArea(mesh) > 0)
  {
    c.Error("the areas sum up to that of the surface: " + name,
      std::abs(robust.areas.sum() / SurfaceArea(mesh) - 1), 1e-3);
  }
}

void CheckGluing(Checks& c)
{
  for (const auto& [name, mesh] : DifficultMeshes())
  {
    IntrinsicTriangulation surface = TuftedCover(mesh.V, mesh.T);
    c.True("each side of the cover has one twin: " + name, IsGlued(surface));
    Mollify(surface);
    FlipToDelaunay(surface);
    c.True("and after the flips: " + name, IsGlued(surface));
    c.AtLeast("no edge is left to flip: " + name, LeastCotangentSum(surface), -1e-9);
  }
}

void CheckMollification(Checks& c)
{
  IntrinsicTriangulation surface = TuftedCover(Kite(3).V, Kite(3).T);
  const std::vector<double> lengths = surface.lengths;
  Mollify(surface);
  c.Equal("good triangles are not mollified", surface.lengths, lengths);
  for (const TestMesh& mesh : { Triangle(0.5, 0), Triangle(0.5, 1e-9), Kite(1e-9) })
  {
    surface = TuftedCover(mesh.V, mesh.T);
    Mollify(surface);
    c.Error(
      "a flat triangle gets the detour of 1e-5", std::abs(LeastDetour(surface) / 1e-5 - 1), 1e-9);
  }
}

void CheckFlips(Checks& c)
{
  IntrinsicTriangulation acute = TuftedCover(Kite(3).V, Kite(3).T);
  c.Equal("a Delaunay kite is not flipped", FlipToDelaunay(acute), 0);
  const double height = 0.5;
  IntrinsicTriangulation obtuse = TuftedCover(Kite(height).V, Kite(height).T);
  c.AtLeast("the two copies of an obtuse kite are", FlipToDelaunay(obtuse), 2);
  const RobustOperators robust(Kite(height));
  // The short diagonal faces two angles with the cotangent (4 - height^2) / 4 height.
  const double expected = (4 - height * height) / (2 * height);
  c.Error("the short diagonal has its cotangents",
    std::abs(-StiffnessMatrix(robust.cotangent)(2, 3) / expected - 1), 1e-14);
  c.Error("the long one has no weight", std::abs(StiffnessMatrix(robust.cotangent)(0, 1)), 0);
}

void CheckKnownOperators(Checks& c)
{
  c.Error("L_c V of a flat ring is 0",
    Apply(RobustOperators(CrossRing()).cotangent, CrossRing().V).row(0).norm(), 1e-15);
  for (const auto& [name, mesh] :
    std::vector<std::pair<std::string, TestMesh>>{ { "cross", CrossRing() },
      { "equilateral triangle", EquilateralTriangle() }, { "grid", Grid(6, 0) }, { "cube", Cube() },
      { "sphere", Icosphere(3) }, { "tetrahedron", Tetrahedron() }, { "acute kite", Kite(3) } })
  {
    c.Error(
      "Delaunay meshes have the operators of Eqns. 4 and 7: " + name, PlainError(mesh), 1e-12);
  }
  const TestMesh slivers = Slivers();
  c.Error(
    "L_c V of flat slivers is 0", DeepLaplacian(slivers, RobustOperators(slivers).cotangent), 1e-3);
  c.Less(
    "Eqn. 4 has negative weights there", LeastWeight(OperatorFixtures(slivers).cotangent), -0.5);
}

/// Each of three wings gives its own cotangents, as it does to Eqn. 4.
/// Four triangles at one edge, two of them obtuse.
TestMesh FourWings()
{
  TestMesh wings;
  wings.V.resize(6, 3);
  wings.V << 0, 0, 0, 1, 0, 0, 0.5, 0.2, 0, 0.5, 0, 0.9, 0.4, -0.25, 0, 0.5, 0, -0.8;
  wings.T.resize(4, 3);
  wings.T << 0, 1, 2, 0, 1, 3, 0, 1, 4, 0, 1, 5;
  return wings;
}

void CheckNonManifold(Checks& c)
{
  TestMesh fan = ThreeWings();
  c.Error("an edge of three acute triangles has the weights of Eqn. 4",
    LargestMagnitude(
      DenseMatrix(RobustOperators(fan).cotangent) - DenseMatrix(OperatorFixtures(fan).cotangent)),
    1e-14);
  TestMesh shuffled = fan;
  shuffled.T.row(0).swap(shuffled.T.row(2));
  shuffled.T.row(1).reverseInPlace();
  fan.V.row(4) << 0.2, 0.1, 0.4; // obtuse
  shuffled.V = fan.V;
  c.Error("neither order nor orientation of the triangles matters",
    LargestMagnitude(DenseMatrix(RobustOperators(fan).cotangent) -
                     DenseMatrix(RobustOperators(shuffled).cotangent)),
    1e-12);
  const TestMesh wings = FourWings();
  TestMesh crossed = wings;
  crossed.T.row(1).swap(crossed.T.row(2));
  c.Error("nor does the order of four triangles around an edge",
    LargestMagnitude(DenseMatrix(RobustOperators(wings).cotangent) -
                     DenseMatrix(RobustOperators(crossed).cotangent)),
    1e-12);
}

void CheckQuantities(Checks& c)
{
  const TestMesh mesh = Slivers();
  const MeshQuantities quantities(mesh.V, mesh.T);
  const auto leastWeight = [&](bool isRobust)
  {
    const CotangentQuantities cotangents(quantities, isRobust);
    return LeastWeight(cotangents.MakeLaplacian(LaplacianType::COTANGENT));
  };
  c.AtLeast("the quantities have the robust weights", leastWeight(true), 0);
  c.Less("and otherwise those of Eqn. 4", leastWeight(false), 0);
}

/// The optimizer takes the operator when it is told to, and leaves it again.
void CheckChange(Checks& c)
{
  const TestMesh mesh = Slivers();
  Optimizer optimizer(mesh.V, mesh.T);
  ProgressMonitor monitor;
  const auto curvatures = [&](bool isRobust)
  {
    OptimizerOptions options = Options(Mode::SMOOTH, LaplacianType::COTANGENT);
    options.robustLaplacian = isRobust;
    return optimizer.Run(options, {}, monitor).meanCurvatures;
  };
  const Vector plain = curvatures(false);
  c.Different("robust weights give other curvatures", curvatures(true), plain);
  c.Equal(
    "a change to robust weights and back gives the same curvatures", curvatures(false), plain);
}

void CheckAllMeshes(Checks& c)
{
  for (const auto& [name, mesh] : DifficultMeshes())
  {
    CheckMesh(c, name, mesh);
  }
}
}

int TestRobustLaplacian(int argc, char* argv[])
{
  Groups groups(argc, argv);
  groups.Run("AllMeshes", CheckAllMeshes);
  groups.Run("Gluing", CheckGluing);
  groups.Run("Mollification", CheckMollification);
  groups.Run("Flips", CheckFlips);
  groups.Run("KnownOperators", CheckKnownOperators);
  groups.Run("NonManifold", CheckNonManifold);
  groups.Run("Quantities", CheckQuantities);
  groups.Run("Change", CheckChange);
  return groups.Result();
}
