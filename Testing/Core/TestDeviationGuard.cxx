// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause

// Every refusal of the guard, on displacements that no other one decides; of many vertices at once
// and of single ones.
#include "Checks.h"
#include "MovedVertex.h"

#include "Core/Deviation/DeviationGuard.h"

#include <Eigen/Geometry>

#include <cmath>

using namespace lmo;

namespace
{
/// A guard over a mesh of its own.
class GuardedMesh
{
public:
  GuardedMesh(const TestMesh& mesh, double distance)
    : Mesh(mesh)
    , Topology(BuildTopology(Index(mesh.V.rows()), mesh.T))
    , Guard(this->Mesh.V, this->Mesh.T, this->Topology, distance, this->Monitor)
  {
  }

  /// Proposes a position for each of the vertices and judges them at once.
  bool IsAccepted(const std::vector<Index>& vertices, const Points& positions,
    DeviationGuard::Extent extent, double leastQuality = 0)
  {
    for (std::size_t k = 0; k < vertices.size(); ++k)
    {
      this->Guard.Propose(vertices[k], positions.row(Eigen::Index(k)));
    }
    const bool isValid = this->Guard.Judge(vertices, leastQuality, extent, this->Monitor).empty();
    isValid ? this->Guard.Accept() : this->Guard.RollBack();
    return isValid;
  }

