// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "MeshMeasures.h"

#include "Core/Mesh/MeshTopology.h"

#include <algorithm>
#include <functional>
#include <numeric>

using namespace lmo;

namespace
{
MeshTopology Topology(const TestMesh& mesh)
{
  return BuildTopology(static_cast<Index>(mesh.V.rows()), mesh.T);
}

/// \param ids ascending
bool AreListed(const AdjacencyLists& lists, Index i, const std::vector<Index>& ids)
{
  std::vector<Index> listed(lists.Begin(i), lists.End(i));
  std::sort(listed.begin(), listed.end());
  return listed == ids;
}

/// Corners of fans that do not lie between the neighbours they should.
Index WrongFans(const TestMesh& mesh)
{
  const MeshTopology topology = Topology(mesh);
  Index wrong = 0;
  for (Index i = 0; i < topology.vertices; ++i)
  {
    const Index* ring = topology.oneRings.Begin(i);
    for (Index k = 0; topology.isFan[i] && k < topology.cornersAt.Size(i); ++k)
    {
      const Index corner = topology.cornersAt.Begin(i)[k];
      wrong += mesh.T.data()[NextCorner(corner)] != ring[k];
      wrong += mesh.T.data()[PreviousCorner(corner)] != ring[(k + 1) % topology.oneRings.Size(i)];
    }
  }
  return wrong;
}

Index WrongOneRings(const TestMesh& mesh)
{
  const MeshTopology topology = Topology(mesh);
  const std::vector<std::vector<Index>> neighbours = Neighbours(mesh);
  Index wrong = 0;
  for (Index i = 0; i < topology.vertices; ++i)
  {
    wrong += !AreListed(topology.oneRings, i, neighbours[i]);
    wrong += topology.isUsed[i] == neighbours[i].empty();
  }
  return wrong;
}

Index WrongTrianglesAtVertices(const TestMesh& mesh)
{
  const MeshTopology topology = Topology(mesh);
  Index wrong = 0;
  for (Index i = 0; i < topology.vertices; ++i)
  {
    std::vector<Index> corners;
    for (Index corner = 0; corner < mesh.T.size(); ++corner)
    {
      if (mesh.T.data()[corner] == i)
      {
        corners.push_back(corner);
      }
    }
    wrong += !AreListed(topology.cornersAt, i, corners);
  }
  return wrong;
}

Index WrongBoundaryFlags(const TestMesh& mesh)
{
  const MeshTopology topology = Topology(mesh);
  const std::vector<bool> isBoundary = BoundaryVertices(mesh);
  return std::inner_product(isBoundary.begin(), isBoundary.end(), topology.isBoundary.begin(),
    Index(0), std::plus<>(), std::not_equal_to<>());
}

void CheckHandMadeMeshes(Checks& c)
{
  const MeshTopology cross = Topology(CrossRing());
  c.True(
    "a ring's centre has the ring as neighbours", AreListed(cross.oneRings, 0, { 1, 2, 3, 4 }));
  c.True("a ring's edges are the boundary", AreListed(cross.boundaryEdges, 1, { 2, 4 }));
  c.True("a ring's centre is no boundary", !cross.isBoundary[0] && cross.isBoundary[1]);

  c.True("the corners around a ring's centre and at its boundary are fans",
    cross.isFan[0] && cross.isFan[1]);
  const MeshTopology wings = Topology(ThreeWings());
  c.True(
    "the edge of three triangles joins its ends", AreListed(wings.oneRings, 0, { 1, 2, 3, 4 }));
  c.True(
    "the edge of three triangles is no boundary", AreListed(wings.boundaryEdges, 0, { 2, 3, 4 }));
  c.True("the corners at an edge of three triangles are no fan", !wings.isFan[0]);

  const MeshTopology degenerate = Topology(WithTriangle(WithIsolatedPoint(Cube()), 0, 0, 5));
  c.True("a degenerate triangle has no neighbours",
    degenerate.oneRings.Size(0) == 0 && degenerate.cornersAt.Size(0) == 0 && !degenerate.isUsed[0]);
  c.True("a degenerate triangle opens no surface", degenerate.IsClosed());
}

void CheckClosedness(Checks& c)
{
  c.True("a cube is closed", Topology(Cube()).IsClosed());
  c.True("a cube and an isolated point are closed", Topology(WithIsolatedPoint(Cube())).IsClosed());
  c.True("half a sphere is open", !Topology(HalfSphere(2)).IsClosed());
  c.True("a cube with a fin is open", !Topology(WithTriangle(Cube(), 0, 1, 7)).IsClosed());
  c.True("no triangles are not closed", !BuildTopology(3, Triangles(0, 3)).IsClosed());
}

void CheckComponents(Checks& c)
{
  std::vector<Index> expected(46, 0);
  std::fill(expected.begin() + 42, expected.end(), 1);
  c.Equal("two components are numbered in their order",
    ConnectedComponents(Topology(TwoComponents()).oneRings), expected);
  expected.assign(9, 1);
  expected[0] = 0;
  c.Equal("an isolated point is a component",
    ConnectedComponents(Topology(WithIsolatedPoint(Cube())).oneRings), expected);
}

void CheckAllMeshes(Checks& c)
{
  for (const auto& [name, mesh] : AllTestMeshes())
  {
    c.Equal("one-rings are right: " + name, WrongOneRings(mesh), 0);
    c.Equal("triangles at vertices are right: " + name, WrongTrianglesAtVertices(mesh), 0);
    c.Equal("corners of fans are between their neighbours: " + name, WrongFans(mesh), 0);
    c.Equal("boundary is right: " + name, WrongBoundaryFlags(mesh), 0);
  }
}
}

int TestTopology(int argc, char* argv[])
{
  Groups groups(argc, argv);
  groups.Run("AllMeshes", CheckAllMeshes);
  groups.Run("HandMadeMeshes", CheckHandMadeMeshes);
  groups.Run("Closedness", CheckClosedness);
  groups.Run("Components", CheckComponents);
  return groups.Result();
}
