// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "MeshMeasures.h"
#include "OperatorFixtures.h"

#include "Core/Mesh/TriangleGeometry.h"
#include "Core/Operators/Curvature.h"

#include <cmath>

using namespace lmo;

namespace
{
/// All curvatures of a mesh.
struct Curvatures
{
  Points normals; ///< kappa n
  Vector mean;    ///< kappa
  Vector signedMean;
  Vector gaussian; ///< K
  Points planeNormals;
};

Curvatures Measure(const TestMesh& mesh)
{
  const OperatorFixtures operators(mesh);
  const MeshTopology& topology = *operators.topology;
  Curvatures result;
  result.normals = MeanCurvatureNormals(operators.meanCurvature, mesh.V, topology);
  result.mean = MeanCurvatures(result.normals, BoundingBoxDiagonal(mesh.V, topology), topology);
  const Points vertexNormals = VertexNormals(mesh.V, mesh.T, topology);
  result.signedMean = SignedMeanCurvatures(result.normals, result.mean, vertexNormals, topology);
  result.gaussian =
    GaussianCurvatures(AngleDefects(mesh.V, mesh.T, topology), operators.voronoiAreas, topology);
  result.planeNormals = TangentPlaneNormals(result.normals, result.mean, vertexNormals, topology);
  return result;
}

/// Largest relative difference of the values from \a expected.
double RelativeError(const Vector& values, double expected)
{
  return LargestMagnitude(values.array() / expected - 1);
}

/// The values at the vertices off the boundary.
Vector AtInnerVertices(const TestMesh& mesh, const Vector& values)
{
  const std::vector<bool> isBoundary = BoundaryVertices(mesh);
  std::vector<Index> inner;
  for (Index i = 0; i < values.size(); ++i)
  {
    if (!isBoundary[i])
    {
      inner.push_back(i);
    }
  }
  return values(inner);
}

/// Difference of each boundary value from the mean over the inner neighbours.
template <typename Values>
double BoundaryRuleError(const TestMesh& mesh, const Values& values)
{
  const std::vector<bool> isBoundary = BoundaryVertices(mesh);
  const auto neighbours = Neighbours(mesh);
  double error = 0;
  for (std::size_t i = 0; i < neighbours.size(); ++i)
  {
    std::vector<Index> inner;
    std::copy_if(neighbours[i].begin(), neighbours[i].end(), std::back_inserter(inner),
      [&](Index j) { return !isBoundary[j]; });
    if (isBoundary[i])
    {
      const double count = std::max<double>(inner.size(), 1);
      const auto mean = (values(inner, Eigen::indexing::all).colwise().sum() / count).eval();
      error = Larger(error, (values.row(i) - mean).norm());
    }
  }
  return error;
}

void CheckSpheres(Checks& c)
{
  for (const double radius : { 1e-3, 1.0, 1e3 })
  {
    for (const int level : { 3, 4, 5 })
    {
      const std::string sphere =
        ": radius " + std::to_string(radius) + ", level " + std::to_string(level);
      const TestMesh mesh = Icosphere(level, radius);
      const Curvatures curvatures = Measure(mesh);
      const Points inward = -mesh.V / (radius * radius);
      c.Error(
        "kappa of a sphere is 1 / R" + sphere, RelativeError(curvatures.mean, 1 / radius), 0.02);
      c.Error("a sphere is convex" + sphere,
        LargestMagnitude(curvatures.signedMean - curvatures.mean), 0);
      c.Error("kappa n of a sphere points inward" + sphere,
        MaximumDistance(curvatures.normals, inward) * radius, 0.02);
      c.Error("Gaussian curvature of a sphere is 1 / R^2" + sphere,
        RelativeError(curvatures.gaussian, 1 / (radius * radius)), 0.02);
      c.Error("the tangent planes of a sphere face its centre" + sphere,
        MaximumDistance(curvatures.planeNormals, inward * radius), 0.02);
    }
  }
}

void CheckFlatAndCylinder(Checks& c)
{
  const Curvatures plane = Measure(Grid(10, 0.3));
  c.Error("kappa of a plane is 0", LargestMagnitude(plane.mean), 0);
  c.Error("the tangent plane of a plane is its own",
    MaximumDistance(plane.planeNormals, Vector3(0, 0, 1).replicate(121, 1)), 1e-15);
  TestMesh hollow = Icosphere(3);
  hollow.T.col(0).swap(hollow.T.col(1));
  const Curvatures concave = Measure(hollow);
  c.Error("a hollow is concave", LargestMagnitude(concave.signedMean + concave.mean), 0);
  const double radius = 2;
  const Curvatures cylinder = Measure(CylinderPatch(radius));
  c.Error("kappa of a cylinder is 1 / 2R",
    RelativeError(AtInnerVertices(CylinderPatch(radius), cylinder.mean), 1 / (2 * radius)), 1e-12);
  c.Error("Gaussian curvature of a cylinder is 0", LargestMagnitude(cylinder.gaussian), 1e-11);
}

void CheckHandDerivedValues(Checks& c)
{
  // Each corner of the cube: sum of cotangents 2 to each of three neighbours, area 3/4.
  const Curvatures cube = Measure(WithIsolatedPoint(Cube()));
  c.Error("kappa n of the cube's corner is (2/3, 2/3, 2/3)",
    (cube.normals.row(1) - Vector3::Constant(2.0 / 3)).norm(), 1e-15);
  c.Error(
    "kappa of the cube's corner is 2 / sqrt 3", std::abs(cube.mean[1] - 2 / std::sqrt(3)), 1e-15);
  c.Error("Gaussian curvature of the cube's corner is 2/3 pi",
    std::abs(cube.gaussian[1] - std::acos(-1.0) * 2 / 3), 1e-14);
  c.Error("an isolated point has no curvature",
    cube.normals.row(0).norm() + std::abs(cube.mean[0]) + std::abs(cube.gaussian[0]), 0);
}

void CheckThreshold(Checks& c)
{
  const double diagonal = 4;
  Points normals = Points::Zero(4, 3);
  normals.col(0) << 0.99e-6, 1.01e-6, 1, 0;
  normals /= diagonal;
  const Vector expected(Eigen::Vector4d(0, 1.01e-6, 1, 0) / diagonal);
  const MeshTopology topology = *OperatorFixtures(Tetrahedron()).topology;
  c.Error("kappa below 1e-6 / diagonal is 0",
    LargestMagnitude(MeanCurvatures(normals, diagonal, topology) - expected), 0);
}

void CheckBoundaryRule(Checks& c)
{
  const TestMesh mesh = Irregular(HalfSphere(3), 0.02);
  const Curvatures curvatures = Measure(mesh);
  c.Error("kappa n at the boundary is the mean over inner neighbours",
    BoundaryRuleError(mesh, curvatures.normals), 1e-14);
  c.Error("kappa at the boundary is the mean over inner neighbours",
    BoundaryRuleError(mesh, curvatures.mean), 1e-14);
  TestMesh waves = Grid(12, 0.3);
  waves.V.col(2) = waves.V.col(0).array().sin();
  c.Error("signed mean curvature at the boundary is the mean over inner neighbours",
    BoundaryRuleError(waves, Measure(waves).signedMean), 1e-14);
  c.Error("Gaussian curvature at the boundary is the mean over inner neighbours",
    BoundaryRuleError(mesh, curvatures.gaussian), 1e-14);
  c.Error(
    "a triangle alone has no curvature", LargestMagnitude(Measure(EquilateralTriangle()).mean), 0);
  const Points vertexNormals = VertexNormals(mesh.V, mesh.T, *OperatorFixtures(mesh).topology);
  c.Error("the tangent plane at the boundary is that of the triangles",
    (curvatures.planeNormals.row(0) - vertexNormals.row(0)).norm(), 0);
}
}

int TestCurvature(int argc, char* argv[])
{
  Groups groups(argc, argv);
  groups.Run("Spheres", CheckSpheres);
  groups.Run("FlatAndCylinder", CheckFlatAndCylinder);
  groups.Run("HandDerivedValues", CheckHandDerivedValues);
  groups.Run("Threshold", CheckThreshold);
  groups.Run("BoundaryRule", CheckBoundaryRule);
  return groups.Result();
}
