// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "DistanceProofs.h"

#include "ConvexityTest.h"
#include "Parallel.h"

#include <algorithm>

namespace lmo
{
namespace
{
enum State : unsigned char
{
  PROVEN,
  REFUTED,
  OPEN
};

/// Adds the verdicts of the convexity test on the open triangles of the list.
void TestOpen(const std::vector<Index>& list, const Points& V, const SurfaceView& mesh,
  const TriangleTree& tree, double distance, std::vector<DistanceProofs::Proof>& proofs,
  Mask& states, std::vector<Index>& close)
{
  ParallelFor(static_cast<Index>(list.size()),
    [&](Index k)
    {
      if (states[k] != OPEN)
      {
        return;
      }
      DistanceProofs::Proof& proof = proofs[list[k]];
      Nearness nearness =
        TestConvexity(CornersOf(V, mesh.T, list[k]), tree, distance, proof.seed);
      states[k] = nearness.isProven ? PROVEN : REFUTED;
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

std::vector<DistanceProofs::Failure> DistanceProofs::Check(const std::vector<Index>& list,
  const Points& V, const SurfaceView& mesh, TriangleTree& tree, double distance)
{
  const auto size = static_cast<Index>(list.size());
  Mask states(size, PROVEN);
  std::vector<Index> close(size, -1);
  ParallelRanges(
    size,
    [&](Index begin, Index end)
    {
      TriangleCover cover;
      for (Index k = begin; k < end; ++k)
      {
        Proof& proof = this->Proofs[list[k]];
        const TriangleCover::Verdict verdict =
          cover.Test(CornersOf(V, mesh.T, list[k]), mesh, proof.seed, distance);
        if (cover.GetCentre() >= 0)
        {
          proof.seed = cover.GetCentre();
        }
        states[k] = verdict == TriangleCover::WITHIN   ? PROVEN
                    : verdict == TriangleCover::BEYOND ? REFUTED
                                                       : OPEN;
        if (verdict == TriangleCover::WITHIN)
        {
          proof.heights = cover.GetHeights();
          proof.used = cover.GetUsed();
        }
        else if (verdict == TriangleCover::BEYOND)
        {
          close[k] = cover.GetUsed().back();
        }
      }
    },
    ParallelGrain);
  if (std::find(states.begin(), states.end(), OPEN) != states.end())
  {
    tree.Refit();
    TestOpen(list, V, mesh, tree, distance, this->Proofs, states, close);
  }
  std::vector<Failure> failures;
  for (Index k = 0; k < size; ++k)
  {
    if (states[k] == REFUTED)
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
