// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Deviation/DeviationGuard.h"

#include "Core/Base/Threading.h"
#include "Core/Mesh/TriangleGeometry.h"

#include <algorithm>
#include <cmath>

namespace lmo
{
namespace
{
/// Share of the distance up to which heights over the original surface may be rough.
constexpr double CarriedShare = 0.5;

/// Share of the distance that round-off may not use.
constexpr double Margin = 1e-6;

void AddOnce(Index t, Mask& isListed, std::vector<Index>& list)
{
  if (!isListed[t])
  {
    isListed[t] = true;
    list.push_back(t);
  }
}

void AddOnce(const std::vector<Index>& more, Mask& isListed, std::vector<Index>& list)
{
  for (const Index t : more)
  {
    AddOnce(t, isListed, list);
  }
}

void AddOnce(const std::vector<Index>& more, Mask& isListed)
{
  for (const Index t : more)
  {
    isListed[t] = true;
  }
}
}

DeviationGuard::DeviationGuard(const Points& V, const Triangles& triangles,
  const MeshTopology& topology, double distance, ProgressMonitor& monitor)
  : Original(V)
  , T(triangles)
  , Topology(topology)
  , Distance((1 - Margin) * distance)
  , Neighbours(FindTriangleNeighbours(triangles, topology))
  , Admitted(V)
  , Candidate(V)
  , Shapes(this->Admitted, this->Candidate, triangles, topology, this->Neighbours)
  , AdmittedHeights(triangles.rows())
  , OriginalTree(this->Original, triangles, monitor)
  , Tree(this->Candidate, this->OriginalTree)
  , ToOriginal(static_cast<Index>(triangles.rows()))
  , ToCandidate(static_cast<Index>(triangles.rows()))
  , ToAdmitted(this->ToCandidate)
{
  monitor.Report(0);
}

std::vector<Index> DeviationGuard::TrianglesAt(const std::vector<Index>& vertices) const
{
  std::vector<Index> triangles;
  for (const Index i : vertices)
  {
    const AdjacencyLists& cornersAt = this->Topology.cornersAt;
    for (const Index* corner = cornersAt.Begin(i); corner != cornersAt.End(i); ++corner)
    {
      triangles.push_back(*corner / 3);
    }
  }
  std::sort(triangles.begin(), triangles.end());
  triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
  return triangles;
}

bool DeviationGuard::IsMoved(Index t) const
{
  return this->Candidate.row(this->T(t, 0)) != this->Admitted.row(this->T(t, 0)) ||
         this->Candidate.row(this->T(t, 1)) != this->Admitted.row(this->T(t, 1)) ||
         this->Candidate.row(this->T(t, 2)) != this->Admitted.row(this->T(t, 2));
}

template <typename IsBeyond>
std::vector<Index> DeviationGuard::Split(
  std::vector<Index>& list, ProgressMonitor& monitor, const IsBeyond& isBeyond)
{
  Mask areBeyond(list.size());
  InterruptibleFor(
    static_cast<Index>(list.size()), monitor, [&](Index k) { areBeyond[k] = isBeyond(list[k]); });
  std::vector<Index> beyond;
  std::vector<Index> others;
  for (std::size_t k = 0; k < list.size(); ++k)
  {
    (areBeyond[k] ? beyond : others).push_back(list[k]);
  }
  list = std::move(others);
  return beyond;
}

std::vector<Index> DeviationGuard::FindAstray(
  const std::vector<Index>& list, ProgressMonitor& monitor)
{
  std::vector<Index> astray;
  std::vector<Index> open = list;
  Split(open, monitor, [this](Index t) { return this->CarryToOriginal(t); });
  for (const DeviationCertificates::Failure& failure : this->ToOriginal.Check(
         open, this->Candidate, this->OriginalView(), this->OriginalTree, this->Distance, monitor))
  {
    astray.push_back(failure.triangle);
  }
  std::copy_if(list.begin(), list.end(), std::back_inserter(astray),
    [this](Index t) { return this->Shapes.IsTurned(t, this->ToOriginal.Get(t).seed); });
  return astray;
}

double DeviationGuard::MotionOf(Index t) const
{
  double farthest = 0;
  for (const Index i : { this->T(t, 0), this->T(t, 1), this->T(t, 2) })
  {
    const Vector3 motion = this->Candidate.row(i) - this->Admitted.row(i);
    farthest = std::max(farthest, motion.squaredNorm());
  }
  return std::sqrt(farthest);
}

bool DeviationGuard::CarryToCandidate(Index t)
{
  const DeviationCertificates::Certificate& admitted = this->ToAdmitted.Get(t);
  double farthest = 0;
  for (const Index u : admitted.used)
  {
    farthest = std::max(farthest, this->MotionOf(u));
  }
  const HeightRange heights = admitted.heights.WidenedBy(farthest);
  if (!(heights.Largest() <= this->Distance))
  {
    return false;
  }
  this->ToCandidate.Set(t, { admitted.seed, heights, admitted.used });
  return true;
}

bool DeviationGuard::CarryToOriginal(Index t)
{
  const HeightRange heights = this->AdmittedHeights[t].WidenedBy(this->MotionOf(t));
  if (!(heights.Largest() <= CarriedShare * this->Distance))
  {
    return false;
  }
  const Index below = OverlayBound().FindCentre(
    CornersOf(this->Candidate, this->T, t), this->OriginalView(), this->ToOriginal.Get(t).seed);
  if (below < 0)
  {
    return false;
  }
  this->ToOriginal.Set(t, { below, heights, { below } });
  return true;
}

std::vector<DeviationGuard::Failure> DeviationGuard::Check(
  const std::vector<Index>& vertices, double leastQuality, ProgressMonitor& monitor)
{
  this->Tree.Invalidate();
  std::vector<Index> changed;
  Mask isListed(this->T.rows(), false);
  const AdjacencyLists& cornersAt = this->Topology.cornersAt;
  for (const Index i : vertices)
  {
    std::for_each(cornersAt.Begin(i), cornersAt.End(i),
      [&](Index corner) { AddOnce(corner / 3, isListed, changed); });
  }
  std::vector<Index> originals = this->ToCandidate.FindDependent(isListed);
  AddOnce(this->Open, isListed, changed);
  isListed.assign(isListed.size(), false);
  AddOnce(originals, isListed);
  AddOnce(this->OpenOriginal, isListed, originals);

  this->Shapes.Update(changed);
  std::vector<Index> bad = Split(changed, monitor,
    [&](Index t)
    {
      return this->Shapes.IsBad(t, leastQuality) || this->Shapes.IsFolded(t) ||
             this->Shapes.IsInverted(t);
    });
  const std::vector<Index> astray = this->FindAstray(changed, monitor);
  bad.insert(bad.end(), astray.begin(), astray.end());
  // What has not moved is admitted already; its neighbours are to blame for a fold between them.
  this->Open = Split(bad, monitor, [this](Index t) { return this->IsMoved(t); });

  std::vector<Failure> failures;
  for (const Index t : this->Open)
  {
    failures.push_back({ t, {} });
  }
  Split(originals, monitor, [this](Index t) { return this->CarryToCandidate(t); });
  this->OpenOriginal.clear();
  for (const DeviationCertificates::Failure& failure : this->ToCandidate.Check(
         originals, this->Original, this->CandidateView(), this->Tree, this->Distance, monitor))
  {
    const DeviationCertificates::Certificate& admitted = this->ToAdmitted.Get(failure.triangle);
    const std::vector<Index>& used = admitted.used;
    if (std::any_of(used.begin(), used.end(), [this](Index t) { return this->IsMoved(t); }))
    {
      this->OpenOriginal.push_back(failure.triangle);
      failures.push_back({ failure.close < 0 ? failure.triangle : failure.close, used });
    }
    else
    {
      this->ToCandidate.Set(failure.triangle, admitted);
    }
  }
  return failures;
}

void DeviationGuard::AdmitTriangle(Index t)
{
  this->Shapes.Admit(t, this->ToOriginal.Get(t).seed);
  this->AdmittedHeights[t] = this->ToOriginal.Get(t).heights;
}

void DeviationGuard::Admit()
{
  ParallelFor(static_cast<Index>(this->T.rows()),
    [this](Index t)
    {
      if (this->IsMoved(
            t)) // else the certificate at hand may be one of a position that was taken back
      {
        this->AdmitTriangle(t);
      }
    });
  this->Admitted = this->Candidate;
  this->ToAdmitted.Assign(this->ToCandidate);
  this->Dependents.Clear();
}

void DeviationGuard::Reject()
{
  this->Candidate = this->Admitted;
  this->ToCandidate.Assign(this->ToAdmitted);
  this->Tree.Invalidate();
  this->Open.clear();
  this->OpenOriginal.clear();
  this->Shapes.Reject();
}

double DeviationGuard::GetBound() const
{
  double bound = this->ToAdmitted.GetBound();
  for (const HeightRange& heights : this->AdmittedHeights)
  {
    bound = std::max(bound, heights.Largest());
  }
  return bound;
}

bool DeviationGuard::TryMove(Index vertex, const Vector3& position)
{
  if (this->Dependents.IsEmpty())
  {
    this->Tree.Refit();
    this->Dependents.Build(this->ToAdmitted);
  }
  const std::vector<Index> changed = this->TrianglesAt({ vertex });
  const AdjacencyLists& rings = this->Topology.oneRings;
  const std::vector<Index> neighbours =
    this->TrianglesAt({ rings.Begin(vertex), rings.End(vertex) });
  this->Move(vertex, position);
  this->Shapes.Update(changed);
  ProgressMonitor unwatched;
  std::vector<DeviationCertificates::Certificate> certificates;
  certificates.reserve(changed.size());
  for (const Index t : changed)
  {
    certificates.push_back(this->ToOriginal.Get(t));
  }
  std::vector<Index> originals;
  bool isAdmitted =
    std::none_of(changed.begin(), changed.end(),
      [this](Index t) { return this->Shapes.IsFolded(t) || this->Shapes.IsInverted(t); }) &&
    std::none_of(neighbours.begin(), neighbours.end(),
      [this](Index t) { return this->Shapes.IsInverted(t); }) &&
    this->FindAstray(changed, unwatched).empty();
  if (isAdmitted)
  {
    originals = this->Dependents.Find(changed);
    this->Tree.Refit(changed);
    isAdmitted = this->ToCandidate
                   .Check(originals, this->Original, this->CandidateView(), this->Tree,
                     this->Distance, unwatched)
                   .empty();
  }
  if (isAdmitted)
  {
    this->Admitted.row(vertex) = position;
    for (const Index t : changed)
    {
      this->AdmitTriangle(t);
    }
    for (const Index t : originals)
    {
      this->ToAdmitted.Set(t, this->ToCandidate.Get(t));
      this->Dependents.Add(t, this->ToAdmitted.Get(t));
    }
    return true;
  }
  this->Move(vertex, this->Admitted.row(vertex));
  this->Shapes.Update(changed);
  for (std::size_t k = 0; k < changed.size(); ++k)
  {
    this->ToOriginal.Set(changed[k], certificates[k]);
  }
  for (const Index t : originals)
  {
    this->ToCandidate.Set(t, this->ToAdmitted.Get(t));
  }
  this->Tree.Refit(changed);
  return false;
}
}
