// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_DeviationGuard_h
#define lmo_DeviationGuard_h

#include "Core/Deviation/DeviationCertificates.h"
#include "Core/Deviation/TriangleValidity.h"

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
  /// \throw Cancelled if the monitor says so.
  DeviationGuard(const Points& V, const Triangles& triangles, const MeshTopology& topology,
    double distance, ProgressMonitor& monitor);
  DeviationGuard(const DeviationGuard&) = delete;
  void operator=(const DeviationGuard&) = delete;

  /// The positions admitted so far: those of the original mesh at first.
  const Points& GetAdmitted() const { return this->Admitted; }

  /// t of the admitted triangles.
  const Vector& GetAdmittedQuality() const { return this->Shapes.GetAdmittedQuality(); }

  /// t of the triangles judged last.
  const Vector& GetQuality() const { return this->Shapes.GetQuality(); }

  /// Heights of the original surface over an admitted triangle.
  const HeightRange& GetHeights(Index t) const { return this->AdmittedHeights[t]; }

  /// Every point of one surface is within this distance of the other, for the positions admitted.
  double GetBound() const;

  /// Sets a position to be judged; the vertex has to be named in the next Check().
  void Move(Index vertex, const Vector3& position) { this->Candidate.row(vertex) = position; }

  /// Judges the positions set.
  /// \param vertices that have moved since the last call
  /// \param leastQuality t below which that of a triangle must not fall
  /// \return no failures if they may be admitted
  /// \throw Cancelled if the monitor says so; what is admitted remains, and no more can be judged.
  std::vector<Failure> Check(
    const std::vector<Index>& vertices, double leastQuality, ProgressMonitor& monitor);

  /// Admits the positions set, in which Check() found no failure.
  void Admit();

  /// Goes back to the admitted positions.
  void Reject();

  /// Moves one vertex and admits that, if no limit is passed; a triangle's t may fall. Any
  /// positions set before have to be admitted or rejected.
  /// \return whether it is admitted
  bool TryMove(Index vertex, const Vector3& position);

private:
  std::vector<Index> TrianglesAt(const std::vector<Index>& vertices) const;
  SurfaceView OriginalView() const { return { this->Original, this->T, this->Neighbours }; }
  SurfaceView CandidateView() const { return { this->Candidate, this->T, this->Neighbours }; }

  bool IsMoved(Index t) const;

  /// Proves an original triangle by the certificate that is admitted, if the motion since then
  /// leaves enough of the distance: a point of a triangle moves no farther than its corners.
  /// \return whether it does
  bool CarryToCandidate(Index t);

  /// The same for a triangle of the candidate.
  bool CarryToOriginal(Index t);

  double MotionOf(Index t) const;

  /// Moves the triangles of the list that are beyond a limit to the result.
  template <typename IsBeyond>
  static std::vector<Index> Split(
    std::vector<Index>& list, ProgressMonitor& monitor, const IsBeyond& isBeyond);

  /// The triangles of the list that are far from the original surface or turned against it.
  std::vector<Index> FindAstray(const std::vector<Index>& list, ProgressMonitor& monitor);

  void AdmitTriangle(Index t);

  const Points& Original;
  const Triangles& T;
  const MeshTopology& Topology;
  const double Distance;
  const Triangles Neighbours;
  Points Admitted;
  Points Candidate;
  TriangleValidity Shapes;
  std::vector<HeightRange> AdmittedHeights; ///< of the original surface
  TriangleBvh OriginalTree;
  TriangleBvh Tree;                  ///< of the candidate
  DeviationCertificates ToOriginal;  ///< the candidate's triangles are close to the original mesh
  DeviationCertificates ToCandidate; ///< and the other way round
  DeviationCertificates ToAdmitted;  ///< the original triangles are close to the admitted mesh
  std::vector<Index> Open;           ///< triangles of the candidate that failed in the last check
  std::vector<Index> OpenOriginal;   ///< the same of the original mesh
  DependentCertificates Dependents;  ///< those of ToAdmitted
};
}

#endif
