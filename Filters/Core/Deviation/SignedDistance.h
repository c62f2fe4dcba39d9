// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_SignedDistance_h
#define lmo_SignedDistance_h

#include "Core/Base/ProgressMonitor.h"
#include "Core/Mesh/MeshTopology.h"

#include <optional>

namespace lmo
{
/// Tells inside from outside of a closed surface, by the angle-weighted pseudonormal of the part of
/// it that is closest: of a triangle, an edge or a vertex (Baerentzen and Aanaes, Signed Distance
/// Computation Using the Angle Weighted Pseudonormal, 2005).
class SurfaceSides
{
public:
  /// Keeps references to the arguments.
  SurfaceSides(const Points& V, const Triangles& triangles, const MeshTopology& topology);

  /// -1 behind the triangles, that is inside unless the surface is inside out; 1 before and on
  /// them.
  /// \param closest triangle of the surface
  double SideOf(const Vector3& x, Index closest) const;

private:
  /// Normal of triangle t, of its edge from corner k to the next, and of vertex i; 0 if undefined.
  Vector3 OfTriangle(Index t) const;
  Vector3 OfEdge(Index t, int k) const;
  Vector3 OfVertex(Index i) const;

  const Points& V;
  const Triangles& T;
  const MeshTopology& Topology;
  Points VertexNormals; ///< all of OfVertex(): a vertex may have many triangles
};

/// The distances with a sign: negative inside the reference, also if that IsInsideOut(). Where
/// bodies overlap, the sign is that of the closest one.
/// \param distances of the points to the reference
/// \param closest triangle of the reference, for each point; -1 stands for outside
/// \return nothing unless the reference IsClosedAndOriented()
/// \throw Cancelled if the monitor says so.
std::optional<Vector> SignedDistances(const Points& points, const Vector& distances,
  const std::vector<Index>& closest, const Points& referenceV, const Triangles& referenceTriangles,
  ProgressMonitor& monitor);
}

#endif
