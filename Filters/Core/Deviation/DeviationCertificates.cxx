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
  DeviationCertificates::Content kept, DeviationCertificates::Certificate& certificate,
  Index& close)
{
  if (overlay.GetCentre() >= 0)
  {
    certificate.seed = overlay.GetCentre();
  }
  if (verdict == OverlayBound::WITHIN)
  {
    certificate.heights = overlay.GetHeights();
    if (kept == DeviationCertificates::BOUNDS_AND_USED)
    {
      certificate.used = overlay.GetUsed();
    }
  }
  else if (verdict == OverlayBound::BEYOND)
  {
    close = overlay.GetUsed().back();
  }
}

/// Searches for closest points: more than the deepest subdivision needs, and what is spent where
/// one of many proposals is judged.
constexpr int EnoughSearches = 1 << 20;
constexpr int FewSearches = 256;

constexpr std::size_t PartsOfProofs = 3; ///< one of them is tried before others may be postponed
constexpr Index ParallelProofs = 32;     ///< that are worth a thread
constexpr Index ParallelDivisions = 2;   ///< the same, by subdivision

/// Takes the first one of each so many values from a list.
std::vector<Index> TakeEach(std::size_t values, std::vector<Index>& list)
{
  std::vector<Index> taken;
  std::vector<Index> others;
  for (std::size_t k = 0; k < list.size(); ++k)
  {
    (k % values == 0 ? taken : others).push_back(list[k]);
  }
  list = std::move(others);
  return taken;
}

/// Proves triangles, each by an overlay or, if none exists, by subdivision.
class Prover
{
public:
  Prover(const SurfaceView& from, const SurfaceView& to, const DistanceLimits& limits,
    DeviationCertificates::Content kept)
    : From(from)
    , To(to)
    , Limits(limits)
    , Kept(kept)
  {
  }

  /// \param subdivision null if only the overlay is to be tried
  /// \param close is set to a triangle of the mesh that is close to a failure, or to -1
  OverlayBound::Verdict Prove(Index triangle, Subdivision* subdivision,
    DeviationCertificates::Certificate& certificate, Index& close)
  {
    const TriangleCorners corners = CornersOf(this->From.V, this->From.T, triangle);
    const double distance = this->Limits(triangle);
    const OverlayBound::Verdict verdict =
      this->Overlay.Test(corners, this->To, subdivision, certificate.seed, distance);
    Store(this->Overlay, verdict, this->Kept, certificate, close);
    if (verdict != OverlayBound::UNCLEAR || !subdivision)
    {
      return verdict;
    }
    Nearness nearness = TestBySubdivision(corners, *subdivision, distance, certificate.seed);
    close = nearness.failure;
    if (!nearness.isProven)
    {
      return OverlayBound::BEYOND;
    }
    certificate.seed = nearness.used[0];
    certificate.heights = { -distance, distance };
    if (this->Kept == DeviationCertificates::BOUNDS_AND_USED)
    {
      certificate.used = std::move(nearness.used);
    }
    return OverlayBound::WITHIN;
  }

private:
  const SurfaceView& From;
  const SurfaceView& To;
  const DistanceLimits& Limits;
  const DeviationCertificates::Content Kept;
  OverlayBound Overlay;
};
}

DeviationCertificates::DeviationCertificates(Index triangles, Content content)
  : Certificates(triangles)
  , Kept(content)
{
  ParallelFor(triangles,
    [this](Index t)
    {
      this->Certificates[t].seed = t;
      if (this->Kept == BOUNDS_AND_USED)
      {
        this->Certificates[t].used.assign(1, t);
      }
    });
}

DeviationCertificates::DeviationCertificates(const std::vector<Index>& seeds, Content content)
  : Certificates(seeds.size())
  , Kept(content)
{
  ParallelFor(this->Size(), [&](Index t) { this->Certificates[t].seed = seeds[t]; });
}

std::vector<DeviationCertificates::Failure> DeviationCertificates::Check(
  const std::vector<Index>& list, const SurfaceView& from, const SurfaceView& to, TriangleBvh& tree,
  const DistanceLimits& limits, Extent extent, const Postpone& postpone, ProgressMonitor& monitor)
{
  std::vector<Index> open = list;
  std::vector<Failure> failures = this->Prove(open, from, to, tree, limits, 0, monitor);
  this->Effort += static_cast<std::int64_t>(list.size());
  const auto postponeOpen = [&]
  {
    if (postpone)
    {
      postpone(failures, open);
    }
  };
  postponeOpen();
  if (!open.empty())
  {
    tree.Refit();
  }
  const int searches = extent == SINGLE_VERTICES ? FewSearches : EnoughSearches;
  while (!open.empty())
  {
    std::vector<Index> part = TakeEach(extent == SINGLE_VERTICES ? PartsOfProofs : 1, open);
    const std::vector<Failure> more = this->Prove(part, from, to, tree, limits, searches, monitor);
    failures.insert(failures.end(), more.begin(), more.end());
    postponeOpen();
  }
  return failures;
}

std::vector<DeviationCertificates::Failure> DeviationCertificates::Prove(std::vector<Index>& list,
  const SurfaceView& from, const SurfaceView& to, const TriangleBvh& tree,
  const DistanceLimits& limits, int searches, ProgressMonitor& monitor)
{
  const auto size = static_cast<Index>(list.size());
  Mask verdicts(size);
  std::vector<Index> close(size, -1);
  std::vector<int> effort(size, 0);
  InterruptibleFor(
    size, monitor,
    [&, prover = Prover(from, to, limits, this->Kept)](Index k) mutable
    {
      Subdivision subdivision{ tree, searches };
      verdicts[k] = prover.Prove(
        list[k], searches > 0 ? &subdivision : nullptr, this->Certificates[list[k]], close[k]);
      effort[k] = searches - std::max(subdivision.searchesLeft, 0);
    },
    searches > 0 ? ParallelDivisions : ParallelProofs);
  if (searches == FewSearches)
  {
    this->Effort += std::accumulate(effort.begin(), effort.end(), std::int64_t(0));
  }
  std::vector<Failure> failures;
  std::vector<Index> unclear;
  for (Index k = 0; k < size; ++k)
  {
    if (verdicts[k] == OverlayBound::BEYOND)
    {
      failures.push_back({ list[k], close[k] });
    }
    else if (verdicts[k] == OverlayBound::UNCLEAR)
    {
      unclear.push_back(list[k]);
    }
  }
  list = std::move(unclear);
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

void DependentCertificates::Build(const DeviationCertificates& certificates, Index triangles)
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
  offsets.assign(triangles + 2, 0);
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
