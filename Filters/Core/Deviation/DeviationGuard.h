// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_DeviationGuard_h
#define lmo_DeviationGuard_h

#include "Core/Deviation/DeviationBounds.h"
#include "Core/Deviation/TriangleValidity.h"

namespace lmo
{
/// Judges displacements of a mesh's vertices: every point of the moved surface has to stay within a
/// distance of the original one, and every point of the original one within it of the moved one;
/// triangles must not turn bad or fold, and none that was not inverted may turn by more than a
/// right angle from its own original normal or from that of the surface below it. Where the mesh
/// accepted so far is beyond a limit already, it must not get worse.
///
/// Positions change in transactions: any number of vertices are proposed and judged, and proposed
/// and judged again where that fails, until all of them are accepted or rolled back.
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

  /// What Judge() looks for: ALL_FAILURES of many vertices, or the FIRST_FAILURE of few vertices,
  /// with the cheapest tests first.
  using Extent = DeviationCertificates::Extent;
  static constexpr Extent ALL_FAILURES = DeviationCertificates::ALL_FAILURES;
  static constexpr Extent FIRST_FAILURE = DeviationCertificates::FIRST_FAILURE;

  /// Keeps references to the arguments.
  /// \param distance > 0
  /// \throw Cancelled if the monitor says so.
  DeviationGuard(const Points& V, const Triangles& triangles, const MeshTopology& topology,
    double distance, ProgressMonitor& monitor);
  DeviationGuard(const DeviationGuard&) = delete;
  void operator=(const DeviationGuard&) = delete;

  /// The positions accepted so far: those of the original mesh at first.
  const Points& GetAccepted() const { return this->Mesh.accepted; }

  /// t of the accepted triangles.
  const Vector& GetAcceptedQuality() const { return this->Shapes.GetAcceptedQuality(); }

  /// t of the triangles judged last.
  const Vector& GetQuality() const { return this->Shapes.GetQuality(); }

  /// Heights of the original surface over an accepted triangle.
  const HeightRange& GetHeights(Index t) const { return this->Bounds.GetHeights(t); }

  /// Every point of one surface is within this distance of the other, for the positions accepted.
  double GetBound() const { return this->Bounds.GetBound(); }

  /// Number of proofs of distances so far: about proportional to the time spent on them.
  std::int64_t GetEffort() const { return this->Bounds.GetEffort(); }

  /// Proposes a position; the vertex has to be named in the next Judge().
  void Propose(Index vertex, const Vector3& position)
  {
    this->Mesh.candidate.row(vertex) = position;
  }

  /// The cheap part of Judge() for one vertex between two transactions: whether none of its
  /// triangles turns over, folds or is inverted. Not more than a hint.
  bool IsValid(Index vertex, const Vector3& position);

  /// Judges all that has been proposed since the last Accept() or RollBack().
  /// \param vertices for which a position has been proposed since the last call
  /// \param leastQuality t below which that of a triangle must not fall
  /// \return no failures if the proposal may be accepted
  /// \throw Cancelled if the monitor says so; what is accepted remains, and no more can be judged.
  std::vector<Failure> Judge(const std::vector<Index>& vertices, double leastQuality, Extent extent,
    ProgressMonitor& monitor);

  /// Accepts the proposal, in which Judge() found no failure.
  void Accept();

  /// Goes back to the accepted positions.
  void RollBack();

private:
  /// The triangles of the cells at the vertices, each once.
  std::vector<Index> TrianglesAt(const std::vector<Index>& vertices);

  /// Adds what is not in the list yet.
  void AddOnce(const std::vector<Index>& more, std::vector<Index>& list);

  /// Original triangles that have to be judged again, since these triangles have changed.
  std::vector<Index> FindDependent(const std::vector<Index>& triangles, Extent extent);

  /// True if the triangle of the candidate is no valid one.
  bool IsSpoilt(Index t, double leastQuality) const;

  /// Triangles that have not moved, but are inverted since those around them have.
  std::vector<Failure> FindInvertedBeside(
    const std::vector<Index>& vertices, ProgressMonitor& monitor);

  /// Triangles that are far from the original surface or turned against it.
  std::vector<Index> FindAstray(
    const std::vector<Index>& list, Extent extent, ProgressMonitor& monitor);

  void EndTransaction();

  const MeshTopology& Topology;
  const Triangles Neighbours;
  CandidateMesh Mesh;
  TriangleValidity Shapes;
  DeviationBounds Bounds;

  // Of the transaction:
  IndexSet Proposed;               ///< triangles for whose vertices positions have been proposed
  std::vector<Index> Open;         ///< triangles of the candidate that failed in the last call
  std::vector<Index> OpenOriginal; ///< the same of the original mesh

  IndexSet Listed; ///< helps to list triangles once; empty in between
};
}

#endif
