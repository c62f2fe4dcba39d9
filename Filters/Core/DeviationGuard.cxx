// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "DeviationGuard.h"

#include "Parallel.h"
#include "Quality.h"
#include "TriangleGeometry.h"

#include <algorithm>
#include <numeric>

namespace lmo
{
namespace
{
/// Least cosine of the angle between a triangle and the original surface at its centre.
constexpr double LeastCosine = 0.3;

/// Least cosine of the angle between two triangles with a common edge.
constexpr double LeastCosineAtEdge = -0.5;

/// Share of the distance that round-off may not use.
constexpr double Margin = 1e-6;

/// Sum of the vertex normals at each triangle's corners, as a unit vector: noise and nearly
/// degenerate triangles turn it less than the triangle's own.
Points SmoothedNormals(const Points& V, const Triangles& T, const MeshTopology& topology)
{
  const Points vertexNormals = VertexNormals(V, T, topology);
  Points normals(T.rows(), 3);
  ParallelFor(static_cast<Index>(T.rows()),
    [&](Index t)
    {
      const Vector3 sum =
        vertexNormals.row(T(t, 0)) + vertexNormals.row(T(t, 1)) + vertexNormals.row(T(t, 2));
      normals.row(t) = sum.stableNormalized();
    });
  return normals;
}

void AddOnce(const std::vector<Index>& more, Mask& isListed, std::vector<Index>& list)
{
  for (const Index t : more)
  {
    if (!isListed[t])
    {
      isListed[t] = true;
      list.push_back(t);
    }
  }
}
}

DeviationGuard::DeviationGuard(
  const Points& V, const Triangles& triangles, const MeshTopology& topology, double distance)
  : Original(V)
  , T(triangles)
  , Topology(topology)
  , Distance((1 - Margin) * distance)
  , Neighbours(FindTriangleNeighbours(triangles, topology))
  , ReferenceNormals(SmoothedNormals(V, triangles, topology))
  , Candidate(V)
  , Normals(triangles.rows(), 3)
  , Quality(triangles.rows())
  , OriginalTree(this->Original, triangles)
  , Tree(this->Candidate, triangles)
  , ToOriginal(static_cast<Index>(triangles.rows()))
  , ToCandidate(static_cast<Index>(triangles.rows()))
  , ToAdmitted(static_cast<Index>(triangles.rows()))
{
  std::vector<Index> all(triangles.rows());
  std::iota(all.begin(), all.end(), 0);
  this->UpdateShapes(all);
  this->Admit();
}

void DeviationGuard::UpdateShapes(const std::vector<Index>& triangles)
{
  ParallelFor(static_cast<Index>(triangles.size()),
    [&](Index k)
    {
      const Index t = triangles[k];
      this->Normals.row(t) = ScaledNormal(this->Candidate, this->T, t).stableNormalized();
      this->Quality[t] = RadiusRatio(this->Candidate.row(this->T(t, 0)),
        this->Candidate.row(this->T(t, 1)), this->Candidate.row(this->T(t, 2)));
    });
}

bool DeviationGuard::IsShapely(Index t, double leastQuality) const
{
  if (this->Quality[t] < std::min(leastQuality, this->AdmittedQuality[t]))
  {
    return false;
  }
  for (int k = 0; k < 3; ++k)
  {
    const Index neighbour = this->Neighbours(t, k);
    if (neighbour != NoNeighbour)
    {
      const double limit = std::min(
        LeastCosineAtEdge, this->AdmittedNormals.row(t).dot(this->AdmittedNormals.row(neighbour)));
      if (this->Normals.row(t).dot(this->Normals.row(neighbour)) < limit)
      {
        return false;
      }
    }
  }
  return true;
}

bool DeviationGuard::IsMoved(Index t) const
{
  bool isMoved = false;
  for (int k = 0; k < 3; ++k)
  {
    isMoved = isMoved || this->Candidate.row(this->T(t, k)) != this->Admitted.row(this->T(t, k));
  }
  return isMoved;
}

bool DeviationGuard::IsTurned(Index t) const
{
  const Index below = this->ToOriginal.Get(t).seed;
  return this->Normals.row(t).dot(this->ReferenceNormals.row(below)) <
         std::min(LeastCosine, this->AdmittedCosine[t]);
}

std::vector<DeviationGuard::Failure> DeviationGuard::Check(
  const std::vector<Index>& vertices, double leastQuality)
{
  this->Tree.Invalidate();
  Mask isChanged(this->T.rows(), false);
  std::vector<Index> changed;
  for (const Index i : vertices)
  {
    for (const Index* c = this->Topology.cornersAt.Begin(i); c != this->Topology.cornersAt.End(i);
         ++c)
    {
      AddOnce({ *c / 3 }, isChanged, changed);
    }
  }
  std::vector<Index> originals = this->ToCandidate.FindDependent(isChanged);
  Mask isOriginalListed(this->T.rows(), false);
  for (const Index t : originals)
  {
    isOriginalListed[t] = true;
  }
  AddOnce(this->OpenOriginal, isOriginalListed, originals);
  AddOnce(this->Open, isChanged, changed);

  this->UpdateShapes(changed);
  Mask isShapely(changed.size());
  ParallelFor(static_cast<Index>(changed.size()),
    [&](Index k) { isShapely[k] = this->IsShapely(changed[k], leastQuality); });
  std::vector<Index> bad;
  std::vector<Index> shapely;
  for (std::size_t k = 0; k < changed.size(); ++k)
  {
    (isShapely[k] ? shapely : bad).push_back(changed[k]);
  }
  const SurfaceView original{ this->Original, this->T, this->Neighbours };
  for (const DistanceProofs::Failure& failure : this->ToOriginal.Check(
         shapely, this->Candidate, original, this->OriginalTree, this->Distance))
  {
    bad.push_back(failure.triangle);
  }
  std::copy_if(shapely.begin(), shapely.end(), std::back_inserter(bad),
    [this](Index t) { return this->IsTurned(t); });
  // What has not moved is admitted already; its neighbours are to blame for a fold between them.
  this->Open.clear();
  std::copy_if(bad.begin(), bad.end(), std::back_inserter(this->Open),
    [this](Index t) { return this->IsMoved(t); });

  std::vector<Failure> failures;
  for (const Index t : this->Open)
  {
    failures.push_back({ t, {} });
  }
  const SurfaceView candidate{ this->Candidate, this->T, this->Neighbours };
  this->OpenOriginal.clear();
  for (const DistanceProofs::Failure& failure : this->ToCandidate.Check(
         originals, this->Original, candidate, this->Tree, this->Distance))
  {
    const DistanceProofs::Proof& admitted = this->ToAdmitted.Get(failure.triangle);
    const bool isMoved = std::any_of(
      admitted.used.begin(), admitted.used.end(), [this](Index t) { return this->IsMoved(t); });
    if (isMoved)
    {
      this->OpenOriginal.push_back(failure.triangle);
      failures.push_back({ failure.close < 0 ? failure.triangle : failure.close, admitted.used });
    }
    else
    {
      this->ToCandidate.Set(failure.triangle, admitted);
    }
  }
  return failures;
}

void DeviationGuard::Admit()
{
  this->Bound = std::max(this->ToOriginal.GetBound(), this->ToCandidate.GetBound());
  this->Admitted = this->Candidate;
  this->AdmittedNormals = this->Normals;
  this->AdmittedQuality = this->Quality;
  this->ToAdmitted = this->ToCandidate;
  this->AdmittedCosine.resize(this->T.rows());
  ParallelFor(static_cast<Index>(this->T.rows()),
    [this](Index t)
    {
      const Index below = this->ToOriginal.Get(t).seed;
      this->AdmittedCosine[t] = this->Normals.row(t).dot(this->ReferenceNormals.row(below));
    });
}

void DeviationGuard::Reject()
{
  this->Candidate = this->Admitted;
  std::vector<Index> all(this->Candidate.rows());
  std::iota(all.begin(), all.end(), 0);
  this->Check(all, 0);
}
}
