// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Operators/MeshQuantities.h"

#include "Core/Base/BackgroundTask.h"
#include "Core/Base/Threading.h"
#include "Core/Mesh/TriangleGeometry.h"
#include "Core/Operators/Curvature.h"

#include <algorithm>
#include <cmath>

namespace lmo
{
namespace
{
/// Bounding box over the processes.
Eigen::AlignedBox3d Unite(const Eigen::AlignedBox3d& box, const Subdomain& subdomain)
{
  Eigen::AlignedBox3d united;
  for (int c = 0; c < 3; ++c)
  {
    united.min()[c] = -subdomain.Maximum(-box.min()[c]);
    united.max()[c] = subdomain.Maximum(box.max()[c]);
  }
  return united;
}

/// The longest edge at vertex i, squared.
double LongestSquaredEdge(const AdjacencyLists& oneRings, const Points& V, Index i)
{
  double longest = 0;
  for (const Index* j = oneRings.Begin(i); j != oneRings.End(i); ++j)
  {
    longest = std::max(longest, (V.row(*j) - V.row(i)).squaredNorm());
  }
  return longest;
}

/// Eqn. 10: delta_c, shortened where it is longer than the longest edge, minus L_u V.
Points ComputeDetailTarget(const Laplacian& uniform, const Laplacian& cotangent, const Points& V)
{
  Points target(V.rows(), 3);
  ParallelFor(static_cast<Index>(V.rows()),
    [&](Index i)
    {
      Vector3 detail = -cotangent.rowScale[i] * StiffnessRow(cotangent, V, i);
      const double longest = LongestSquaredEdge(*uniform.rings, V, i);
      const double length = detail.squaredNorm();
      if (length > longest)
      {
        detail *= std::sqrt(longest / length);
      }
      target.row(i) = detail + uniform.rowScale[i] * StiffnessRow(uniform, V, i);
    });
  return target;
}
}

MeshQuantities::MeshQuantities(
  Points V, Triangles triangles, std::shared_ptr<const Subdomain> subdomain)
  : V(std::move(V))
  , T(std::move(triangles))
  , Topology(
      std::make_shared<MeshTopology>(BuildTopology(static_cast<Index>(this->V.rows()), this->T)))
  , Domain(std::move(subdomain))
  , Box(Unite(BoundingBox(this->V, *this->Topology), *this->Domain))
{
}

template <typename Part, typename Compute>
const Part& MeshQuantities::Get(std::optional<Part>& part, const Compute& compute)
{
  if (!part)
  {
    part = compute();
    ++this->NumberOfParts;
  }
  return *part;
}

std::shared_ptr<const AdjacencyLists> MeshQuantities::OneRings() const
{
  return { this->Topology, &this->Topology->oneRings };
}

void MeshQuantities::ComputeCotangentParts()
{
  if (!this->EdgeWeights && this->IsRobust)
  {
    this->SetRobustWeights(ComputeRobustWeights(this->V, this->T));
  }
  else if (!this->EdgeWeights)
  {
    const CornerValues cotangents = Cotangents(this->V, this->T);
    this->WeightRings = this->OneRings();
    this->EdgeWeights = CotangentEdgeWeights(*this->Topology, this->T, cotangents);
    this->VoronoiAreas = MixedVoronoiAreas(this->V, this->T, *this->Topology, cotangents);
    ++this->NumberOfParts;
  }
}

void MeshQuantities::SetRobustWeights(RobustWeights weights)
{
  this->WeightRings = std::move(weights.rings);
  this->EdgeWeights = std::move(weights.edgeWeights);
  this->VoronoiAreas = std::move(weights.voronoiAreas);
  ++this->NumberOfParts;
}

void MeshQuantities::PrepareRobustLaplacian(LaplacianType type, ProgressMonitor& monitor)
{
  const bool areNeeded = !this->Curvatures || (type != LaplacianType::UNIFORM &&
                                                !this->Laplacians[static_cast<int>(type)]);
  if (this->IsRobust && !this->EdgeWeights && areNeeded)
  {
    this->SetRobustWeights(
      RunInBackground(monitor, [V = this->V, T = this->T] { return ComputeRobustWeights(V, T); }));
  }
}

void MeshQuantities::ReleaseIntermediateParts(LaplacianType type)
{
  this->CurvatureNormals.reset();
  for (const LaplacianType other : { LaplacianType::COTANGENT, LaplacianType::MEAN_CURVATURE })
  {
    if (other != type)
    {
      this->Laplacians[static_cast<int>(other)].reset();
    }
  }
  if (type == LaplacianType::UNIFORM)
  {
    this->ForgetWeights();
  }
}

void MeshQuantities::ForgetWeights()
{
  this->WeightRings.reset();
  this->EdgeWeights.reset();
  this->SoftWeights.reset();
  this->VoronoiAreas.resize(0);
}

void MeshQuantities::SetRobustLaplacian(bool isRobust)
{
  if (this->IsRobust != isRobust)
  {
    this->IsRobust = isRobust;
    this->ForgetWeights();
    this->Laplacians[static_cast<int>(LaplacianType::COTANGENT)].reset();
    this->Laplacians[static_cast<int>(LaplacianType::MEAN_CURVATURE)].reset();
    this->CurvatureNormals.reset();
    this->Curvatures.reset();
    this->Statistics.reset();
    this->Cumulative.reset();
    this->DetailTarget.reset();
  }
}

bool MeshQuantities::HasBoundary()
{
  return this->Get(this->Boundary,
    [&]
    {
      const Mask isBoundary = this->Domain->OwnedOf(this->Topology->isBoundary);
      const bool isHere = std::find(isBoundary.begin(), isBoundary.end(), 1) != isBoundary.end();
      return this->Domain->Maximum(isHere) > 0;
    });
}

std::shared_ptr<const Vector> MeshQuantities::GetSoftEdgeWeights()
{
  return this->Get(this->SoftWeights,
    [&]
    {
      return this->IsRobust
               ? nullptr
               : SoftEdgeWeights(*this->Topology, this->T, Cotangents(this->V, this->T));
    });
}

const Vector& MeshQuantities::GetVoronoiAreas()
{
  this->ComputeCotangentParts();
  return this->VoronoiAreas;
}

const Laplacian& MeshQuantities::GetLaplacian(LaplacianType type)
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
               ? CotangentLaplacian(this->WeightRings, this->EdgeWeights)
               : MeanCurvatureLaplacian(this->WeightRings, this->EdgeWeights, this->VoronoiAreas);
    });
}

