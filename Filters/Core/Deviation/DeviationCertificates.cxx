// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Deviation/DeviationCertificates.h"

#include "Core/Base/Threading.h"
#include "Core/Deviation/SubdivisionBound.h"

#include <algorithm>

namespace lmo
{
namespace
{
/// Keeps what a cover says.
void Store(const TriangleCover& cover, TriangleCover::Verdict verdict, DistanceProofs::Proof& proof,
  Index& close)
{
  if (cover.GetCentre() >= 0)
  {
    proof.seed = cover.GetCentre();
  }
  if (verdict == TriangleCover::WITHIN)
  {
    proof.heights = cover.GetHeights();
    proof.used = cover.GetUsed();
  }
  else if (verdict == TriangleCover::BEYOND)
  {
    close = cover.GetUsed().back();
  }
}

/// Proves what the cover left open.
void TestOpen(const std::vector<Index>& list, const Points& V, const SurfaceView& mesh,
  const TriangleTree& tree, double distance, std::vector<DistanceProofs::Proof>& proofs,
  Mask& states, std::vector<Index>& close, Monitor& monitor)
{
  InterruptibleFor(static_cast<Index>(list.size()), monitor,
    [&, cover = TriangleCover()](Index k) mutable
    {
      if (states[k] != TriangleCover::UNCLEAR)
      {
        return;
      }
      DistanceProofs::Proof& proof = proofs[list[k]];
      const TriangleCorners corners = CornersOf(V, mesh.T, list[k]);
      states[k] = cover.Test(corners, mesh, &tree, proof.seed, distance);
      if (states[k] != TriangleCover::UNCLEAR)
      {
        Store(cover, TriangleCover::Verdict(states[k]), proof, close[k]);
        return;
      }
      Nearness nearness = TestConvexity(corners, tree, distance, proof.seed);
      states[k] = nearness.isProven ? TriangleCover::WITHIN : TriangleCover::BEYOND;
      close[k] = nearness.failure;
      if (nearness.isProven)
      {
        proof = { nearness.used[0], { -distance, distance }, std::move(nearness.used) };
      }
    });
}
}

DistanceProofs::DistanceProofs(Index triangles)
  : Proofs(triangles)
{
  ParallelFor(triangles,
    [this](Index t)
    {
      this->Proofs[t].seed = t;
      this->Proofs[t].used.assign(1, t);
    });
}

void DistanceProofs::Assign(const DistanceProofs& other)
{
  this->Proofs.resize(other.Proofs.size());
  ParallelFor(this->Size(), [&](Index t) { this->Proofs[t] = other.Proofs[t]; });
}

std::vector<DistanceProofs::Failure> DistanceProofs::Check(const std::vector<Index>& list,
  const Points& V, const SurfaceView& mesh, TriangleTree& tree, double distance, Monitor& monitor)
{
  const auto size = static_cast<Index>(list.size());
  Mask states(size);
  std::vector<Index> close(size, -1);
  InterruptibleFor(size, monitor,
    [&, cover = TriangleCover()](Index k) mutable
    {
      Proof& proof = this->Proofs[list[k]];
      const TriangleCover::Verdict verdict =
        cover.Test(CornersOf(V, mesh.T, list[k]), mesh, nullptr, proof.seed, distance);
      states[k] = verdict;
      Store(cover, verdict, proof, close[k]);
    });
  if (std::find(states.begin(), states.end(), TriangleCover::UNCLEAR) != states.end())
  {
    tree.Refit();
    TestOpen(list, V, mesh, tree, distance, this->Proofs, states, close, monitor);
  }
  std::vector<Failure> failures;
  for (Index k = 0; k < size; ++k)
  {
    if (states[k] == TriangleCover::BEYOND)
    {
      failures.push_back({ list[k], close[k] });
    }
  }
  return failures;
}

std::vector<Index> DistanceProofs::FindDependent(const Mask& isMarked) const
{
  Mask isDependent(this->Proofs.size());
  ParallelFor(this->Size(),
    [&](Index t)
    {
      const std::vector<Index>& used = this->Proofs[t].used;
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

double DistanceProofs::GetBound() const
{
  double bound = 0;
  for (const Proof& proof : this->Proofs)
  {
    bound = std::max(bound, proof.heights.Largest());
  }
  return bound;
}
}
