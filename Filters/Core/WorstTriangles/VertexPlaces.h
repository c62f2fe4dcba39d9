// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_VertexPlaces_h
#define lmo_VertexPlaces_h

#include "Core/Mesh/DisplacementConstraints.h"
#include "Core/WorstTriangles/VertexMoves.h"

#include <functional>

namespace lmo
{
/// Where a vertex comes to lie that is asked to move to a point: on its feature line, for instance.
using PlaceVertex = std::function<Vector3(Index, const Vector3&)>;

/// Finds places where the least t around a vertex is greater. Threads may search for distant
/// vertices at once.
class VertexPlaces
{
public:
  enum Direction
  {
    ALONG_SURFACE,
    LIFTED ///< off the surface, where nothing else helps
  };

  /// Which places a vertex tries.
  enum Choice
  {
    BEST,  ///< the best one
    OTHERS ///< a part of the way there, and other better ones
  };

  /// Keeps references to the arguments.
  VertexPlaces(DeviationGuard& guard, const Triangles& triangles, const MeshTopology& topology,
    const DisplacementConstraints& constraints, const PlaceVertex& place)
    : Guard(guard)
    , T(triangles)
    , Topology(topology)
    , Constraints(constraints)
    , Place(place)
  {
  }

  /// The places to try, if a triangle at the vertex has t below the goal.
  VertexMove Find(Index vertex, double goal, Direction direction, Choice choice) const;

  /// True if mesh and reference are flat around the vertex, and are to stay so.
  bool IsOnPlane(Index vertex) const;

private:
  /// Unit normal of the vertex within the free axes; 0 where undefined.
  Vector3 NormalAt(Index vertex) const
  {
    const Vector3 normal = VertexNormal(this->Guard.GetAccepted(), this->T, this->Topology, vertex);
    return normal.cwiseProduct(this->Constraints.freeAxes).stableNormalized();
  }

  /// Unit directions in which the vertex may move.
  std::vector<Vector3> DirectionsOf(Index vertex) const;

  StarSearch::Freedom FreedomOf(Index vertex) const
  {
    return { this->DirectionsOf(vertex),
      [this, vertex](const Vector3& x) { return this->Place(vertex, x); },
      [this, vertex](const Vector3& x) { return this->Guard.IsValid(vertex, x); } };
  }

  DeviationGuard& Guard;
  const Triangles& T;
  const MeshTopology& Topology;
  const DisplacementConstraints& Constraints;
  const PlaceVertex& Place;
};
}

#endif
