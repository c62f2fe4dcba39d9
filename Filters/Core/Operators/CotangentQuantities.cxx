// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Operators/CotangentQuantities.h"

#include "Core/Base/BackgroundTask.h"
#include "Core/Base/Threading.h"
#include "Core/Operators/Curvature.h"

#include <algorithm>
#include <cmath>

namespace lmo
{
namespace
{
/// The longest edge at vertex i, squared.
double LongestSquaredEdge(const AdjacencyLists& oneRings, const Points& V, Index i)
{
  double longest = 0;
  for (const Index j : oneRings[i])
  {
    longest = std::max(longest, (V.row(j) - V.row(i)).squaredNorm());
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

CotangentQuantities::CotangentQuantities(const MeshQuantities& mesh, bool isRobust)
  : Mesh(mesh)
  , HasRobustWeights(isRobust)
{
}

template <typename Compute>
std::shared_ptr<const CotangentWeights> CotangentQuantities::LockWeights(
  const Compute& computeRobustWeights) const
{
  std::shared_ptr<const CotangentWeights> weights = this->Weights.lock();
  if (!weights)
  {
    weights = this->HasRobustWeights
                ? std::make_shared<const CotangentWeights>(this->Mesh, computeRobustWeights())
                : std::make_shared<const CotangentWeights>(this->Mesh);
    this->Weights = weights;
    this->CountPart();
  }
  return weights;
}

std::shared_ptr<const CotangentWeights> CotangentQuantities::GetWeights() const
{
  return this->LockWeights(
    [this] { return ComputeRobustWeights(this->Mesh.GetPoints(), this->Mesh.GetTriangles()); });
}

std::shared_ptr<const CotangentWeights> CotangentQuantities::Prepare(
  LaplacianType type, bool hasDetailTarget, ProgressMonitor& monitor) const
{
  if (type == LaplacianType::UNIFORM && this->Curvatures &&
      (this->DetailTarget || !hasDetailTarget))
  {
    return nullptr;
  }
  const auto weights = this->LockWeights(
    [&]
    {
      return RunInBackground(monitor, [V = this->Mesh.GetPoints(), T = this->Mesh.GetTriangles()]
        { return ComputeRobustWeights(V, T); });
    });
  this->GetMeanCurvatures();
  if (hasDetailTarget)
  {
    this->GetDetailTarget();
  }
  return type == LaplacianType::UNIFORM ? nullptr : weights;
}

Laplacian CotangentQuantities::MakeLaplacian(LaplacianType type) const
{
  switch (type)
  {
    case LaplacianType::COTANGENT:
      return this->GetWeights()->MakeCotangentLaplacian();
    case LaplacianType::MEAN_CURVATURE:
      return this->GetWeights()->MakeMeanCurvatureLaplacian();
    default:
      return this->Mesh.GetUniformLaplacian();
  }
}

Points CotangentQuantities::ComputeMeanCurvatureNormals() const
{
  Points normals = MeanCurvatureNormals(this->MakeLaplacian(LaplacianType::MEAN_CURVATURE),
    this->Mesh.GetPoints(), this->Mesh.GetTopology());
  this->Mesh.GetSubdomain().UpdateGhosts(normals);
  return normals;
}

const Vector& CotangentQuantities::GetMeanCurvatures() const
{
  return this->Get(this->Curvatures,
    [&]
    {
      Vector curvatures = MeanCurvatures(
        this->ComputeMeanCurvatureNormals(), this->Mesh.GetDiagonal(), this->Mesh.GetTopology());
      this->Mesh.GetSubdomain().UpdateGhosts(curvatures);
      return curvatures;
    });
}

const CurvatureStatistics& CotangentQuantities::GetStatistics() const
{
  return this->Get(this->Statistics,
    [&]
    {
      return ComputeStatistics(
        this->GetMeanCurvatures(), this->Mesh.GetTopology().isUsed, this->Mesh.GetSubdomain());
    });
}

const Vector& CotangentQuantities::GetCumulativeWeights() const
{
  return this->Get(this->Cumulative,
    [&]
    {
      return CumulativeWeights(
        this->GetMeanCurvatures(), this->Mesh.GetTopology().isUsed, this->Mesh.GetSubdomain());
    });
}

std::shared_ptr<const Points> CotangentQuantities::GetDetailTarget() const
{
  return this->Get(this->DetailTarget,
    [&]
    {
      return std::make_shared<const Points>(ComputeDetailTarget(this->Mesh.GetUniformLaplacian(),
        this->MakeLaplacian(LaplacianType::COTANGENT), this->Mesh.GetPoints()));
    });
}
}