  const DeviationGuard& Get() const { return this->Guard; }

private:
  const TestMesh Mesh;
  const MeshTopology Topology;
  ProgressMonitor Monitor;
  DeviationGuard Guard;
};

constexpr DeviationGuard::Extent Extents[] = { DeviationGuard::MANY_VERTICES,
  DeviationGuard::SINGLE_VERTICES };

std::string Named(const std::string& property, DeviationGuard::Extent extent)
{
  return property + (extent == DeviationGuard::MANY_VERTICES ? ", all failures" : ", the first");
}

/// Displacements of one vertex of a flat ring, each of which one limit alone decides.
void CheckOneLimit(Checks& c)
{
  constexpr double far = 10; // so that distances do not decide
  const auto moves = [](double distance, Index vertex, const Vector3& position,
                       DeviationGuard::Extent extent, double leastQuality = 0) {
    return GuardedMesh(Hexagon(), distance).IsAccepted({ vertex }, position, extent, leastQuality);
  };
  for (const DeviationGuard::Extent extent : Extents)
  {
    c.True(Named("the guard accepts a vertex that stays in its ring", extent),
      moves(far, 0, { 0.7, 0.1, 0 }, extent));
    c.True(Named("the guard refuses a radius ratio that falls below the least", extent),
      !moves(far, 0, { 0.7, 0.1, 0 }, extent, 0.9));
    c.True(Named("the guard refuses a triangle that turns over", extent),
      !moves(far, 0, { 0.95 * std::sqrt(3) / 2, 0.95 / 2, 0 }, extent));
    c.True(Named("the guard refuses triangles that turn against the surface below", extent),
      !moves(far, 0, { 0, 0, 2.8 }, extent));
    c.True(Named("the guard refuses a surface that leaves the original one", extent),
      !moves(0.1, 1, { 1.3, 0, 0 }, extent));
    c.True(Named("the guard refuses a surface that leaves a part of the original one", extent),
      !moves(0.1, 1, { 0.7, 0, 0 }, extent));
  }
}

/// A hinge whose wings are both closed by some degrees.
TestMesh RoofClosedBy(double degrees)
{
  const double angle = degrees / 180 * std::acos(-1.0);
  TestMesh roof = Hinge();
  roof.V.row(2) << -std::cos(angle), 0.5, -std::sin(angle);
  roof.V.row(3) << std::cos(angle), 0.5, -std::sin(angle);
  return roof;
}

void CheckFoldAlone(Checks& c)
{
  for (const DeviationGuard::Extent extent : Extents)
  {
    const auto isAccepted = [&](double degrees)
    {
      return GuardedMesh(RoofClosedBy(30), 10)
        .IsAccepted({ 2, 3 }, RoofClosedBy(degrees).V.bottomRows(2), extent);
    };
    c.True(Named("wings that close to 58 degrees each are accepted", extent), isAccepted(58));
    c.True(Named("wings that close to 62 degrees each are a fold", extent), !isAccepted(62));
  }
}

/// Only the comparison of each triangle with itself sees that a sphere has turned.
void CheckTurnAlone(Checks& c)
{
  const TestMesh sphere = Icosphere(2);
  std::vector<Index> all(sphere.V.rows());
  std::iota(all.begin(), all.end(), 0);
  for (const DeviationGuard::Extent extent : Extents)
  {
    GuardedMesh mesh(sphere, 0.2);
    int accepted = 0;
    for (int degrees = 20; degrees <= 100; degrees += 20)
    {
      const Eigen::AngleAxisd turn(degrees * std::acos(-1.0) / 180, Eigen::Vector3d::UnitZ());
      accepted += mesh.IsAccepted(all, sphere.V * turn.matrix().transpose(), extent);
    }
    c.True(Named("a sphere may turn by 80 degrees in itself, not by 100", extent), accepted == 4);
  }
}

/// Random displacements of single vertices of a rough sphere that invert a triangle.
void CheckInversions(Checks& c)
{
  const TestMesh rough = Irregular(Icosphere(1), 0.25);
  Random random;
  Index accepted = 0;
  for (int k = 0; k < 3000 / Thinning; ++k)
  {
    const Index vertex = k % Index(rough.V.rows());
    const Vector3 position = rough.V.row(vertex) + 0.6 * Vector3(random(), random(), random());
    const MovedVertex moved(rough, vertex, position);
    if (moved.Inverted() > 0)
    {
      for (const DeviationGuard::Extent extent : Extents)
      {
        accepted += GuardedMesh(rough, 10).IsAccepted({ vertex }, position, extent);
      }
    }
  }
  c.True("the guard refuses every displacement that inverts a triangle", accepted == 0);
}

void CheckRollBack(Checks& c)
{
  const Vector3 good(0.1, 0.1, 0.05);
  for (const DeviationGuard::Extent extent : Extents)
  {
    GuardedMesh tried(Hexagon(), 0.1);
    GuardedMesh fresh(Hexagon(), 0.1);
    for (const Vector3& bad : { Vector3(0, 0, 0.5), Vector3(2, 0, 0), Vector3(0, 0, 0.11) })
    {
      tried.IsAccepted({ 0 }, bad, extent);
    }
    c.True(Named("what is rolled back leaves the positions alone", extent),
      tried.Get().GetAccepted() == Hexagon().V && tried.Get().GetBound() == 0);
    const bool isSame =
      tried.IsAccepted({ 0 }, good, extent) && fresh.IsAccepted({ 0 }, good, extent);
    c.True(Named("what is rolled back leaves no trace in what is accepted later", extent),
      isSame && tried.Get().GetAccepted() == fresh.Get().GetAccepted() &&
        tried.Get().GetBound() == fresh.Get().GetBound());
  }
}

void CheckNormalsToKeep(Checks& c)
{
  TestMesh mesh = Icosphere(1);
  mesh.T.row(3).reverseInPlace();
  mesh.V.row(mesh.T(7, 0)) = mesh.V.row(mesh.T(7, 1));
  const Points normals =
    NormalsToKeep(mesh.V, mesh.T, BuildTopology(static_cast<Index>(mesh.V.rows()), mesh.T));
  c.True("an inverted triangle and one without area have no side to keep",
    normals.row(3).isZero(0) && normals.row(7).isZero(0));
  c.True("the others have", (normals.rowwise().norm().array() > 0.9).count() >= mesh.T.rows() - 4);
}
}

int TestDeviationGuard(int argc, char* argv[])
{
  Groups groups(argc, argv);
  groups.Run("OneLimit", CheckOneLimit);
  groups.Run("FoldAlone", CheckFoldAlone);
  groups.Run("TurnAlone", CheckTurnAlone);
  groups.Run("Inversions", CheckInversions);
  groups.Run("RollBack", CheckRollBack);
  groups.Run("NormalsToKeep", CheckNormalsToKeep);
  return groups.Result();
}
