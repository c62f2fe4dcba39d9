// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Deviation/DeviationBounds.h"

#include "Core/Base/Split.h"
#include "Core/Base/Threading.h"
#include "Core/Mesh/TriangleGeometry.h"

#include <algorithm>

namespace lmo
{
namespace
{
/// Share of the distance up to which heights over the reference may be rough.
constexpr double CarriedShare = 0.5;
}

DeviationBounds::DeviationBounds(const SurfaceView& reference, const CandidateMesh& mesh,
  const Triangles& neighbours, const Mask& isSettled, double distance, ProgressMonitor& monitor)
  : Reference(reference)
  , Mesh(mesh)
  , Neighbours(neighbours)
  , Distance(distance)
  , LimitsOfMesh(distance, static_cast<Index>(mesh.T.rows()))
  , LimitsOfReference(distance, static_cast<Index>(reference.T.rows()))
  , Overlays(mesh.T.rows())
  , ReferenceTree(reference.V, reference.T, monitor)
  , Tree(this->IsOfMesh() ? TriangleBvh(mesh.candidate, this->ReferenceTree)
                          : TriangleBvh(mesh.candidate, mesh.T, monitor))
  , ToReference(static_cast<Index>(mesh.T.rows()), DeviationCertificates::BOUNDS)
  , ToCandidate(static_cast<Index>(reference.T.rows()), DeviationCertificates::BOUNDS_AND_USED)
  , ToAccepted(this->ToCandidate)
  , Recertified(static_cast<Index>(reference.T.rows()))
{
  if (!this->IsOfMesh())
  {
    this->CertifyBeginning(isSettled, monitor);
  }
  ParallelFor(static_cast<Index>(mesh.T.rows()),
    [this](Index t) {
      this->Overlays[t] = { this->GetCentre(t), this->ToReference.Get(t).heights };
    });
}

void DeviationBounds::CertifyBeginning(const Mask& isSettled, ProgressMonitor& monitor)
{
  const SurfaceView mesh = this->CandidateView();
  this->ToReference = DeviationCertificates(
    FindSeeds(mesh, this->ReferenceTree, monitor), DeviationCertificates::BOUNDS);
  this->LimitsOfMesh = CertifyInput(this->ToReference, mesh, isSettled, this->Reference,
    this->ReferenceTree, this->Distance, monitor);
  this->ToCandidate = DeviationCertificates(
    FindSeeds(this->Reference, this->Tree, monitor), DeviationCertificates::BOUNDS_AND_USED);
  this->LimitsOfReference =
    CertifyInput(this->ToCandidate, this->Reference, {}, mesh, this->Tree, this->Distance, monitor);
  this->ToAccepted = this->ToCandidate;
  this->LimitsOfVertices =
    VertexLimits(this->Mesh.candidate, this->ReferenceTree, this->Distance, monitor);
}

std::vector<Index> DeviationBounds::FindDependent(const Mask& isMarked)
{
  this->Dependents.Clear();
  return this->ToCandidate.FindDependent(isMarked);
}

std::vector<Index> DeviationBounds::FindDependentOfFew(const std::vector<Index>& triangles)
{
  if (this->Dependents.IsEmpty())
  {
    this->Dependents.Build(this->ToAccepted, static_cast<Index>(this->Mesh.T.rows()));
  }
  return this->Dependents.Find(triangles);
}

std::vector<DeviationBounds::Failure> DeviationBounds::CheckCandidate(
  std::vector<Index> list, Extent extent, const Postpone& postpone, ProgressMonitor& monitor)
{
  Split(list, monitor, [this](Index t) { return this->CarryToReference(t); });
  std::vector<Failure> failures = this->ToReference.Check(list, this->CandidateView(),
    this->Reference, this->ReferenceTree, this->LimitsOfMesh, extent, postpone, monitor);
  for (const Index t : Split(list, monitor, [this](Index t) { return this->HasStrayed(t); }))
  {
    failures.push_back({ t, this->GetCentre(t) });
  }
  return failures;
}

bool DeviationBounds::HasStrayed(Index t) const
{
  bool hasStrayed = false;
  for (int k = 0; k < 3 && this->LimitsOfMesh.IsRaised(t) && !hasStrayed; ++k)
  {
    const Index i = this->Mesh.T(t, k);
    hasStrayed =
      this->LimitsOfVertices.IsExceeded(i, this->Mesh.candidate.row(i), this->ReferenceTree);
  }
  return hasStrayed;
}

bool DeviationBounds::KeepUnmoved(Index t)
{
  const DeviationCertificates::Certificate& accepted = this->ToAccepted.Get(t);
  if (std::any_of(accepted.used.begin(), accepted.used.end(),
        [this](Index u) { return this->Mesh.IsMoved(u); }))
  {
    return false;
  }
  this->ToCandidate.Set(t, accepted);
  return true;
}

std::vector<DeviationBounds::Failure> DeviationBounds::CheckReference(
  std::vector<Index> list, Extent extent, const Postpone& postpone, ProgressMonitor& monitor)
{
  this->Recertified.Add(list);
  if (extent == DeviationCertificates::MANY_VERTICES)
  {
    Split(list, monitor, [this](Index t) { return this->CarryToCandidate(t); });
  }
  else
  {
    Split(list, monitor, [this](Index t) { return this->KeepUnmoved(t); });
  }
  std::vector<Failure> failures = this->ToCandidate.Check(list, this->Reference,
    this->CandidateView(), this->Tree, this->LimitsOfReference, extent, postpone, monitor);
  failures.erase(std::remove_if(failures.begin(), failures.end(),
                   [this](const Failure& failure) { return this->KeepUnmoved(failure.triangle); }),
    failures.end());
  return failures;
}

bool DeviationBounds::CarryToCandidate(Index t)
{
  const DeviationCertificates::Certificate& accepted = this->ToAccepted.Get(t);
  double largest = 0;
  for (const Index u : accepted.used)
  {
    largest = std::max(largest, this->Mesh.LargestDisplacement(u));
  }
  const HeightRange heights = accepted.heights.WidenedBy(largest);
  if (!(heights.Largest() <= this->LimitsOfReference(t)))
  {
    return false;
  }
  this->ToCandidate.Set(t, { accepted.seed, heights, accepted.used });
  return true;
}

bool DeviationBounds::CarryToReference(Index t)
{
  const HeightRange heights =
    this->Overlays[t].heights.WidenedBy(this->Mesh.LargestDisplacement(t));
  if (!(heights.Largest() <= CarriedShare * this->Distance))
  {
    return false;
  }
  const Index centre = OverlayBound().FindCentre(
    CornersOf(this->Mesh.candidate, this->Mesh.T, t), this->Reference, this->GetCentre(t));
  if (centre < 0)
  {
    return false;
  }
  this->ToReference.Set(t, { centre, heights, {} });
  return true;
}

double DeviationBounds::GetBound() const
{
  double bound = this->ToAccepted.GetBound();
  for (const Overlay& overlay : this->Overlays)
  {
    bound = std::max(bound, overlay.heights.Largest());
  }
  return bound;
}

void DeviationBounds::Accept(const std::vector<Index>& triangles)
{
  ParallelFor(static_cast<Index>(triangles.size()),
    [&](Index k)
    {
      const Index t = triangles[k];
      if (this->Mesh.IsMoved(t)) // else its certificate is one of a position that it had before
      {
        this->Overlays[t] = { this->GetCentre(t), this->ToReference.Get(t).heights };
      }
    });
  const std::vector<Index>& recertified = this->Recertified.Get();
  ParallelFor(static_cast<Index>(recertified.size()),
    [&](Index k) { this->ToAccepted.Set(recertified[k], this->ToCandidate.Get(recertified[k])); });
  if (!this->Dependents.IsEmpty())
  {
    for (const Index t : recertified)
    {
      this->Dependents.Add(t, this->ToAccepted.Get(t));
    }
  }
  this->Recertified.Clear();
}

void DeviationBounds::RollBack(const std::vector<Index>& triangles)
{
  ParallelFor(static_cast<Index>(triangles.size()),
    [&](Index k)
    {
      const Overlay& overlay = this->Overlays[triangles[k]];
      this->ToReference.Set(triangles[k], { overlay.centre, overlay.heights, {} });
    });
  const std::vector<Index>& recertified = this->Recertified.Get();
  ParallelFor(static_cast<Index>(recertified.size()),
    [&](Index k) { this->ToCandidate.Set(recertified[k], this->ToAccepted.Get(recertified[k])); });
  this->Tree.Invalidate(triangles);
  this->Recertified.Clear();
}
}
