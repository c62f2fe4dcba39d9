// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_DistantVertices_h
#define lmo_DistantVertices_h

#include "Core/Base/IndexSet.h"
#include "Core/Mesh/MeshTopology.h"

namespace lmo
{
/// Vertices that do not share a cell, nor a vertex next to both: what one of them does to the
/// cells at it and to the normals of their corners does not depend on the others.
class DistantVertices
{
public:
  /// Keeps references to the arguments.
  DistantVertices(const Triangles& triangles, const MeshTopology& topology)
    : T(triangles)
    , Topology(topology)
    , Near(topology.vertices)
    , Ring(topology.vertices)
  {
  }

  /// Adds a vertex if it is distant from all of them.
  /// \return whether it is
  bool Add(Index vertex)
  {
    if (this->Near.GetMask()[vertex])
    {
      return false;
    }
    this->AddRing(vertex, this->Ring);
    for (const Index i : this->Ring.Get())
    {
      this->AddRing(i, this->Near);
    }
    this->Ring.Clear();
    return true;
  }

  void Clear() { this->Near.Clear(); }

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
  IndexSet Near; ///< to the vertices, and these
  IndexSet Ring; ///< empty in between
};
}

#endif
