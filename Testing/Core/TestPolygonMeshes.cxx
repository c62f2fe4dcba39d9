// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "MeshMeasures.h"
#include "PolygonFixtures.h"

#include "Core/Mesh/TriangleGeometry.h"
#include "Core/Mesh/TriangleQuality.h"

#include <algorithm>
#include <cmath>

using namespace lmo;

namespace
{
MeshTopology TopologyOf(const PolygonMesh& mesh)
{
  return BuildTopology(static_cast<Index>(mesh.V.rows()), mesh.T, mesh.polygons);
}

std::vector<Index> ListOf(const AdjacencyLists& lists, Index i)
{
  return { lists.Begin(i), lists.End(i) };
}

PolygonMesh Alone(const std::vector<Vector3>& corners)
{
  Points V(corners.size(), 3);
  Polygon polygon;
  for (std::size_t k = 0; k < corners.size(); ++k)
  {
    V.row(k) = corners[k];
    polygon.push_back(static_cast<Index>(k));
  }
  return MakePolygonMesh(V, { polygon });
}

double QualityOf(const PolygonMesh& mesh)
{
  return PolygonQuality(mesh.V, mesh.polygons, 0);
}

PolygonMesh RegularPolygon(int corners, double scale = 1)
{
  std::vector<Vector3> points;
  for (int k = 0; k < corners; ++k)
  {
    const double angle = 2 * Pi * k / corners;
    points.push_back(scale * Vector3(std::cos(angle), std::sin(angle), 3));
  }
  return Alone(points);
}

void CheckEdges(Checks& c)
{
  const MeshTopology grid = TopologyOf(QuadGrid(2, 0));
  c.Equal("the neighbours in a grid of quads are those along edges", ListOf(grid.oneRings, 4),
    std::vector<Index>{ 1, 3, 5, 7 });
  c.Equal("diagonals are no boundary", ListOf(grid.boundaryEdges, 0), std::vector<Index>{ 1, 3 });
  c.True("a vertex inside is off the boundary", !grid.isBoundary[4] && grid.isBoundary[1]);
  const MeshTopology torus = TopologyOf(QuadTorus(6));
  c.True("each vertex of a torus has four neighbours",
    std::all_of(torus.isUsed.begin(), torus.isUsed.end(), [](auto used) { return used; }) &&
      static_cast<Index>(torus.oneRings.ids.size()) == 4 * torus.vertices);
  c.True("a torus of quads is closed", torus.IsClosed());

  const PolygonMesh twice =
    MakePolygonMesh(Grid(2, 0).V, { { 0, 1, 3, 3 }, { 4, 4, 5, 5 }, { 1, 4, 3 } });
  const MeshTopology topology = TopologyOf(twice);
  c.Equal(
    "an edge without length is none", ListOf(topology.oneRings, 3), std::vector<Index>{ 0, 1, 4 });
  c.True("polygons without area are not used", !topology.isUsed[5] && topology.isUsed[4]);
}

void CheckTrianglesAround(Checks& c)
{
  const PolygonMesh sphere = HexagonSphere(1);
  const MeshTopology topology = TopologyOf(sphere);
  double error = 0;
  for (Index i = 0; i < topology.vertices; ++i)
  {
    std::vector<Index> expected;
    for (Index p = 0; p < sphere.polygons.Size(); ++p)
    {
      const std::vector<Index> corners = ListOf(sphere.polygons.corners, p);
      for (Index t = 0; t < sphere.T.rows(); ++t)
      {
        if (sphere.polygons.ofTriangle[t] == p &&
            std::find(corners.begin(), corners.end(), i) != corners.end())
        {
          expected.push_back(t);
        }
      }
    }
    std::vector<Index> found;
    ForEachTriangleOfCellsAt(
      topology.cornersAt, topology.polygons, i, [&](Index t) { found.push_back(t); });
    error = Larger(error, found != expected);
  }
  c.Error("all triangles of the polygons at a vertex are visited once", error, 0);
}

void CheckNormals(Checks& c)
{
  const PolygonMesh torus = Noisy(QuadTorus(8), 0.03);
  const Points normals = VertexNormals(torus.V, torus.T, TopologyOf(torus));
  const PolygonMesh other = CutElsewhere(torus, 1);
  c.Error("vertex normals do not depend on how quads are cut",
    MaximumDistance(normals, VertexNormals(other.V, other.T, TopologyOf(other))), 1e-14);
}

void CheckQuality(Checks& c)
{
  for (const int corners : { 4, 5, 6, 12 })
  {
    for (const double scale : { 1.0, 1e-70, 1e70 })
    {
      c.Error("a regular polygon has the quality 1",
        std::abs(QualityOf(RegularPolygon(corners, scale)) - 1), 1e-14);
    }
  }
  c.Error("a triangle has its radius ratio",
    std::abs(QualityOf(Alone({ { 0, 0, 0 }, { 3, 0, 0 }, { 0, 0, 4 } })) - 0.8), 1e-15);
  c.Error("a rectangle of 1 x 2 has the quality 4/5",
    std::abs(QualityOf(Alone({ { 0, 0, 0 }, { 2, 0, 0 }, { 2, 1, 0 }, { 0, 1, 0 } })) - 0.8),
    1e-15);
  c.Error("a rhombus with an angle of 30 degrees has the quality 1/2",
    std::abs(QualityOf(Alone(
               { { 0, 0, 0 }, { 2, 0, 0 }, { 2 + std::sqrt(3), 1, 0 }, { std::sqrt(3), 1, 0 } })) -
             0.5),
    1e-15);
  // The right angles of a house are larger than the sine of 108 degrees; the others count.
  const double sine = std::sin(2 * Pi / 5);
  c.Error("the worst corner of a pentagon counts",
    std::abs(
      QualityOf(Alone({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0.5, 1.5, 0 }, { 0, 1, 0 } })) -
      2 * 0.5 / (1.5 * sine)),
    1e-14);
  c.Error("a corner of 180 degrees gives 0",
    QualityOf(Alone({ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 1, 1, 0 } })), 0);
  c.Error("equal corners give 0",
    QualityOf(Alone({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } })), 0);
  const PolygonMesh arrow = Alone({ { 0, 0, 0 }, { 4, -3, 0 }, { 1, 0, 0 }, { 4, 3, 0 } });
  c.Equal("an arrow has one reflex corner", CountReflexCorners(arrow.V, arrow.polygons, 0), 1);
  const PolygonMesh hexagon = RegularPolygon(6);
  c.Equal("a hexagon has none", CountReflexCorners(hexagon.V, hexagon.polygons, 0), 0);
  const PolygonMesh notched = Ls(1, 0);
  c.Equal("an L has one", CountReflexCorners(notched.V, notched.polygons, 1), 1);
}
}

int TestPolygonMeshes(int argc, char* argv[])
{
  Groups groups(argc, argv);
  groups.Run("Edges", CheckEdges);
  groups.Run("TrianglesAround", CheckTrianglesAround);
  groups.Run("Normals", CheckNormals);
  groups.Run("Quality", CheckQuality);
  return groups.Result();
}
