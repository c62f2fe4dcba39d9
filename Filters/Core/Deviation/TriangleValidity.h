// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_TriangleValidity_h
#define lmo_TriangleValidity_h

#include "Core/Mesh/MeshTopology.h"

namespace lmo
{
/// Judges the triangles of a candidate mesh against those of an admitted one: none may turn bad,
/// turn over or fold. What is beyond a limit in the admitted mesh already must not get worse.
class TriangleValidity
{
public:
  /// Keeps references to the arguments. The candidate is admitted at first.
  /// \param admitted positions
  /// \param candidate positions, equal at first
  /// \param neighbours what FindTriangleNeighbours() returned
  TriangleValidity(const Points& admitted, const Points& candidate, const Triangles& triangles,
    const MeshTopology& topology, const Triangles& neighbours);

  /// t of the admitted triangles.
  const Vector& GetAdmittedQuality() const { return this->AdmittedQuality; }

  /// t of the candidate's triangles.
  const Vector& GetQuality() const { return this->Quality; }

  /// Says which of the candidate's triangles have changed.
  void Update(const std::vector<Index>& triangles);

  /// True if t is below \a least and has fallen.
  bool IsBad(Index t, double least) const;

  /// True if the angle to a neighbour is too sharp.
  bool IsFolded(Index t) const;

  /// True if the triangle faces away from the vertex normals at its corners, more than before.
  bool IsInverted(Index t) const;

  /// True if the triangle is turned against the original surface, more than before.
  /// \param below the original triangle under its centre
  bool IsTurned(Index t, Index below) const;

  /// Admits one triangle of the candidate.
  void Admit(Index t, Index below);

  /// Goes back to the admitted triangles.
  void Reject();

private:
  /// True if the triangle faces the same side as all that meet it: it is not inverted then, since
  /// the vertex normals are sums of theirs.
  bool FacesAllAround(Index t) const;

  const Points& AdmittedPoints;
  const Points& CandidatePoints;
  const Triangles& T;
  const MeshTopology& Topology;
  const Triangles& Neighbours;
  const Points ReferenceNormals; ///< unit normals of the original triangles, smoothed
  Points AdmittedNormals;        ///< of the triangles
  Points Normals;
  Vector AdmittedQuality;
  Vector Quality;
  Vector AdmittedCosine; ///< of the angle to the reference normal
};
}

#endif
