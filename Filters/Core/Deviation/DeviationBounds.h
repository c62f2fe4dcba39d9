// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_DeviationBounds_h
#define lmo_DeviationBounds_h

#include "Core/Deviation/CandidateMesh.h"
#include "Core/Deviation/DeviationCertificates.h"
#include "Core/Deviation/IndexSet.h"

namespace lmo
{
/// Bounds of the distance between a mesh and a candidate for it, in both directions: certificates
/// for each triangle, some of which are carried over small displacements.
class DeviationBounds
{
public:
  using Failure = DeviationCertificates::Failure;
  using Extent = DeviationCertificates::Extent;

  /// Keeps references to the arguments.
  /// \param original positions
  /// \param mesh with the original positions at first
  /// \param neighbours what FindTriangleNeighbours() returned
  /// \param distance that is allowed
  /// \throw Cancelled if the monitor says so.
  DeviationBounds(const Points& original, const CandidateMesh& mesh, const Triangles& neighbours,
    double distance, ProgressMonitor& monitor);
  DeviationBounds(const DeviationBounds&) = delete;
  void operator=(const DeviationBounds&) = delete;

  /// Says that these triangles of the candidate have changed.
  void Update(const std::vector<Index>& triangles) { this->Tree.Invalidate(triangles); }

  /// Original triangles whose certificates need one of the candidate's triangles.
  /// \param isMarked for these triangles
  std::vector<Index> FindDependent(const Mask& isMarked);

  /// The same of few triangles that are the first to change, from an index that is kept.
  std::vector<Index> FindDependentOfFew(const std::vector<Index>& triangles);

  /// The triangles of the candidate that are not close to the original surface.
  std::vector<Failure> CheckCandidate(
    std::vector<Index> list, Extent extent, ProgressMonitor& monitor);

  /// The original triangles that are not close to the candidate, while displacements may be the
  /// reason. With ALL_FAILURES, accepted certificates are carried over where they leave enough of
  /// the distance; single displacements would add up in them.
  std::vector<Failure> CheckOriginal(
    std::vector<Index> list, Extent extent, ProgressMonitor& monitor);

  /// The original triangle over the centre of a triangle of the candidate that was checked.
  Index GetCentre(Index t) const { return this->ToOriginal.Get(t).seed; }

  /// The candidate's triangles that the accepted certificate of an original triangle needs.
  const std::vector<Index>& GetUsed(Index t) const { return this->ToAccepted.Get(t).used; }

  /// Heights of the original surface over an accepted triangle.
  const HeightRange& GetHeights(Index t) const { return this->Overlays[t].heights; }

  /// Every point of one surface is within this distance of the other, for the positions accepted.
  double GetBound() const;

  /// Of proofs so far, see DeviationCertificates.
  std::int64_t GetEffort() const
  {
    return this->ToOriginal.GetEffort() + this->ToCandidate.GetEffort();
  }

  /// Accepts these triangles of the candidate, before their positions are, and all certificates.
  void Accept(const std::vector<Index>& triangles);

  /// Goes back to what was accepted, after the positions of these triangles have.
  void RollBack(const std::vector<Index>& triangles);

private:
  /// The original surface over an accepted triangle.
  struct Overlay
  {
    Index centre; ///< original triangle over the centre
    HeightRange heights;
  };

  SurfaceView OriginalView() const { return { this->Original, this->Mesh.T, this->Neighbours }; }
  SurfaceView CandidateView() const
  {
    return { this->Mesh.candidate, this->Mesh.T, this->Neighbours };
  }

  /// Keeps the accepted certificate of an original triangle, if it needs none that has moved.
  /// \return whether it is kept
  bool KeepUnmoved(Index t);

  /// Certifies an original triangle by its accepted certificate, if the displacements since then
  /// leave enough of the distance.
  /// \return whether they do
  bool CarryToCandidate(Index t);

  /// The same for a triangle of the candidate.
  bool CarryToOriginal(Index t);

  const Points& Original;
  const CandidateMesh& Mesh;
  const Triangles& Neighbours;
  const double Distance;
  std::vector<Overlay> Overlays;
  TriangleBvh OriginalTree;
  TriangleBvh Tree;                  ///< of the candidate
  DeviationCertificates ToOriginal;  ///< the candidate's triangles are close to the original mesh
  DeviationCertificates ToCandidate; ///< and the other way round
  DeviationCertificates ToAccepted;  ///< the original triangles are close to the accepted mesh
  DependentCertificates Dependents;  ///< those of ToAccepted; empty until it is needed
  IndexSet Recertified; ///< original triangles that ToCandidate knows other certificates of
};
}

#endif
