// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Deviation/DeviationBounds.h"

#include "Core/Base/Threading.h"
#include "Core/Deviation/Split.h"
#include "Core/Mesh/TriangleGeometry.h"

#include <algorithm>

namespace lmo
{
namespace
{
/// Share of the distance up to which heights over the original surface may be rough.
constexpr double CarriedShare = 0.5;
}

DeviationBounds::DeviationBounds(const Points& original, const CandidateMesh& mesh,
  const Triangles& neighbours, double distance, ProgressMonitor& monitor)
  : Original(original)
  , Mesh(mesh)
  , Neighbours(neighbours)
  , Distance(distance)
  , Overlays(mesh.T.rows())
  , OriginalTree(original, mesh.T, monitor)
  , Tree(mesh.candidate, this->OriginalTree)
  , ToOriginal(static_cast<Index>(mesh.T.rows()))
  , ToCandidate(static_cast<Index>(mesh.T.rows()))
  , ToAccepted(this->ToCandidate)
  , Recertified(static_cast<Index>(mesh.T.rows()))
{
  ParallelFor(static_cast<Index>(mesh.T.rows()), [this](Index t) { this->Overlays[t].centre = t; });
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
    this->Dependents.Build(this->ToAccepted);
  }
  return this->Dependents.Find(triangles);
}

std::vector<DeviationBounds::Failure> DeviationBounds::CheckCandidate(
  std::vector<Index> list, Extent extent, ProgressMonitor& monitor)
{
  Split(list, monitor, [this](Index t) { return this->CarryToOriginal(t); });
  return this->ToOriginal.Check(list, this->Mesh.candidate, this->OriginalView(),
    this->OriginalTree, this->Distance, extent, monitor);
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

std::vector<DeviationBounds::Failure> DeviationBounds::CheckOriginal(
  std::vector<Index> list, Extent extent, ProgressMonitor& monitor)
{
  this->Recertified.Add(list);
  if (extent == DeviationCertificates::ALL_FAILURES)
  {
    Split(list, monitor, [this](Index t) { return this->CarryToCandidate(t); });
  }
  else
  {
    Split(list, monitor, [this](Index t) { return this->KeepUnmoved(t); });
  }
  std::vector<Failure> failures = this->ToCandidate.Check(
    list, this->Original, this->CandidateView(), this->Tree, this->Distance, extent, monitor);
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
  if (!(heights.Largest() <= this->Distance))
  {
    return false;
  }
  this->ToCandidate.Set(t, { accepted.seed, heights, accepted.used });
  return true;
}

bool DeviationBounds::CarryToOriginal(Index t)
{
  const HeightRange heights =
    this->Overlays[t].heights.WidenedBy(this->Mesh.LargestDisplacement(t));
  if (!(heights.Largest() <= CarriedShare * this->Distance))
  {
    return false;
  }
  const Index centre = OverlayBound().FindCentre(
    CornersOf(this->Mesh.candidate, this->Mesh.T, t), this->OriginalView(), this->GetCentre(t));
  if (centre < 0)
  {
    return false;
  }
  this->ToOriginal.Set(t, { centre, heights, { centre } });
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
        this->Overlays[t] = { this->GetCentre(t), this->ToOriginal.Get(t).heights };
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
      this->ToOriginal.Set(triangles[k], { overlay.centre, overlay.heights, {} });
    });
  const std::vector<Index>& recertified = this->Recertified.Get();
  ParallelFor(static_cast<Index>(recertified.size()),
    [&](Index k) { this->ToCandidate.Set(recertified[k], this->ToAccepted.Get(recertified[k])); });
  this->Tree.Invalidate(triangles);
  this->Recertified.Clear();
}
}
