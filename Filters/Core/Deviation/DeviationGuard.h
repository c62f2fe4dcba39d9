// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_DeviationGuard_h
#define lmo_DeviationGuard_h

#include "Core/Deviation/DeviationBounds.h"
#include "Core/Deviation/SelfIntersections.h"
#include "Core/Deviation/TriangleValidity.h"

#include <algorithm>

namespace lmo
{
/// Judges displacements of a mesh's vertices: every point of the moved surface has to stay within a
/// distance of a reference, the original surface or another one, and every point of the reference
/// within it of the moved surface; triangles must not turn bad or fold, and none that was not
/// inverted may turn by more than a right angle from its own original normal or from that of the
/// reference below it; no triangles may meet that did not meet in the original mesh. Where the mesh
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

  /// What Judge() is asked for: a displacement of MANY_VERTICES, or SINGLE_VERTICES, one place
  /// after the other.
  using Extent = DeviationCertificates::Extent;
  static constexpr Extent MANY_VERTICES = DeviationCertificates::MANY_VERTICES;
  static constexpr Extent SINGLE_VERTICES = DeviationCertificates::SINGLE_VERTICES;

  /// The mesh itself is the reference. Keeps references to the arguments.
  /// \param distance > 0
  /// \throw Cancelled if the monitor says so.
  DeviationGuard(const Points& V, const Triangles& triangles, const MeshTopology& topology,
    double distance, ProgressMonitor& monitor);

  /// The same for a mesh that stays near a reference of its own, which has triangles.
  /// \param part what is known if the mesh is a part of a surface
  DeviationGuard(const Points& V, const Triangles& triangles, const MeshTopology& topology,
    const ReferenceSurface& reference, const PartOfSurface& part, double distance,
    ProgressMonitor& monitor);
  DeviationGuard(const DeviationGuard&) = delete;
  void operator=(const DeviationGuard&) = delete;

  /// The positions accepted so far: those of the original mesh at first.
  const Points& GetAccepted() const { return this->Mesh.accepted; }

  /// t of the accepted triangles.
  const Vector& GetAcceptedQuality() const { return this->Shapes.GetAcceptedQuality(); }

  /// t of the triangles judged last.
  const Vector& GetQuality() const { return this->Shapes.GetQuality(); }

  /// Heights of the reference over an accepted triangle.
  const HeightRange& GetHeights(Index t) const { return this->Bounds.GetHeights(t); }

  /// Unit normal of the reference's triangle below the centre of an accepted one.
  Vector3 NormalBelow(Index t) const { return this->Bounds.NormalBelow(t); }

  /// Every point of one surface is within this distance of the other, for the positions accepted.
  double GetBound() const { return this->Bounds.GetBound(); }

  /// Number of triangles that began farther away than the distance: of the mesh from the reference,
  /// and of the reference from the mesh.
  Index CountBeyond() const { return this->Bounds.CountBeyond(); }

  Index CountReferenceTriangles() const { return this->Bounds.CountReferenceTriangles(); }

  /// Between two transactions, the triangles of the reference that have to be judged again if a
  /// vertex moves.
  std::vector<Index> FindDependent(Index vertex)
  {
    return this->FindDependent(this->TrianglesAt({ vertex }), SINGLE_VERTICES);
  }

  /// The pairs of triangles that meet in the original mesh, see SelfIntersections.
  const std::vector<TrianglePair>& GetInputPairs() const { return this->InputPairs; }

  /// Those of them that meet in the accepted one; no others do.
  std::vector<TrianglePair> FindAcceptedPairs() const;

  /// Number of proofs of distances so far: about proportional to the time spent on them.
  std::int64_t GetEffort() const { return this->Bounds.GetEffort(); }

  /// Proposes a position; the vertex has to be named in the next Judge().
  void Propose(Index vertex, const Vector3& position)
  {
    this->Mesh.candidate.row(vertex) = position;
  }

  /// The cheap part of Judge() for one vertex between two transactions: whether none of its
  /// triangles turns over, folds or is inverted. Not more than a hint. Threads may ask for distant
  /// vertices at once.
  bool IsValid(Index vertex, const Vector3& position);

  /// Judges all that has been proposed since the last Accept() or RollBack(), first what is cheap
  /// to find; it looks no further around vertices that are to blame already.
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

  /// Triangles of the reference that have to be judged again, since these triangles have changed.
  std::vector<Index> FindDependent(const std::vector<Index>& triangles, Extent extent);

  /// True if the triangle of the candidate is no valid one.
  bool IsSpoilt(Index t, double leastQuality) const;

  /// Triangles that have not moved, but are inverted since those around them have.
  std::vector<Failure> FindInvertedBeside(
    const std::vector<Index>& vertices, ProgressMonitor& monitor);

  /// Adds the pairs of the candidate's triangles that meet and did not in the original mesh.
  void AddNewPairs(
    const std::vector<Index>& changed, ProgressMonitor& monitor, std::vector<Failure>& failures);

  /// Triangles that are far from the reference or turned against it.
  std::vector<Index> FindAstray(
    const std::vector<Index>& list, Extent extent, ProgressMonitor& monitor);

  /// Adds triangles that failed, if they have moved.
  void AddOpen(const std::vector<Index>& list, std::vector<Failure>& failures);

  /// Lists the vertices that failures are to be blamed on.
  void Blame(const std::vector<Failure>& failures);

  /// Leaves triangles of a list to the next call whose vertices are to blame for failures already,
  /// and have to move again.
  void Postpone(const std::vector<Failure>& failures, std::vector<Index>& list);

  /// The same for triangles of the reference, whose certificates need such triangles.
  void PostponeOfReference(const std::vector<Failure>& failures, std::vector<Index>& list);

  /// True if a corner of a triangle is among the vertices to blame.
  bool IsAtBlamed(Index t) const;

  /// The triangles of the reference that are far from the candidate.
  std::vector<Failure> CheckReference(
    const std::vector<Index>& list, Extent extent, ProgressMonitor& monitor);

  void EndTransaction();

  const MeshTopology& Topology;
  const Triangles Neighbours;
  const Triangles ReferenceNeighbours; ///< no rows if the reference is the mesh itself
  CandidateMesh Mesh;
  DeviationBounds Bounds;
  TriangleValidity Shapes;
  SelfIntersections Intersections;
  const std::vector<TrianglePair> InputPairs;

  // Of the transaction:
  IndexSet Proposed;                ///< triangles for whose vertices positions have been proposed
  std::vector<Index> Open;          ///< triangles of the candidate that the last call did not pass
  std::vector<Index> OpenReference; ///< the same of the reference

  // To list triangles and vertices once; empty in between:
  IndexSet Listed;
  IndexSet ListedOfReference;
  IndexSet ListedVertices;
  IndexSet Blamed; ///< vertices
};

/// Calls blame(i) for the vertices that failures are to be blamed on, some of them several times.
/// \param isMoving true for the vertices i that have moved
template <typename IsMoving, typename Blame>
void ForEachToBlame(const std::vector<DeviationGuard::Failure>& failures,
  const Triangles& triangles, const IsMoving& isMoving, const Blame& blame)
{
  const auto blameCorners = [&](Index t)
  {
    bool anyMoves = false;
    for (const Index i : triangles.row(t))
    {
      if (isMoving(i))
      {
        anyMoves = true;
        blame(i);
      }
    }
    return anyMoves;
  };
  for (const DeviationGuard::Failure& failure : failures)
  {
    if (!blameCorners(failure.close))
    {
      std::for_each(failure.others.begin(), failure.others.end(), blameCorners);
    }
  }
}
}

#endif