const Points& MeshQuantities::GetMeanCurvatureNormals()
{
  return this->Get(this->CurvatureNormals,
    [&]
    {
      Points normals = MeanCurvatureNormals(
        this->GetLaplacian(LaplacianType::MEAN_CURVATURE), this->V, *this->Topology);
      this->Domain->UpdateCopies(normals);
      return normals;
    });
}

const Vector& MeshQuantities::GetMeanCurvatures()
{
  return this->Get(this->Curvatures,
    [&]
    {
      Vector curvatures =
        MeanCurvatures(this->GetMeanCurvatureNormals(), this->GetDiagonal(), *this->Topology);
      this->Domain->UpdateCopies(curvatures);
      return curvatures;
    });
}

const CurvatureStatistics& MeshQuantities::GetStatistics()
{
  return this->Get(this->Statistics,
    [&] {
      return ComputeStatistics(this->GetMeanCurvatures(), this->Topology->isUsed, *this->Domain);
    });
}

const Vector& MeshQuantities::GetCumulativeWeights()
{
  return this->Get(this->Cumulative,
    [&] {
      return CumulativeWeights(this->GetMeanCurvatures(), this->Topology->isUsed, *this->Domain);
    });
}

std::shared_ptr<const Points> MeshQuantities::GetDetailTarget()
{
  return this->Get(this->DetailTarget,
    [&]
    {
      return std::make_shared<const Points>(
        ComputeDetailTarget(this->GetLaplacian(LaplacianType::UNIFORM),
          this->GetLaplacian(LaplacianType::COTANGENT), this->V));
    });
}

std::shared_ptr<const MeshQuality> MeshQuantities::GetQuality()
{
  return this->Get(this->Quality,
    [&] {
      return std::make_shared<const MeshQuality>(MeasureQuality(this->V, this->T, *this->Domain));
    });
}

const std::vector<Index>& MeshQuantities::GetComponents()
{
  return this->Get(this->Components, [&] { return ConnectedComponents(this->Topology->oneRings); });
}
}
