// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_DeviationBounds_h
#define lmo_DeviationBounds_h

#include "Core/Base/IndexSet.h"
#include "Core/Deviation/CandidateMesh.h"
#include "Core/Deviation/ReferenceSurface.h"
#include "Core/Mesh/TriangleGeometry.h"

namespace lmo
{
/// Bounds of the distance between a reference and a candidate for a mesh, in both directions:
/// certificates for each triangle, some of which are carried over small displacements.
class DeviationBounds
{
public:
  using Failure = DeviationCertificates::Failure;
  using Extent = DeviationCertificates::Extent;
  using Postpone = DeviationCertificates::Postpone;

  /// Keeps references to the arguments.
  /// \param reference the mesh itself, with the same list of triangles, or another surface
  /// \param neighbours what FindTriangleNeighbours() returned for the mesh
  /// \param isSettled see PartOfSurface
  /// \param distance that is allowed; what begins farther away may stay as far away as it is
  /// \throw Cancelled if the monitor says so.
  DeviationBounds(const SurfaceView& reference, const CandidateMesh& mesh,
    const Triangles& neighbours, const Mask& isSettled, double distance, ProgressMonitor& monitor);
  DeviationBounds(const DeviationBounds&) = delete;
  void operator=(const DeviationBounds&) = delete;

  /// Says that these triangles of the candidate have changed.
  void Update(const std::vector<Index>& triangles) { this->Tree.Invalidate(triangles); }

  /// The tree of the candidate as it is now.
  const TriangleBvh& GetTree()
  {
    this->Tree.Refit();
    return this->Tree;
  }

  /// Triangles of the reference whose certificates need one of the candidate's triangles.
  /// \param isMarked for these triangles
  std::vector<Index> FindDependent(const Mask& isMarked);

  /// The same of few triangles that are the first to change, from an index that is kept.
  std::vector<Index> FindDependentOfFew(const std::vector<Index>& triangles);

  /// The triangles of the candidate that are not close to the reference.
  /// \param postpone see DeviationCertificates::Check()
  std::vector<Failure> CheckCandidate(
    std::vector<Index> list, Extent extent, const Postpone& postpone, ProgressMonitor& monitor);

  /// The triangles of the reference that are not close to the candidate, while displacements may be
  /// the reason. With MANY_VERTICES, accepted certificates are carried over where they leave enough
  /// of the distance; single displacements would add up in them.
  std::vector<Failure> CheckReference(
    std::vector<Index> list, Extent extent, const Postpone& postpone, ProgressMonitor& monitor);

  /// The reference's triangle over the centre of a triangle of the candidate that was checked.
  Index GetCentre(Index t) const { return this->ToReference.Get(t).seed; }

  /// What the accepted mesh has over a triangle of the reference.
  const DeviationCertificates::Certificate& GetAccepted(Index t) const
  {
    return this->ToAccepted.Get(t);
  }

  Index CountReferenceTriangles() const { return this->ToAccepted.Size(); }

  /// Number of triangles that began beyond the distance, in both directions.
  Index CountBeyond() const { return this->LimitsOfMesh.Count() + this->LimitsOfReference.Count(); }

  /// Unit normal of the reference's triangle over the centre of an accepted one.
  Vector3 NormalBelow(Index t) const
  {
    return ScaledNormal(this->Reference.V, this->Reference.T, this->Overlays[t].centre)
      .stableNormalized();
  }

  /// Heights of the reference over an accepted triangle.
  const HeightRange& GetHeights(Index t) const { return this->Overlays[t].heights; }

  /// Every point of one surface is within this distance of the other, for the positions accepted.
  double GetBound() const;

  /// Of proofs so far, see DeviationCertificates.
  std::int64_t GetEffort() const
  {
    return this->ToReference.GetEffort() + this->ToCandidate.GetEffort();
  }

  /// Accepts these triangles of the candidate, before their positions are, and all certificates.
  void Accept(const std::vector<Index>& triangles);

  /// Goes back to what was accepted, after the positions of these triangles have.
  void RollBack(const std::vector<Index>& triangles);

private:
  /// The reference over an accepted triangle.
  struct Overlay
  {
    Index centre; ///< triangle of the reference over the centre
    HeightRange heights;
  };

  SurfaceView CandidateView() const
  {
    return { this->Mesh.candidate, this->Mesh.T, this->Neighbours };
  }

  /// True if the reference is the mesh as it was before it moved.
  bool IsOfMesh() const { return &this->Reference.T == &this->Mesh.T; }

  /// Certifies where a mesh begins that is not the reference itself.
  void CertifyBeginning(const Mask& isSettled, ProgressMonitor& monitor);

  /// Keeps the accepted certificate of a triangle of the reference, if it needs none that has
  /// moved.
  /// \return whether it is kept
  bool KeepUnmoved(Index t);

  /// Certifies a triangle of the reference by its accepted certificate, if the displacements since
  /// then leave enough of the distance.
  /// \return whether they do
  bool CarryToCandidate(Index t);

  /// The same for a triangle of the candidate.
  bool CarryToReference(Index t);

  /// True if a corner of a triangle that began beyond the distance is farther away than it may be.
  bool HasStrayed(Index t) const;

  const SurfaceView Reference;
  const CandidateMesh& Mesh;
  const Triangles& Neighbours;
  const double Distance;
  DistanceLimits LimitsOfMesh;
  DistanceLimits LimitsOfReference;
  VertexLimits LimitsOfVertices;
  std::vector<Overlay> Overlays;
  TriangleBvh ReferenceTree;
  TriangleBvh Tree;                  ///< of the candidate
  DeviationCertificates ToReference; ///< the candidate's triangles are close to the reference
  DeviationCertificates ToCandidate; ///< and the other way round
  DeviationCertificates ToAccepted;  ///< those of the reference are close to the accepted mesh
  DependentCertificates Dependents;  ///< those of ToAccepted; empty until it is needed
  IndexSet Recertified; ///< the reference's triangles of which ToCandidate knows other certificates
};
}

#endif
