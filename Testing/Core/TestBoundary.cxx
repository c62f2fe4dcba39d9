// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "MeshMeasures.h"
#include "OperatorFixtures.h"

#include "Core/Mesh/TriangleGeometry.h"
#include "Core/Operators/CotangentQuantities.h"
#include "Core/Optimizer/ChosenWeights.h"
#include "Core/Optimizer/ProblemSetup.h"

#include <cmath>

using namespace lmo;

namespace
{
/// The vertices of the boundary that have a neighbour off the boundary.
std::vector<Index> BoundaryWithNeighbours(const TestMesh& mesh)
{
  const std::vector<bool> isBoundary = BoundaryVertices(mesh);
  const auto neighbours = Neighbours(mesh);
  std::vector<Index> found;
  for (Index i = 0; i < mesh.V.rows(); ++i)
  {
    const bool hasInner = std::any_of(
      neighbours[i].begin(), neighbours[i].end(), [&](Index j) { return !isBoundary[j]; });
    if (isBoundary[i] && hasInner)
    {
      found.push_back(i);
    }
  }
  return found;
}

/// Largest relative difference of kappa at the boundary from its value on the surface.
double CurvatureError(const TestMesh& mesh, double expected, bool isRobust)
{
  const MeshQuantities quantities(mesh.V, mesh.T);
  const Vector values =
    CotangentQuantities(quantities, isRobust).GetMeanCurvatures()(BoundaryWithNeighbours(mesh));
  return LargestMagnitude(values.array() / expected - 1);
}

/// Largest distance of the vertex normals at the boundary from those of the surface.
double NormalError(const TestMesh& mesh, const Points& expected)
{
  const Points normals = VertexNormals(mesh.V, mesh.T, *OperatorFixtures(mesh).topology);
  const std::vector<Index> boundary = BoundaryWithNeighbours(mesh);
  return MaximumDistance(
    normals(boundary, Eigen::indexing::all), expected(boundary, Eigen::indexing::all));
}

/// Largest distance of kappa n at the boundary from that of the surface, relative to kappa.
double CurvatureNormalError(const TestMesh& mesh, const Points& expected)
{
  const MeshQuantities quantities(mesh.V, mesh.T);
  const Points normals = CotangentQuantities(quantities, false).ComputeMeanCurvatureNormals();
  const std::vector<Index> boundary = BoundaryWithNeighbours(mesh);
  return MaximumDistance(
           normals(boundary, Eigen::indexing::all), expected(boundary, Eigen::indexing::all)) /
         expected.row(0).norm();
}

/// Outward normals of a cylinder around the z axis.
Points CylinderNormals(const TestMesh& cylinder)
{
  Points normals = cylinder.V;
  normals.col(2).setZero();
  return normals.rowwise().normalized();
}

void CheckHalfSphere(Checks& c)
{
  for (const int level : { 3, 4, 5 })
  {
    const std::string name = " at the rim of a half sphere of level " + std::to_string(level);
    const TestMesh mesh = HalfSphere(level);
    c.Error("kappa is 1 / R" + name, CurvatureError(mesh, 1, false), 0.01);
    c.Error("robust kappa is 1 / R" + name, CurvatureError(mesh, 1, true), 0.01);
    const double edge = std::acos(0.0) / (1 << level);
    c.Error("normals are radial to an edge length" + name, NormalError(mesh, mesh.V), edge);
    c.Error("kappa n is radial to an edge length" + name, CurvatureNormalError(mesh, -mesh.V),
      1.5 * edge);
  }
}

void CheckCylinder(Checks& c)
{
  const double radius = 2;
  const TestMesh mesh = CylinderPatch(radius);
  const Points normals = CylinderNormals(mesh);
  c.Error("kappa is 1 / 2R at the rim of a cylinder patch",
    CurvatureError(mesh, 1 / (2 * radius), false), 1e-12);
  c.Error("robust kappa is 1 / 2R at the rim of a cylinder patch",
    CurvatureError(mesh, 1 / (2 * radius), true), 1e-3);
  c.Error(
    "normals of a cylinder patch are radial to an edge length", NormalError(mesh, normals), 0.1);
  c.Error("kappa n of a cylinder patch is radial to an edge length",
    CurvatureNormalError(mesh, -normals / (2 * radius)), 0.1);
}

/// All vertices have one curvature but two corners, whose neighbours are all at the rim: they are
/// flat. A rim with curvatures of its own would show in all weights.
void CheckWeights(Checks& c)
{
  const TestMesh mesh = CylinderPatch(2);
  const MeshQuantities quantities(mesh.V, mesh.T);
  const CotangentQuantities analysis(quantities, false);
  Vector expected = Vector::Ones(169);
  expected[12] = expected[156] = 0;
  OptimizerOptions options;
  options.mode = Mode::OPTIMIZE_TRIANGLES;
  options.positionWeighting = PositionWeighting::LINEAR;
  // kappa is the same to round-off; where it is least among equals does not matter.
  const Vector linear = PositionWeights(analysis, options, {});
  c.Error("linear weights do not see the rim", LargestMagnitude(linear - expected), 1e-9);
  expected[12] = expected[156] = 2.0 / 169;
  options.positionWeighting = PositionWeighting::CDF;
  const Vector cumulative = PositionWeights(analysis, options, {});
  c.Error("the flat corners have the least cumulative weight",
    std::abs(cumulative[12] - expected[12]) + std::abs(cumulative[156] - expected[156]), 1e-15);
}

/// A flat boundary: L_c V of an inner vertex next to it is 0, and that of a boundary vertex lies in
/// the plane.
void CheckFlatBorder(Checks& c)
{
  const TestMesh grid = Grid(6, 0.2);
  for (const bool isRobust : { false, true })
  {
    const MeshQuantities quantities(grid.V, grid.T);
    const CotangentQuantities analysis(quantities, isRobust);
    c.Error("L_c V of a flat sheet is in its plane, also at the boundary",
      LargestMagnitude(Apply(analysis.MakeLaplacian(LaplacianType::COTANGENT), grid.V).col(2)), 0);
    c.Error("a flat sheet has no curvature, also at the boundary",
      LargestMagnitude(analysis.ComputeMeanCurvatureNormals().col(2)), 0);
  }
}
}

int TestBoundary(int argc, char* argv[])
{
  Groups groups(argc, argv);
  groups.Run("HalfSphere", CheckHalfSphere);
  groups.Run("Cylinder", CheckCylinder);
  groups.Run("Weights", CheckWeights);
  groups.Run("FlatBorder", CheckFlatBorder);
  return groups.Result();
}
