// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Mesh/TriangleNeighbours.h"

#include "Core/Base/Threading.h"
#include "Core/Mesh/TriangleGeometry.h"

namespace lmo
{
namespace
{
/// The only triangle that runs along the edge from vertex i to j, else NoNeighbour; sought at the
/// vertex with fewer triangles.
Index TriangleAlong(const Triangles& triangles, const AdjacencyLists& cornersAt, Index i, Index j)
{
  const bool isAtStart = cornersAt.Size(i) <= cornersAt.Size(j);
  const Index pivot = isAtStart ? i : j;
  const Index other = isAtStart ? j : i;
  Index found = NoNeighbour;
  for (const Index corner : cornersAt[pivot])
  {
    const Index beside = isAtStart ? NextCorner(corner) : PreviousCorner(corner);
    if (triangles.data()[beside] == other)
    {
      if (found != NoNeighbour)
      {
        return NoNeighbour;
      }
      found = corner / 3;
    }
  }
  return found;
}
}

Index NeighbourAcross(const Triangles& triangles, const MeshTopology& topology, Index i, Index j)
{
  const Index here = TriangleAlong(triangles, topology.cornersAt, i, j);
  const Index there = TriangleAlong(triangles, topology.cornersAt, j, i);
  return here == NoNeighbour ? NoNeighbour : there;
}

Triangles FindTriangleNeighbours(const Triangles& triangles, const MeshTopology& topology)
{
  Triangles neighbours(triangles.rows(), 3);
  ParallelFor(static_cast<Index>(triangles.rows()),
    [&](Index t)
    {
      for (int k = 0; k < 3; ++k)
      {
        neighbours(t, k) =
          NeighbourAcross(triangles, topology, triangles(t, k), triangles(t, (k + 1) % 3));
      }
    });
  return neighbours;
}

bool IsClosedAndOriented(const Triangles& triangles, const MeshTopology& topology)
{
  const Index openEdges = ParallelSum(static_cast<Index>(triangles.rows()), Index(0),
    [&](Index& sum, Index t)
    {
      for (int k = 0; k < 3 && !IsDegenerate(triangles, t); ++k)
      {
        sum += NeighbourAcross(triangles, topology, triangles(t, k), triangles(t, (k + 1) % 3)) ==
               NoNeighbour;
      }
    });
  return openEdges == 0 && !topology.cornersAt.ids.empty();
}

bool IsInsideOut(const Points& V, const Triangles& triangles, const MeshTopology& topology)
{
  constexpr double roundOff = 1e-12;
  const double diagonal = BoundingBoxDiagonal(V, topology);
  return EnclosedVolume(V, triangles) < -roundOff * diagonal * diagonal * diagonal &&
         IsClosedAndOriented(triangles, topology);
}
}
