// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Deviation/TriangleValidity.h"

#include "Core/Base/Threading.h"
#include "Core/Mesh/TriangleGeometry.h"
#include "Core/Mesh/TriangleNeighbours.h"
#include "Core/Mesh/TriangleQuality.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace lmo
{
namespace
{
/// Least cosine of the angle between a triangle and the reference at its centre.
constexpr double LeastCosine = 0.3;

/// Least cosine of the angle between two triangles with a common edge.
constexpr double LeastCosineAtEdge = -0.5;

/// Least cosine of the angle by which a triangle may turn: a right angle but for the round-off in
/// normals of nearly degenerate triangles.
constexpr double LeastCosineToItself = 1e-3;

/// Cosine of the angle between a triangle's normal and the sum of the vertex normals at its
/// corners, without those of vertices of high valence, which hardly change.
double CosineToVertices(const Points& V, const Triangles& T, const MeshTopology& topology, Index t)
{
  Vector3 sum = Vector3::Zero();
  for (int k = 0; k < 3; ++k)
  {
    const Index i = T(t, k);
    if (!topology.HasHighValence(i))
    {
      sum += VertexNormal(V, T, topology, i);
    }
  }
  return ScaledNormal(V, T, t).stableNormalized().dot(sum.stableNormalized());
}
}

Points SmoothedNormals(const Points& V, const Triangles& triangles, const MeshTopology& topology)
{
  const Points vertexNormals = VertexNormals(V, triangles, topology);
  Points normals(triangles.rows(), 3);
  ParallelFor(static_cast<Index>(triangles.rows()),
    [&](Index t)
    {
      const Vector3 sum = vertexNormals.row(triangles(t, 0)) + vertexNormals.row(triangles(t, 1)) +
                          vertexNormals.row(triangles(t, 2));
      normals.row(t) = sum.stableNormalized();
    });
  return normals;
}

Points NormalsToKeep(const Points& V, const Triangles& triangles, const MeshTopology& topology)
{
  const Points vertexNormals = VertexNormals(V, triangles, topology);
  Points normals(triangles.rows(), 3);
  ParallelFor(static_cast<Index>(triangles.rows()),
    [&](Index t)
    {
      const Vector3 sum = vertexNormals.row(triangles(t, 0)) + vertexNormals.row(triangles(t, 1)) +
                          vertexNormals.row(triangles(t, 2));
      const Vector3 normal = ScaledNormal(V, triangles, t).stableNormalized();
      normals.row(t) = normal.dot(sum) < 0 ? Vector3(Vector3::Zero()) : normal;
    });
  return normals;
}

TriangleValidity::TriangleValidity(const Points& accepted, const Points& candidate,
  const Triangles& triangles, const MeshTopology& topology, const Triangles& neighbours,
  Points originalNormals, Points referenceNormals)
  : AcceptedPoints(accepted)
  , CandidatePoints(candidate)
  , T(triangles)
  , Topology(topology)
  , Neighbours(neighbours)
  , OriginalNormals(std::move(originalNormals))
  , ReferenceNormals(std::move(referenceNormals))
  , AcceptedNormals(triangles.rows(), 3)
  , Normals(triangles.rows(), 3)
  , AcceptedQuality(triangles.rows())
  , Quality(triangles.rows())
  , AcceptedCosine(triangles.rows())
{
  std::vector<Index> all(triangles.rows());
  std::iota(all.begin(), all.end(), 0);
  this->Update(all);
}

void TriangleValidity::Update(const std::vector<Index>& triangles)
{
  ParallelFor(static_cast<Index>(triangles.size()),
    [&](Index k)
    {
      const Index t = triangles[k];
      this->Normals.row(t) = ScaledNormal(this->CandidatePoints, this->T, t).stableNormalized();
      this->Quality[t] = this->MeasureQuality(t);
    });
}

double TriangleValidity::MeasureQuality(Index t) const
{
  const Polygons& polygons = this->Topology.polygons;
  return polygons.IsEmpty()
           ? RadiusRatio(this->CandidatePoints.row(this->T(t, 0)),
               this->CandidatePoints.row(this->T(t, 1)), this->CandidatePoints.row(this->T(t, 2)))
           : PolygonQuality(this->CandidatePoints, polygons, polygons.ofTriangle[t]);
}

bool TriangleValidity::HasMoreReflexCorners(Index t) const
{
  const Polygons& polygons = this->Topology.polygons;
  if (polygons.IsEmpty())
  {
    return false;
  }
  const Index p = polygons.ofTriangle[t];
  return CountReflexCorners(this->CandidatePoints, polygons, p) >
         CountReflexCorners(this->AcceptedPoints, polygons, p);
}

bool TriangleValidity::IsBad(Index t, double least) const
{
  return this->Quality[t] < std::min(least, this->AcceptedQuality[t]);
}

bool TriangleValidity::IsFolded(Index t) const
{
  for (int k = 0; k < 3; ++k)
  {
    const Index neighbour = this->Neighbours(t, k);
    if (neighbour != NoNeighbour)
    {
      const double limit = std::min(
        LeastCosineAtEdge, this->AcceptedNormals.row(t).dot(this->AcceptedNormals.row(neighbour)));
      if (this->Normals.row(t).dot(this->Normals.row(neighbour)) < limit)
      {
        return true;
      }
    }
  }
  return this->HasMoreReflexCorners(t);
}

bool TriangleValidity::FacesAllAround(Index t) const
{
  bool facesAll = true;
  for (int k = 0; k < 3 && facesAll; ++k)
  {
    const Index i = this->T(t, k);
    if (!this->Topology.HasHighValence(i))
    {
      ForEachTriangleOfCellsAt(this->Topology.cornersAt, this->Topology.polygons, i,
        [&](Index other)
        { facesAll = facesAll && !(this->Normals.row(other).dot(this->Normals.row(t)) < 0); });
    }
  }
  return facesAll;
}

bool TriangleValidity::IsInverted(Index t) const
{
  if (this->FacesAllAround(t))
  {
    return false;
  }
  const double cosine = CosineToVertices(this->CandidatePoints, this->T, this->Topology, t);
  return cosine < 0 && cosine < CosineToVertices(this->AcceptedPoints, this->T, this->Topology, t);
}

bool TriangleValidity::IsTurnedOver(Index t) const
{
  const Vector3 original = this->OriginalNormals.row(t);
  return !original.isZero(0) && original.dot(this->Normals.row(t)) < LeastCosineToItself;
}

bool TriangleValidity::IsTurned(Index t, Index below) const
{
  return this->Normals.row(t).dot(this->ReferenceNormals.row(below)) <
         std::min(LeastCosine, this->AcceptedCosine[t]);
}

void TriangleValidity::Accept(Index t, Index below)
{
  this->AcceptedNormals.row(t) = this->Normals.row(t);
  this->AcceptedQuality[t] = this->Quality[t];
  this->AcceptedCosine[t] = this->Normals.row(t).dot(this->ReferenceNormals.row(below));
}

void TriangleValidity::RollBack(const std::vector<Index>& triangles)
{
  ParallelFor(static_cast<Index>(triangles.size()),
    [&](Index k)
    {
      const Index t = triangles[k];
      this->Normals.row(t) = this->AcceptedNormals.row(t);
      this->Quality[t] = this->AcceptedQuality[t];
    });
}
}
