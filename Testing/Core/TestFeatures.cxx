// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "MeshMeasures.h"
#include "OperatorFixtures.h"

#include "Core/Mesh/FeatureLines.h"

#include <algorithm>
#include <array>
#include <cmath>

using namespace lmo;

namespace
{
/// Lines of these edges between \a vertices vertices.
std::shared_ptr<const AdjacencyLists> Lines(
  Index vertices, const std::vector<std::pair<Index, Index>>& edges)
{
  std::vector<std::vector<Index>> ends(vertices);
  for (const auto& [i, j] : edges)
  {
    ends[i].push_back(j);
    ends[j].push_back(i);
  }
  auto lists = std::make_shared<AdjacencyLists>();
  lists->offsets.push_back(0);
  for (std::vector<Index>& list : ends)
  {
    std::sort(list.begin(), list.end());
    lists->ids.insert(lists->ids.end(), list.begin(), list.end());
    lists->offsets.push_back(static_cast<Index>(lists->ids.size()));
  }
  return lists;
}

/// A regular polygon of unit radius as a closed line.
struct Polygon
{
  explicit Polygon(Index corners)
    : V(corners, 3)
  {
    std::vector<std::pair<Index, Index>> edges;
    for (Index i = 0; i < corners; ++i)
    {
      const double angle = 2 * std::acos(-1.0) * i / corners;
      this->V.row(i) << std::cos(angle), std::sin(angle), 0;
      edges.emplace_back(i, (i + 1) % corners);
    }
    this->features = ClassifyLines(Lines(corners, edges), this->V);
  }

  Points V;
  FeatureLines features;
};

bool HasOnly(const FeatureLines& features, FeatureLines::Class pointClass)
{
  return std::all_of(features.pointClass.begin(), features.pointClass.end(),
    [&](unsigned char c) { return c == pointClass; });
}

void CheckClasses(Checks& c)
{
  c.True("turns of 72 degrees are corners", HasOnly(Polygon(5).features, FeatureLines::CORNER));
  c.True("turns of 51 degrees are not", HasOnly(Polygon(7).features, FeatureLines::EDGE));

  // A line 0-1-2 that meets 2-3 and 2-4, and a vertex 5 on no line.
  Points V(6, 3);
  V << 0, 0, 0, 1, 0.1, 0, 2, 0, 0, 3, 1, 0, 3, -1, 0, 5, 5, 5;
  const FeatureLines fork = ClassifyLines(Lines(6, { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 2, 4 } }), V);
  const Mask expected = { FeatureLines::CORNER, FeatureLines::EDGE, FeatureLines::CORNER,
    FeatureLines::CORNER, FeatureLines::CORNER, FeatureLines::SMOOTH };
  c.Equal("ends and junctions are corners", fork.pointClass, expected);
  c.Error("the tangent joins the neighbours on the line",
    std::abs(std::abs(fork.tangents(1, 0)) - 1) + std::abs(fork.tangents(1, 1)), 1e-15);
  c.Error("corners have no tangent", fork.tangents.row(2).norm(), 0);

  const TestMesh grid = Grid(4, 0.3);
  const OperatorFixtures operators(grid);
  const FeatureLines rim =
    ClassifyLines({ operators.topology, &operators.topology->boundaryEdges }, grid.V);
  c.Equal("a square has four corners",
    std::count(rim.pointClass.begin(), rim.pointClass.end(), FeatureLines::CORNER), 4);
  c.Equal("a square of side 4 has twelve edge vertices",
    std::count(rim.pointClass.begin(), rim.pointClass.end(), FeatureLines::EDGE), 12);
}

void CheckLineVertices(Checks& c)
{
  Points V(4, 3);
  V << 0, 0, 0, 2, 0, 1, 6, 0, 0, 8, 0, 0;
  const FeatureLines line = ClassifyLines(Lines(4, { { 0, 1 }, { 1, 2 }, { 2, 3 } }), V);
  std::vector<std::array<Index, 3>> vertices;
  ForEachLineVertex(line,
    [&](Index i, Index previous, Index next) {
      vertices.push_back({ previous, i, next });
    });
  c.Equal("the vertices inside a line are visited with their neighbours along it", vertices,
    std::vector<std::array<Index, 3>>{ { 0, 1, 2 }, { 1, 2, 3 } });
}

double DistanceToPolygon(const Polygon& polygon, const Vector3& x)
{
  const Points& V = polygon.V;
  double distance = DistanceToSegment(x, V.row(0), V.row(V.rows() - 1));
  for (Index i = 1; i < V.rows(); ++i)
  {
    distance = std::min(distance, DistanceToSegment(x, V.row(i - 1), V.row(i)));
  }
  return distance;
}

void CheckProjection(Checks& c)
{
  // Shifts reach over several edges.
  const Polygon circle(60);
  const Points shift = 0.15 * Random().Displacements(60);
  Points moved = circle.V + shift;
  ProjectOntoLines(circle.features, circle.V, moved);
  double offLine = 0, tooFar = 0;
  for (Index i = 0; i < 60; ++i)
  {
    const Vector3 x = circle.V.row(i) + shift.row(i);
    offLine = Larger(offLine, DistanceToPolygon(circle, moved.row(i)));
    tooFar = Larger(tooFar, (Vector3(moved.row(i)) - x).norm() - DistanceToPolygon(circle, x));
  }
  c.Error("projected vertices lie on the line", offLine, 1e-15);
  c.Error("no point of the line is closer", tooFar, 1e-15);

  const Polygon pentagon(5);
  moved = pentagon.V + shift.topRows(5);
  ProjectOntoLines(pentagon.features, pentagon.V, moved);
  c.Error("corners are not projected", MaximumDistance(moved, pentagon.V + shift.topRows(5)), 0);
}

/// A flat sheet with a straight crease of so many edges, which turn by 53 degrees; others turn by
/// 37 degrees at most.
TestMesh CreasedSheet(Index edges)
{
  TestMesh mesh = Grid(16, 0);
  for (Index i = 3; i <= 3 + edges; ++i)
  {
    mesh.V(17 * 8 + i, 2) = 0.5;
  }
  return mesh;
}

/// The vertices on features.
Index CountOnFeatures(const TestMesh& mesh)
{
  OptimizerOptions options = Options(Mode::OPTIMIZE_TRIANGLES);
  options.featureConstraints = true;
  options.featureAngle = 45;
  return static_cast<Index>((Run(mesh, options).featureClass->array() > 0).count());
}

void CheckCreases(Checks& c)
{
  c.Equal("a crease of 9 edges is noise", CountOnFeatures(CreasedSheet(9)), 0);
  c.Equal("a crease of 10 edges is a feature", CountOnFeatures(CreasedSheet(10)), 11);
}
}

int TestFeatures(int argc, char* argv[])
{
  Groups groups(argc, argv);
  groups.Run("Classes", CheckClasses);
  groups.Run("LineVertices", CheckLineVertices);
  groups.Run("Projection", CheckProjection);
  groups.Run("Creases", CheckCreases);
  return groups.Result();
}
