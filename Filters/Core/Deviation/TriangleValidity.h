// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_TriangleValidity_h
#define lmo_TriangleValidity_h

#include "Core/Mesh/MeshTopology.h"

namespace lmo
{
/// Unit normals of the triangles that have a side to keep; 0 for those that have no normal or are
/// inverted: they face away from the sum of the vertex normals at their corners.
Points NormalsToKeep(const Points& V, const Triangles& triangles, const MeshTopology& topology);

/// Sum of the vertex normals at each triangle's corners, as a unit vector: noise and nearly
/// degenerate triangles turn it less than the triangle's own.
Points SmoothedNormals(const Points& V, const Triangles& triangles, const MeshTopology& topology);

/// True if a triangle has turned over: by more than a right angle.
/// \param normalToKeep one row of NormalsToKeep()
/// \param normal of the triangle now
inline bool HasTurnedOver(const Vector3& normalToKeep, const Vector3& normal)
{
  return normalToKeep.dot(normal) < 0;
}

/// Judges the triangles of a candidate mesh against those of an accepted one: none may turn bad,
/// turn over or fold. What is beyond a limit in the accepted mesh already must not get worse.
class TriangleValidity
{
public:
  /// Keeps references to the arguments, but for normals. The candidate has to be accepted first.
  /// \param accepted positions
  /// \param candidate positions, equal at first
  /// \param neighbours what FindTriangleNeighbours() returned
  /// \param originalNormals NormalsToKeep() of the original mesh
  /// \param referenceNormals SmoothedNormals() of the surface that the mesh lies on
  TriangleValidity(const Points& accepted, const Points& candidate, const Triangles& triangles,
    const MeshTopology& topology, const Triangles& neighbours, Points originalNormals,
    Points referenceNormals);

  /// t of the accepted triangles; those of a polygon have its quality.
  const Vector& GetAcceptedQuality() const { return this->AcceptedQuality; }

  /// t of the candidate's triangles.
  const Vector& GetQuality() const { return this->Quality; }

  /// Says which of the candidate's triangles have changed.
  void Update(const std::vector<Index>& triangles);

  /// True if t is below \a least and has fallen.
  bool IsBad(Index t, double least) const;

  /// True if the angle to a neighbour is too sharp, or if the triangle's polygon has more reflex
  /// corners than before.
  bool IsFolded(Index t) const;

  /// True if the triangle faces away from the vertex normals at its corners, more than before.
  bool IsInverted(Index t) const;

  /// True if the triangle turns over, or almost, in comparison with itself in the original mesh.
  bool IsTurnedOver(Index t) const;

  /// True if the triangle is turned against the surface that it lies on, more than before.
  /// \param below that surface's triangle under its centre
  bool IsTurned(Index t, Index below) const;

  /// Accepts one triangle of the candidate.
  void Accept(Index t, Index below);

  /// Accepts the quality of one triangle, which has changed with another one of its polygon.
  void AcceptQuality(Index t) { this->AcceptedQuality[t] = this->Quality[t]; }

  /// Goes back to the accepted ones of these triangles.
  void RollBack(const std::vector<Index>& triangles);

private:
  /// True if the triangle faces the same side as all that meet it: it is not inverted then, since
  /// the vertex normals are sums of theirs.
  bool FacesAllAround(Index t) const;

  /// RadiusRatio(), or PolygonQuality() of the triangle's polygon, in the candidate.
  double MeasureQuality(Index t) const;

  bool HasMoreReflexCorners(Index t) const;

  const Points& AcceptedPoints;
  const Points& CandidatePoints;
  const Triangles& T;
  const MeshTopology& Topology;
  const Triangles& Neighbours;
  const Points OriginalNormals; ///< what NormalsToKeep() returned
  const Points ReferenceNormals;
  Points AcceptedNormals; ///< of the triangles
  Points Normals;
  Vector AcceptedQuality;
  Vector Quality;
  Vector AcceptedCosine; ///< of the angle to the reference normal
};
}

#endif
