// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "TriangleNeighbours.h"

#include "Parallel.h"

namespace lmo
{
namespace
{
/// The only corner at vertex i whose triangle has the edge from i to j, else NoNeighbour.
Index CornerBefore(const Triangles& triangles, const AdjacencyLists& cornersAt, Index i, Index j)
{
  Index found = NoNeighbour;
  for (const Index* corner = cornersAt.Begin(i); corner != cornersAt.End(i); ++corner)
  {
    if (triangles.data()[NextCorner(*corner)] == j)
    {
      if (found != NoNeighbour)
      {
        return NoNeighbour;
      }
      found = *corner;
    }
  }
  return found;
}
}

Triangles FindTriangleNeighbours(const Triangles& triangles, const MeshTopology& topology)
{
  Triangles neighbours(triangles.rows(), 3);
  ParallelFor(static_cast<Index>(triangles.rows()),
    [&](Index t)
    {
      for (int k = 0; k < 3; ++k)
      {
        const Index from = triangles(t, k);
        const Index to = triangles(t, (k + 1) % 3);
        const Index here = CornerBefore(triangles, topology.cornersAt, from, to);
        const Index there = CornerBefore(triangles, topology.cornersAt, to, from);
        const bool isSingle = here != NoNeighbour && there != NoNeighbour;
        neighbours(t, k) = isSingle ? there / 3 : NoNeighbour;
      }
    });
  return neighbours;
}
}
