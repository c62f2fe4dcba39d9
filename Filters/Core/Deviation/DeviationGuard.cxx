// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Deviation/DeviationGuard.h"

#include "Core/Base/Split.h"
#include "Core/Mesh/TriangleNeighbours.h"
#include "Core/Mesh/TriangleSeparation.h"

#include <algorithm>

namespace lmo
{
namespace
{
/// Share of the distance that round-off may not use.
constexpr double Margin = 1e-6;

template <typename Value>
void Append(const std::vector<Value>& more, std::vector<Value>& list)
{
  list.insert(list.end(), more.begin(), more.end());
}

/// Adds what is not in the list yet.
/// \param listed an empty set
void AddOnce(const std::vector<Index>& more, std::vector<Index>& list, IndexSet& listed)
{
  listed.Add(list);
  listed.Add(more);
  list = listed.Get();
  listed.Clear();
}
}

DeviationGuard::DeviationGuard(const Points& V, const Triangles& triangles,
  const MeshTopology& topology, double distance, ProgressMonitor& monitor)
  : DeviationGuard(V, triangles, topology, { V, triangles, topology }, {}, distance, monitor)
{
}

DeviationGuard::DeviationGuard(const Points& V, const Triangles& triangles,
  const MeshTopology& topology, const ReferenceSurface& reference, const PartOfSurface& part,
  double distance, ProgressMonitor& monitor)
  : Topology(topology)
  , Neighbours(FindTriangleNeighbours(triangles, topology))
  , ReferenceNeighbours(&reference.T == &triangles
                          ? Triangles()
                          : FindTriangleNeighbours(reference.T, reference.topology))
  , Mesh{ triangles, V, V }
  , Bounds({ reference.V, reference.T,
             &reference.T == &triangles ? this->Neighbours : this->ReferenceNeighbours },
      this->Mesh, this->Neighbours, part.isSettled, (1 - Margin) * distance, monitor)
  , Shapes(this->Mesh.accepted, this->Mesh.candidate, triangles, topology, this->Neighbours,
      NormalsToKeep(part.original.rows() > 0 ? part.original : V, triangles, topology),
      SmoothedNormals(reference.V, reference.T, reference.topology))
  , Intersections(triangles, topology)
  , InputPairs(this->Intersections.FindAll(V, this->Bounds.GetTree(), monitor))
  , Proposed(static_cast<Index>(triangles.rows()))
  , Listed(static_cast<Index>(triangles.rows()))
  , ListedOfReference(static_cast<Index>(reference.T.rows()))
  , ListedVertices(topology.vertices)
  , Blamed(topology.vertices)
{
  ParallelFor(static_cast<Index>(triangles.rows()),
    [this](Index t) { this->Shapes.Accept(t, this->Bounds.GetCentre(t)); });
  monitor.Report(0);
}

std::vector<Index> DeviationGuard::TrianglesAt(const std::vector<Index>& vertices)
{
  for (const Index i : vertices)
  {
    ForEachTriangleOfCellsAt(this->Topology.cornersAt, this->Topology.polygons, i,
      [this](Index t) { this->Listed.Add(t); });
  }
  std::vector<Index> triangles = this->Listed.Get();
  this->Listed.Clear();
  return triangles;
}

std::vector<Index> DeviationGuard::FindDependent(const std::vector<Index>& triangles, Extent extent)
{
  if (extent == SINGLE_VERTICES)
  {
    return this->Bounds.FindDependentOfFew(triangles);
  }
  this->Listed.Add(triangles);
  std::vector<Index> dependent = this->Bounds.FindDependent(this->Listed.GetMask());
  this->Listed.Clear();
  return dependent;
}

std::vector<DeviationGuard::Failure> DeviationGuard::FindInvertedBeside(
  const std::vector<Index>& vertices, ProgressMonitor& monitor)
{
  for (const Index t : this->TrianglesAt(vertices))
  {
    this->ListedVertices.Add(this->Mesh.T(t, 0));
    this->ListedVertices.Add(this->Mesh.T(t, 1));
    this->ListedVertices.Add(this->Mesh.T(t, 2));
  }
  std::vector<Index> beside = this->TrianglesAt(this->ListedVertices.Get());
  this->ListedVertices.Clear();
  std::vector<Failure> failures;
  for (const Index t : Split(beside, monitor,
         [this](Index t) { return !this->Mesh.IsMoved(t) && this->Shapes.IsInverted(t); }))
  {
    const Triangles& T = this->Mesh.T;
    failures.push_back({ t, this->TrianglesAt({ T(t, 0), T(t, 1), T(t, 2) }) });
  }
  return failures;
}

void DeviationGuard::AddNewPairs(
  const std::vector<Index>& changed, ProgressMonitor& monitor, std::vector<Failure>& failures)
{
  for (const TrianglePair& pair :
    this->Intersections.Find(this->Mesh.candidate, changed, this->Bounds.GetTree(), monitor))
  {
    if (!std::binary_search(this->InputPairs.begin(), this->InputPairs.end(), pair))
    {
      failures.push_back({ pair.first, { pair.second } });
      failures.push_back({ pair.second, { pair.first } });
    }
  }
}

std::vector<TrianglePair> DeviationGuard::FindAcceptedPairs() const
{
  std::vector<TrianglePair> pairs;
  std::copy_if(this->InputPairs.begin(), this->InputPairs.end(), std::back_inserter(pairs),
    [this](const TrianglePair& pair)
    { return !AreSeparate(this->Mesh.accepted, this->Mesh.T, pair.first, pair.second); });
  return pairs;
}

std::vector<Index> DeviationGuard::FindAstray(
  const std::vector<Index>& list, Extent extent, ProgressMonitor& monitor)
{
  std::vector<Index> astray;
  const auto postpone = [this](const auto& failed, std::vector<Index>& open)
  {
    std::vector<Failure> failures;
    failures.reserve(failed.size());
    for (const DeviationBounds::Failure& failure : failed)
    {
      failures.push_back({ failure.triangle, {} });
    }
    this->Postpone(failures, open);
  };
  for (const auto& failure : this->Bounds.CheckCandidate(list, extent, postpone, monitor))
  {
    astray.push_back(failure.triangle);
  }
  std::vector<Index> straight = list;
  Append(Split(straight, monitor,
           [this](Index t) { return this->Shapes.IsTurned(t, this->Bounds.GetCentre(t)); }),
    astray);
  return astray;
}

std::vector<DeviationGuard::Failure> DeviationGuard::CheckReference(
  const std::vector<Index>& list, Extent extent, ProgressMonitor& monitor)
{
  const auto toFailures = [this](const std::vector<DeviationBounds::Failure>& failed)
  {
    std::vector<Failure> failures;
    failures.reserve(failed.size());
    for (const auto& [triangle, close] : failed)
    {
      const DeviationCertificates::Certificate& accepted = this->Bounds.GetAccepted(triangle);
      failures.push_back({ close < 0 ? accepted.seed : close, accepted.used });
    }
    return failures;
  };
  const auto postpone = [&](const auto& failed, std::vector<Index>& open)
  { this->PostponeOfReference(toFailures(failed), open); };
  const std::vector<DeviationBounds::Failure> failed =
    this->Bounds.CheckReference(list, extent, postpone, monitor);
  for (const DeviationBounds::Failure& failure : failed)
  {
    this->OpenReference.push_back(failure.triangle);
  }
  return toFailures(failed);
}

bool DeviationGuard::IsSpoilt(Index t, double leastQuality) const
{
  return this->Shapes.IsBad(t, leastQuality) || this->Shapes.IsTurnedOver(t) ||
         this->Shapes.IsFolded(t) || this->Shapes.IsInverted(t);
}

void DeviationGuard::AddOpen(const std::vector<Index>& list, std::vector<Failure>& failures)
{
  for (const Index t : list)
  {
    if (this->Mesh.IsMoved(t))
    {
      this->Open.push_back(t);
      failures.push_back({ t, {} });
    }
  }
}

void DeviationGuard::Blame(const std::vector<Failure>& failures)
{
  this->Blamed.Clear();
  ForEachToBlame(
    failures, this->Mesh.T,
    [this](Index i) { return this->Mesh.candidate.row(i) != this->Mesh.accepted.row(i); },
    [this](Index i) { this->Blamed.Add(i); });
}

void DeviationGuard::Postpone(const std::vector<Failure>& failures, std::vector<Index>& list)
{
  this->Blame(failures);
  ProgressMonitor unwatched;
  Append(Split(list, unwatched, [this](Index t) { return this->IsAtBlamed(t); }), this->Open);
}

void DeviationGuard::PostponeOfReference(
  const std::vector<Failure>& failures, std::vector<Index>& list)
{
  this->Blame(failures);
  ProgressMonitor unwatched;
  const auto isPostponed = [this](Index t)
  {
    const std::vector<Index>& used = this->Bounds.GetAccepted(t).used;
    return std::any_of(used.begin(), used.end(), [this](Index u) { return this->IsAtBlamed(u); });
  };
  Append(Split(list, unwatched, isPostponed), this->OpenReference);
}

bool DeviationGuard::IsAtBlamed(Index t) const
{
  const auto corners = this->Mesh.T.row(t);
  return std::any_of(
    corners.begin(), corners.end(), [this](Index i) { return this->Blamed.GetMask()[i]; });
}

std::vector<DeviationGuard::Failure> DeviationGuard::Judge(
  const std::vector<Index>& vertices, double leastQuality, Extent extent, ProgressMonitor& monitor)
{
  std::vector<Index> changed = this->TrianglesAt(vertices);
  std::vector<Index> below = this->FindDependent(changed, extent);
  this->Proposed.Add(changed);
  this->Bounds.Update(changed);
  this->Shapes.Update(changed);
  AddOnce(this->Open, changed, this->Listed); // what failed in the last call is judged again
  AddOnce(this->OpenReference, below, this->ListedOfReference);
  this->Open.clear();
  this->OpenReference.clear();

  // What has not moved is accepted already, its neighbours are to blame for a fold between them;
  // but it may have moved back in the way of others.
  std::vector<Failure> failures = this->FindInvertedBeside(vertices, monitor);
  this->AddOpen(
    Split(changed, monitor,
      [&](Index t) { return this->Mesh.IsMoved(t) && this->IsSpoilt(t, leastQuality); }),
    failures);
  this->AddNewPairs(changed, monitor, failures);
  this->Postpone(failures, changed);
  this->AddOpen(this->FindAstray(changed, extent, monitor), failures);
  this->PostponeOfReference(failures, below);
  Append(this->CheckReference(below, extent, monitor), failures);
  return failures;
}

bool DeviationGuard::IsValid(Index vertex, const Vector3& position)
{
  std::vector<Index> changed;
  ForEachTriangleOfCellsAt(this->Topology.cornersAt, this->Topology.polygons, vertex,
    [&](Index t) { changed.push_back(t); });
  this->Propose(vertex, position);
  this->Shapes.Update(changed);
  const bool isValid =
    std::none_of(changed.begin(), changed.end(), [this](Index t) { return this->IsSpoilt(t, 0); });
  this->Propose(vertex, this->Mesh.accepted.row(vertex));
  this->Shapes.RollBack(changed);
  return isValid;
}

void DeviationGuard::Accept()
{
  const std::vector<Index>& proposed = this->Proposed.Get();
  this->Bounds.Accept(proposed);
  ParallelFor(static_cast<Index>(proposed.size()),
    [&](Index k)
    {
      const Index t = proposed[k];
      if (this->Mesh.IsMoved(t))
      {
        this->Shapes.Accept(t, this->Bounds.GetCentre(t));
      }
      this->Shapes.AcceptQuality(t);
    });
  CandidateMesh::Copy(proposed, this->Mesh.T, this->Mesh.candidate, this->Mesh.accepted);
  this->EndTransaction();
}

void DeviationGuard::RollBack()
{
  const std::vector<Index>& proposed = this->Proposed.Get();
  CandidateMesh::Copy(proposed, this->Mesh.T, this->Mesh.accepted, this->Mesh.candidate);
  this->Bounds.RollBack(proposed);
  this->Shapes.RollBack(proposed);
  this->EndTransaction();
}

void DeviationGuard::EndTransaction()
{
  this->Proposed.Clear();
  this->Open.clear();
  this->OpenReference.clear();
}
}
