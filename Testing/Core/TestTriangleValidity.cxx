// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "MovedVertex.h"

#include "Core/Deviation/DeviationGuard.h"

#include <cmath>

using namespace lmo;

namespace
{
void CheckAcceptedDisplacements(Checks& c)
{
  const MovedVertex near(Hexagon(), 0, { 0.7, 0.1, 0 });
  c.True("a vertex that stays in its ring turns, folds and inverts no triangle",
    near.Turned() == 0 && near.Folded() == 0 && near.Inverted() == 0);
}

void CheckTurned(Checks& c)
{
  // At the height h over the middle, a face makes the angle atan(h / (sqrt(3) / 2)) with the plane;
  // its cosine is 0.3 at h = 2.75.
  c.Equal("a cone whose faces are turned by 72 degrees is accepted",
    MovedVertex(Hexagon(), 0, { 0, 0, 2.7 }).Turned(), 0);
  c.Equal("a cone whose faces are turned by 73 degrees is not",
    MovedVertex(Hexagon(), 0, { 0, 0, 2.8 }).Turned(), 6);
}

/// Where the free corner of the hinge lies when it is closed by an angle in degrees.
Vector3 ClosedBy(double degrees)
{
  const double angle = degrees / 180 * std::acos(-1.0);
  return { std::cos(angle), 0.5, std::sin(angle) };
}

void CheckFolded(Checks& c)
{
  c.Equal("a hinge that is closed by 119 degrees is accepted",
    MovedVertex(Hinge(), 3, ClosedBy(119)).Folded(), 0);
  c.Equal("a hinge that is closed by 121 degrees is folded",
    MovedVertex(Hinge(), 3, ClosedBy(121)).Folded(), 2);
  TestMesh closed = Hinge();
  closed.V.row(3) = ClosedBy(150);
  c.Equal("a hinge that was closed further may be opened",
    MovedVertex(closed, 3, ClosedBy(140)).Folded(), 0);
  c.Equal("a hinge that was closed further may not be closed more",
    MovedVertex(closed, 3, ClosedBy(155)).Folded(), 2);
}

void CheckInverted(Checks& c)
{
  // Beyond the edge between the ring's first two corners, whose triangle turns over.
  const Vector3 beyond(0.95 * std::sqrt(3) / 2, 0.95 / 2, 0);
  const MovedVertex moved(Hexagon(), 0, beyond);
  c.Equal(
    "a vertex that leaves its ring inverts the triangle that it crosses", moved.Inverted(), 1);
  TestMesh inverted = Hexagon();
  inverted.V.row(0) = beyond;
  c.Equal(
    "a triangle that was inverted may stay so", MovedVertex(inverted, 0, beyond).Inverted(), 0);
}

void CheckGuard(Checks& c)
{
  const TestMesh mesh = Hexagon();
  const MeshTopology topology = BuildTopology(Index(mesh.V.rows()), mesh.T);
  ProgressMonitor monitor;
  constexpr double distance = 10; // so that validity alone decides
  DeviationGuard guard(mesh.V, mesh.T, topology, distance, monitor);
  guard.Propose(0, { 0.95 * std::sqrt(3) / 2, 0.95 / 2, 0 });
  c.True("the guard refuses a triangle that turns over",
    !guard.Judge({ 0 }, 0, DeviationGuard::MANY_VERTICES, monitor).empty());
}
}

int TestTriangleValidity(int argc, char* argv[])
{
  Groups groups(argc, argv);
  groups.Run("AcceptedDisplacements", CheckAcceptedDisplacements);
  groups.Run("Turned", CheckTurned);
  groups.Run("Folded", CheckFolded);
  groups.Run("Inverted", CheckInverted);
  groups.Run("Guard", CheckGuard);
  return groups.Result();
}
