// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_DeviationGuard_h
#define lmo_DeviationGuard_h

#include "DistanceProofs.h"

namespace lmo
{
/// Judges motions of a mesh's vertices: every point of the moved surface has to stay within a
/// distance of the original one, and every point of the original one within it of the moved one;
/// triangles must not turn bad, turn over or fold. Where the mesh that is admitted so far is beyond
/// a limit already, it must not get worse.
class DeviationGuard
{
public:
  /// Triangles that are beyond a limit: some of their vertices have to move less. If none of
  /// \a close moves, then those of \a others.
  struct Failure
  {
    Index close;
    std::vector<Index> others;
  };

  /// Keeps references to the arguments.
  /// \param distance > 0
  DeviationGuard(
    const Points& V, const Triangles& triangles, const MeshTopology& topology, double distance);
  DeviationGuard(const DeviationGuard&) = delete;
  void operator=(const DeviationGuard&) = delete;

  /// The positions admitted so far: those of the original mesh at first.
  const Points& GetAdmitted() const { return this->Admitted; }

  /// Unit normals and t of the admitted triangles.
  const Points& GetAdmittedNormals() const { return this->AdmittedNormals; }
  const Vector& GetAdmittedQuality() const { return this->AdmittedQuality; }

  /// The positions to be judged; whoever moves a vertex names it in the next Check().
  const Points& GetCandidate() const { return this->Candidate; }
  void Move(Index vertex, const Vector3& position) { this->Candidate.row(vertex) = position; }

  /// Judges the candidate.
  /// \param vertices that have moved since the last call
  /// \param leastQuality t below which a triangle's t must not fall
  /// \return no failures if the candidate may be admitted
  std::vector<Failure> Check(const std::vector<Index>& vertices, double leastQuality);

  /// Admits the candidate, in which Check() found no failure.
  void Admit();

  /// Goes back to the admitted positions.
  void Reject();

  /// Every point of one surface is within this distance of the other, in both directions.
  double GetBound() const { return this->Bound; }

private:
  void UpdateShapes(const std::vector<Index>& triangles);
  bool IsShapely(Index t, double leastQuality) const;
  bool IsMoved(Index t) const;
  bool IsTurned(Index t) const;

  const Points& Original;
  const Triangles& T;
  const MeshTopology& Topology;
  const double Distance;
  const Triangles Neighbours;
  Points ReferenceNormals; ///< unit normals of the original triangles, smoothed
  Points Admitted;
  Points Candidate;
  Points AdmittedNormals;
  Points Normals; ///< of the candidate
  Vector AdmittedQuality;
  Vector Quality;        ///< of the candidate
  Vector AdmittedCosine; ///< of the angle to the reference normal
  double Bound = 0;
  TriangleTree OriginalTree;
  TriangleTree Tree;               ///< of the candidate
  DistanceProofs ToOriginal;       ///< the candidate's triangles are close to the original mesh
  DistanceProofs ToCandidate;      ///< and the other way round
  DistanceProofs ToAdmitted;       ///< the original triangles are close to the admitted mesh
  std::vector<Index> Open;         ///< triangles of the candidate that failed in the last check
  std::vector<Index> OpenOriginal; ///< the same of the original mesh
};
}

#endif
