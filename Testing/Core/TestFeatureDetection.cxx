// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CadFixtures.h"
#include "Checks.h"

#include "Core/Mesh/FeatureDetection.h"
#include "Core/Mesh/FeatureLines.h"
#include "Core/Mesh/TriangleGeometry.h"
#include "Core/Mesh/TriangleQuality.h"

#include <algorithm>
#include <cmath>

using namespace lmo;

namespace
{
Mask ClassesOf(const TestMesh& mesh, double angle = 40)
{
  const MeshTopology topology = BuildTopology(static_cast<Index>(mesh.V.rows()), mesh.T);
  const AdjacencyLists edges =
    DetectFeatureEdges(mesh.V, mesh.T, topology, RadiusRatios(mesh.V, mesh.T), angle);
  return ClassifyLines(std::make_shared<AdjacencyLists>(edges), mesh.V).pointClass;
}

Index Count(const Mask& classes, FeatureLines::Class pointClass)
{
  return static_cast<Index>(std::count(classes.begin(), classes.end(), pointClass));
}

/// Points whose class is not the one expected: the first \a rim points have one, all others are
/// smooth.
Index CountWrong(const TestMesh& mesh, Index rim, FeatureLines::Class expected, double angle = 40)
{
  const Mask classes = ClassesOf(mesh, angle);
  Index wrong = 0;
  for (Index i = 0; i < static_cast<Index>(classes.size()); ++i)
  {
    wrong += classes[i] != (i < rim ? expected : FeatureLines::SMOOTH);
  }
  return wrong;
}

void CheckBars(Checks& c)
{
  Index wrong[2] = { 0, 0 };
  for (const int sides : { 3, 4, 5, 6, 7, 8, 9, 10, 12, 16, 33, 64, 100, 128, 256 })
  {
    for (const double length : { 1, 5, 100 })
    {
      for (const Cap cap : { Cap::CENTRE, Cap::FAN, Cap::STRIP })
      {
        const TestMesh bar = Bar(sides, length, cap);
        // Above 40 degrees the sides themselves meet at sharp edges.
        const auto expected = sides < 9 ? FeatureLines::CORNER : FeatureLines::EDGE;
        wrong[0] += CountWrong(bar, 2 * sides, expected);
        wrong[1] += CountWrong(TurnedInSinglePrecision(bar), 2 * sides, expected);
      }
    }
  }
  c.Error("points of a bar's rims that are not found", wrong[0], 0);
  c.Error("points of a bar's rims that are not found in single precision", wrong[1], 0);
}

void CheckTurns(Checks& c)
{
  const TestMesh bar = TurnedInSinglePrecision(Bar(6, 10, Cap::FAN));
  c.Error("a rim that turns by 60 degrees, up to round-off, is a line",
    CountWrong(bar, 12, FeatureLines::EDGE, 60), 0);
  c.Error("a rim that turns by more has corners only",
    CountWrong(Bar(5, 10, Cap::FAN), 10, FeatureLines::CORNER, 80), 0);
}

void CheckUnits(Checks& c)
{
  const TestMesh bar = Bar(64, 5, Cap::CENTRE);
  Index wrong = 0;
  for (const double unit : { 1e-8, 1e-3, 25.4, 1e8 })
  {
    wrong +=
      CountWrong(Transformed(bar, unit, unit * Vector3(10, -20, 30)), 128, FeatureLines::EDGE);
  }
  c.Error("points of a bar's rims that are not found in other units", wrong, 0);
  c.Error("points of a bar's rims that are not found far from the origin",
    CountWrong(Transformed(bar, 1, Vector3(1e8, 1e8, 0)), 128, FeatureLines::EDGE), 0);
}

void CheckProfiles(Checks& c)
{
  const std::vector<std::vector<std::pair<double, double>>> profiles = { { { 1, -1 }, { 1, 1 },
                                                                           { -1, 1 }, { -1, -1 } },
    { { 3, -1 }, { 0, 2 }, { -3, -1 } }, { { 5, -0.02 }, { 5, 0.02 }, { -5, 0.02 }, { -5, -0.02 } },
    { { 3, -0.5 }, { 3, 0.5 }, { 0.5, 0.5 }, { 0.5, 3 }, { -0.5, 3 }, { -0.5, -0.5 } } };
  Index wrong = 0;
  for (const auto& profile : profiles)
  {
    const auto rim = static_cast<Index>(2 * profile.size());
    const TestMesh bar = ExtrudedProfile(profile, 100);
    wrong += CountWrong(bar, rim, FeatureLines::CORNER);
    wrong += CountWrong(TurnedInSinglePrecision(bar), rim, FeatureLines::CORNER);
  }
  c.Error("corners of long profiles that are not found", wrong, 0);
}

void CheckPlates(Checks& c)
{
  Index missed = 0;
  for (const int sides : { 8, 9, 12, 16, 24, 32, 48, 64 })
  {
    for (const auto& [radius, thickness] : { std::pair(0.8, 0.5), std::pair(0.95, 0.02) })
    {
      const TestMesh plate = PlateWithHoles(3, 2, sides, radius, thickness);
      // Points of the upper and lower sides' grids that lie inside.
      missed += Count(ClassesOf(plate), FeatureLines::SMOOTH) - 2 * 2;
      missed += Count(ClassesOf(TurnedInSinglePrecision(plate)), FeatureLines::SMOOTH) - 2 * 2;
    }
  }
  c.Error("points of plates with holes that are not found", missed, 0);
}

void CheckTrianglesWithoutArea(Checks& c)
{
  TestMesh bar = Bar(64, 5, Cap::CENTRE);
  for (Index t = 0; t < 128; t += 4)
  {
    bar = WithZeroAreaTriangle(bar, t); // at the rim
  }
  const auto all = static_cast<Index>(bar.V.rows());
  const Index smooth[2] = { Count(ClassesOf(bar), FeatureLines::SMOOTH),
    Count(ClassesOf(TurnedInSinglePrecision(bar)), FeatureLines::SMOOTH) };
  c.True("triangles without area do not interrupt a rim",
    all == 130 + 32 && smooth[0] == 2 && smooth[1] == 2);
}

/// The grid with noise of a normal distribution across it.
TestMesh NoisyGrid(int cells, double amplitude, unsigned seed)
{
  TestMesh grid = Grid(cells, 0);
  std::mt19937 engine(seed);
  const auto uniform = [&] { return (engine() + 0.5) / 4294967296.0; };
  for (auto v : grid.V.rowwise())
  {
    v[2] = amplitude * std::sqrt(-2 * std::log(uniform())) * std::cos(2 * Pi * uniform());
  }
  return grid;
}

void CheckNoise(Checks& c)
{
  Index found = 0;
  for (unsigned seed = 1; seed <= 10; ++seed)
  {
    for (const double amplitude : { 0.2, 0.4 })
    {
      const TestMesh grid = NoisyGrid(20, amplitude, seed);
      found += static_cast<Index>(grid.V.rows()) - Count(ClassesOf(grid), FeatureLines::SMOOTH);
    }
  }
  c.Error("points of noisy planes that are taken for features", found, 0);
}

void CheckSlivers(Checks& c)
{
  // One vertex close to an edge of its ring, and out of the plane by more than it is away.
  TestMesh grid = Grid(10, 0);
  grid.V.row(60) += Vector3(0.97, 0.01, 0.05);
  c.True("slivers on a plane are no features",
    Count(ClassesOf(grid), FeatureLines::SMOOTH) == grid.V.rows());

  TestMesh roof = Grid(12, 0);
  for (auto v : roof.V.rowwise())
  {
    v[2] = -std::abs(v[0] - 6);
  }
  const Index ridge = Count(ClassesOf(roof), FeatureLines::EDGE);
  c.True("a ridge has no corners but its ends",
    ridge == 11 && Count(ClassesOf(roof), FeatureLines::CORNER) == 2);
}
}

int TestFeatureDetection(int argc, char* argv[])
{
  Groups groups(argc, argv);
  groups.Run("Bars", CheckBars);
  groups.Run("Turns", CheckTurns);
  groups.Run("Units", CheckUnits);
  groups.Run("Profiles", CheckProfiles);
  groups.Run("Plates", CheckPlates);
  groups.Run("TrianglesWithoutArea", CheckTrianglesWithoutArea);
  groups.Run("Noise", CheckNoise);
  groups.Run("Slivers", CheckSlivers);
  return groups.Result();
}
