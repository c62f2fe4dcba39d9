// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "MeshMeasures.h"
#include "OperatorFixtures.h"

#include <cmath>

using namespace lmo;

namespace
{
TestMesh WithEqualPoints(TestMesh mesh, Index i, Index j)
{
  mesh.V.row(i) = mesh.V.row(j);
  return mesh;
}

/// Two triangles that share vertex 0 only.
TestMesh BowTie()
{
  TestMesh mesh = CrossRing();
  mesh.T = Triangles(mesh.T({ 0, 2 }, Eigen::indexing::all));
  return mesh;
}

/// A strip of five triangles joined with a half turn.
TestMesh Moebius()
{
  TestMesh mesh{ Irregular(Icosphere(0), 0.1).V.topRows(5), Triangles(5, 3) };
  mesh.T << 0, 1, 2, 1, 3, 2, 2, 3, 4, 3, 0, 4, 4, 0, 1;
  return mesh;
}

std::vector<std::pair<std::string, TestMesh>> DegenerateMeshes()
{
  TestMesh flipped = Icosphere(1);
  flipped.T.row(5).reverseInPlace();
  TestMesh collinear = EquilateralTriangle();
  collinear.V << 0, 0, 0, 1, 0, 0, 2, 0, 0;
  return { { "no points", { Points(0, 3), Triangles(0, 3) } },
    { "points only", { Points::Ones(3, 3), Triangles(0, 3) } },
    { "equal points", WithEqualPoints(Icosphere(1), 20, 0) },
    { "all points equal", Transformed(Icosphere(1), 0) }, { "collinear points", collinear },
    { "degenerate triangle", WithTriangle(Cube(), 0, 0, 1) },
    { "repeated triangle", WithTriangle(Cube(), 0, 2, 1) }, { "opposite orientation", flipped },
    { "fin", WithTriangle(Cube(), 0, 1, 7) }, { "bow tie", BowTie() },
    { "Moebius strip", Moebius() }, { "tiny", Transformed(Irregular(HalfSphere(2), 0.05), 1e-20) },
    { "huge", Transformed(Irregular(HalfSphere(2), 0.05), 1e20) } };
}

bool IsSolved(const TestMesh& mesh, const OptimizerOptions& options)
{
  const OptimizerResult result = Run(mesh, options);
  return result.positions.allFinite() && result.relativeResidual <= options.solver.tolerance;
}

void CheckMesh(Checks& c, const std::string& name, const TestMesh& mesh)
{
  for (const Mode mode : { Mode::OPTIMIZE_TRIANGLES, Mode::SMOOTH })
  {
    for (int k = 0; k < 3 * 3 * 3; ++k)
    {
      OptimizerOptions options = Options(mode, static_cast<LaplacianType>(k % 3));
      options.boundaryCondition = static_cast<BoundaryCondition>(k / 3 % 3);
      options.positionWeighting = static_cast<PositionWeighting>(k / 9);
      options.laplacianWeighting = static_cast<LaplacianWeighting>(k / 9);
      for (const SolverType solver : { SolverType::DIRECT, SolverType::ITERATIVE })
      {
        options.solverType = solver;
        options.tangentPlaneConstraints = !options.tangentPlaneConstraints;
        c.True("solved: " + name + ", " + std::to_string(k), IsSolved(mesh, options));
      }
    }
  }
}

void CheckDegenerateMeshes(Checks& c)
{
  for (const auto& [name, mesh] : DegenerateMeshes())
  {
    CheckMesh(c, name, mesh);
  }
}

void CheckOtherMeshes(Checks& c)
{
  for (const auto& [name, mesh] : AllTestMeshes())
  {
    CheckMesh(c, name, mesh);
  }
}

/// A triangle of height 1e-7: at its acute angles delta_c would be 1e5 edges long.
void CheckNeedle(Checks& c)
{
  TestMesh grid = Grid(4, 0);
  grid.V.row(12) << 1.5, 1 + 1e-7, 0;
  const double longestEdge = std::sqrt(1.5 * 1.5 + 2 * 2);
  c.Error("a needle moves nothing by more than its longest edge",
    MaximumDistance(Run(grid, Options(Mode::OPTIMIZE_TRIANGLES)).positions, grid.V), longestEdge);
}
}

int TestDegenerateMeshes(int argc, char* argv[])
{
  Groups groups(argc, argv);
  groups.Run("Needle", CheckNeedle);
  groups.Run("DegenerateMeshes", CheckDegenerateMeshes);
  groups.Run("OtherMeshes", CheckOtherMeshes);
  return groups.Result();
}
