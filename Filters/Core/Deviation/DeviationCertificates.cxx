// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Deviation/DeviationCertificates.h"

#include "Core/Base/Threading.h"
#include "Core/Deviation/SubdivisionBound.h"

#include <algorithm>
#include <numeric>

namespace lmo
{
namespace
{
/// Keeps what an overlay says.
void Store(const OverlayBound& overlay, OverlayBound::Verdict verdict,
  DeviationCertificates::Certificate& certificate, Index& close)
{
  if (overlay.GetCentre() >= 0)
  {
    certificate.seed = overlay.GetCentre();
  }
  if (verdict == OverlayBound::WITHIN)
  {
    certificate.heights = overlay.GetHeights();
    certificate.used = overlay.GetUsed();
  }
  else if (verdict == OverlayBound::BEYOND)
  {
    close = overlay.GetUsed().back();
  }
}

/// Proves what the overlay left open.
void TestOpen(const std::vector<Index>& list, const Points& V, const SurfaceView& mesh,
  const TriangleBvh& tree, double distance,
  std::vector<DeviationCertificates::Certificate>& certificates, Mask& states,
  std::vector<Index>& close, ProgressMonitor& monitor)
{
  InterruptibleFor(static_cast<Index>(list.size()), monitor,
    [&, overlay = OverlayBound()](Index k) mutable
    {
      if (states[k] != OverlayBound::UNCLEAR)
      {
        return;
      }
      DeviationCertificates::Certificate& certificate = certificates[list[k]];
      const TriangleCorners corners = CornersOf(V, mesh.T, list[k]);
      states[k] = overlay.Test(corners, mesh, &tree, certificate.seed, distance);
      if (states[k] != OverlayBound::UNCLEAR)
      {
        Store(overlay, OverlayBound::Verdict(states[k]), certificate, close[k]);
        return;
      }
      Nearness nearness = TestBySubdivision(corners, tree, distance, certificate.seed);
      states[k] = nearness.isProven ? OverlayBound::WITHIN : OverlayBound::BEYOND;
      close[k] = nearness.failure;
      if (nearness.isProven)
      {
        certificate = { nearness.used[0], { -distance, distance }, std::move(nearness.used) };
      }
    });
}
}

DeviationCertificates::DeviationCertificates(Index triangles)
  : Certificates(triangles)
{
  ParallelFor(triangles,
    [this](Index t)
    {
      this->Certificates[t].seed = t;
      this->Certificates[t].used.assign(1, t);
    });
}

void DeviationCertificates::Assign(const DeviationCertificates& other)
{
  this->Certificates.resize(other.Certificates.size());
  ParallelFor(this->Size(), [&](Index t) { this->Certificates[t] = other.Certificates[t]; });
}

std::vector<DeviationCertificates::Failure> DeviationCertificates::Check(
  const std::vector<Index>& list, const Points& V, const SurfaceView& mesh, TriangleBvh& tree,
  double distance, ProgressMonitor& monitor)
{
  const auto size = static_cast<Index>(list.size());
  Mask states(size);
  std::vector<Index> close(size, -1);
  InterruptibleFor(size, monitor,
    [&, overlay = OverlayBound()](Index k) mutable
    {
      Certificate& certificate = this->Certificates[list[k]];
      const OverlayBound::Verdict verdict =
        overlay.Test(CornersOf(V, mesh.T, list[k]), mesh, nullptr, certificate.seed, distance);
      states[k] = verdict;
      Store(overlay, verdict, certificate, close[k]);
    });
  if (std::find(states.begin(), states.end(), OverlayBound::UNCLEAR) != states.end())
  {
    tree.Refit();
    TestOpen(list, V, mesh, tree, distance, this->Certificates, states, close, monitor);
  }
  std::vector<Failure> failures;
  for (Index k = 0; k < size; ++k)
  {
    if (states[k] == OverlayBound::BEYOND)
    {
      failures.push_back({ list[k], close[k] });
    }
  }
  return failures;
}

std::vector<Index> DeviationCertificates::FindDependent(const Mask& isMarked) const
{
  Mask isDependent(this->Certificates.size());
  ParallelFor(this->Size(),
    [&](Index t)
    {
      const std::vector<Index>& used = this->Certificates[t].used;
      isDependent[t] = std::any_of(used.begin(), used.end(), [&](Index u) { return isMarked[u]; });
    });
  std::vector<Index> dependent;
  for (Index t = 0; t < this->Size(); ++t)
  {
    if (isDependent[t])
    {
      dependent.push_back(t);
    }
  }
  return dependent;
}

double DeviationCertificates::GetBound() const
{
  double bound = 0;
  for (const Certificate& certificate : this->Certificates)
  {
    bound = std::max(bound, certificate.heights.Largest());
  }
  return bound;
}

void DependentCertificates::Clear()
{
  this->Listed = {};
  this->Added.clear();
}

void DependentCertificates::Build(const DeviationCertificates& certificates)
{
  const auto forEach = [&](const auto& visit)
  {
    for (Index t = 0; t < certificates.Size(); ++t)
    {
      for (const Index used : certificates.Get(t).used)
      {
        visit(used, t);
      }
    }
  };
  std::vector<Index>& offsets = this->Listed.offsets;
  offsets.assign(certificates.Size() + 2, 0);
  forEach([&](Index used, Index) { ++offsets[used + 2]; });
  std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
  this->Listed.ids.resize(offsets.back());
  forEach([&](Index used, Index t) { this->Listed.ids[offsets[used + 1]++] = t; });
  offsets.pop_back();
}

void DependentCertificates::Add(
  Index triangle, const DeviationCertificates::Certificate& certificate)
{
  const auto isIn = [triangle](auto begin, auto end)
  { return std::find(begin, end, triangle) != end; };
  for (const Index used : certificate.used)
  {
    std::vector<Index>& added = this->Added[used];
    if (!isIn(this->Listed.Begin(used), this->Listed.End(used)) &&
        !isIn(added.begin(), added.end()))
    {
      added.push_back(triangle);
    }
  }
}

std::vector<Index> DependentCertificates::Find(const std::vector<Index>& used) const
{
  std::vector<Index> found;
  for (const Index t : used)
  {
    found.insert(found.end(), this->Listed.Begin(t), this->Listed.End(t));
    const auto added = this->Added.find(t);
    if (added != this->Added.end())
    {
      found.insert(found.end(), added->second.begin(), added->second.end());
    }
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}
}
