// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_DistantVertices_h
#define lmo_DistantVertices_h

#include "Core/Base/IndexSet.h"
#include "Core/Mesh/MeshTopology.h"

#include <algorithm>

namespace lmo
{
/// Vertices that do not share a cell, nor a vertex next to both, nor a triangle of the reference
/// whose certificate needs the cells of both: what the guard says of one of them does not depend on
/// the others.
class DistantVertices
{
public:
  /// Keeps references to the arguments.
  /// \param referenceTriangles number of them
  DistantVertices(
    const Triangles& triangles, const MeshTopology& topology, Index referenceTriangles)
    : T(triangles)
    , Topology(topology)
    , Near(topology.vertices)
    , Ring(topology.vertices)
    , Below(referenceTriangles)
  {
  }

  /// Adds a vertex if it is distant from all of them.
  /// \param findBelow returns the triangles of the reference that depend on the vertex
  /// \return whether it is
  template <typename FindBelow>
  bool Add(Index vertex, const FindBelow& findBelow)
  {
    if (this->Near.GetMask()[vertex])
    {
      return false;
    }
    const std::vector<Index> below = findBelow(vertex);
    if (std::any_of(
          below.begin(), below.end(), [this](Index t) { return this->Below.GetMask()[t]; }))
    {
      return false;
    }
    this->Below.Add(below);
    this->AddRing(vertex, this->Ring);
    for (const Index i : this->Ring.Get())
    {
      this->AddRing(i, this->Near);
    }
    this->Ring.Clear();
    return true;
  }

  void Clear()
  {
    this->Near.Clear();
    this->Below.Clear();
  }

private:
  /// Adds the corners of the cells at a vertex.
  void AddRing(Index vertex, IndexSet& ring) const
  {
    ForEachTriangleOfCellsAt(this->Topology.cornersAt, this->Topology.polygons, vertex,
      [&](Index t)
      {
        for (const Index i : this->T.row(t))
        {
          ring.Add(i);
        }
      });
  }

  const Triangles& T;
  const MeshTopology& Topology;
  IndexSet Near;  ///< to the vertices, and these
  IndexSet Ring;  ///< empty in between
  IndexSet Below; ///< triangles of the reference that depend on the vertices
};
}

#endif
