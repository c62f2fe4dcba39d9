// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshAnalysis.h"

#include "Curvature.h"
#include "Parallel.h"
#include "TriangleGeometry.h"

#include <algorithm>
#include <cmath>

namespace lmo
{
namespace
{
/// Shortens each delta_c that is longer than the longest edge at its vertex.
void BoundByLongestEdge(const AdjacencyLists& oneRings, const Points& V, Points& laplacians)
{
  ParallelFor(static_cast<Index>(V.rows()),
    [&](Index i)
    {
      double longest = 0;
      for (const Index* j = oneRings.Begin(i); j != oneRings.End(i); ++j)
      {
        longest = std::max(longest, (V.row(*j) - V.row(i)).squaredNorm());
      }
      const double length = laplacians.row(i).squaredNorm();
      if (length > longest)
      {
        laplacians.row(i) *= std::sqrt(longest / length);
      }
    });
}
}

MeshAnalysis::MeshAnalysis(Points V, Triangles triangles)
  : V(std::move(V))
  , T(std::move(triangles))
  , Topology(
      std::make_shared<MeshTopology>(BuildTopology(static_cast<Index>(this->V.rows()), this->T)))
  , Diagonal(BoundingBoxDiagonal(this->V, *this->Topology))
{
}

template <typename Part, typename Compute>
const Part& MeshAnalysis::Get(std::optional<Part>& part, const Compute& compute)
{
  if (!part)
  {
    part = compute();
    ++this->NumberOfParts;
  }
  return *part;
}

std::shared_ptr<const AdjacencyLists> MeshAnalysis::OneRings() const
{
  return { this->Topology, &this->Topology->oneRings };
}

void MeshAnalysis::ComputeCotangentParts()
{
  if (!this->EdgeWeights)
  {
    const CornerValues cotangents = Cotangents(this->V, this->T);
    this->EdgeWeights = CotangentEdgeWeights(*this->Topology, this->T, cotangents);
    this->VoronoiAreas = MixedVoronoiAreas(this->V, this->T, *this->Topology, cotangents);
    ++this->NumberOfParts;
  }
}

void MeshAnalysis::ReleaseCotangentParts()
{
  this->EdgeWeights.reset();
  this->VoronoiAreas.resize(0);
  this->CurvatureNormals.reset();
  this->Laplacians[static_cast<int>(LaplacianType::COTANGENT)].reset();
  this->Laplacians[static_cast<int>(LaplacianType::MEAN_CURVATURE)].reset();
}

const Vector& MeshAnalysis::GetVoronoiAreas()
{
  this->ComputeCotangentParts();
  return this->VoronoiAreas;
}

const Laplacian& MeshAnalysis::GetLaplacian(LaplacianType type)
{
  return this->Get(this->Laplacians[static_cast<int>(type)],
    [&]
    {
      if (type == LaplacianType::UNIFORM)
      {
        return UniformLaplacian(this->OneRings());
      }
      this->ComputeCotangentParts();
      return type == LaplacianType::COTANGENT
               ? CotangentLaplacian(this->OneRings(), this->EdgeWeights)
               : MeanCurvatureLaplacian(this->OneRings(), this->EdgeWeights, this->VoronoiAreas);
    });
}

const Points& MeshAnalysis::GetMeanCurvatureNormals()
{
  return this->Get(this->CurvatureNormals,
    [&]
    {
      return MeanCurvatureNormals(
        this->GetLaplacian(LaplacianType::MEAN_CURVATURE), this->V, *this->Topology);
    });
}

const Vector& MeshAnalysis::GetMeanCurvatures()
{
  return this->Get(this->Curvatures, [&]
    { return MeanCurvatures(this->GetMeanCurvatureNormals(), this->Diagonal, *this->Topology); });
}

const CurvatureStatistics& MeshAnalysis::GetStatistics()
{
  return this->Get(this->Statistics,
    [&] { return ComputeStatistics(this->GetMeanCurvatures(), this->Topology->isUsed); });
}

const Vector& MeshAnalysis::GetCumulativeWeights()
{
  return this->Get(this->Cumulative,
    [&] { return CumulativeWeights(this->GetMeanCurvatures(), this->Topology->isUsed); });
}

const Points& MeshAnalysis::GetDetailLaplacians()
{
  return this->Get(this->DetailLaplacians,
    [&]
    {
      Points details = Apply(this->GetLaplacian(LaplacianType::COTANGENT), this->V);
      BoundByLongestEdge(this->Topology->oneRings, this->V, details);
      return details;
    });
}

const MeshQuality& MeshAnalysis::GetQuality()
{
  return this->Get(this->Quality, [&] { return MeasureQuality(this->V, this->T); });
}

const std::vector<Index>& MeshAnalysis::GetComponents()
{
  return this->Get(this->Components, [&] { return ConnectedComponents(this->Topology->oneRings); });
}
}
