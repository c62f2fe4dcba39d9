// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Operators/CotangentWeights.h"

#include "Core/Mesh/TriangleGeometry.h"

namespace lmo
{
namespace
{
/// Edge weights and Voronoi areas share the cotangents.
RobustWeights ComputePlainWeights(const MeshQuantities& mesh)
{
  const Points& V = mesh.GetPoints();
  const Triangles& T = mesh.GetTriangles();
  const CornerValues cotangents = Cotangents(V, T);
  return { mesh.GetOneRings(), CotangentEdgeWeights(mesh.GetTopology(), T, cotangents),
    MixedVoronoiAreas(V, T, mesh.GetTopology(), cotangents) };
}
}

CotangentWeights::CotangentWeights(const MeshQuantities& mesh)
  : Mesh(mesh)
  , IsRobust(false)
  , Weights(ComputePlainWeights(mesh))
{
}

CotangentWeights::CotangentWeights(const MeshQuantities& mesh, RobustWeights weights)
  : Mesh(mesh)
  , IsRobust(true)
  , Weights(std::move(weights))
{
}

Laplacian CotangentWeights::MakeCotangentLaplacian() const
{
  return CotangentLaplacian(this->Weights.rings, this->Weights.edgeWeights);
}

Laplacian CotangentWeights::MakeMeanCurvatureLaplacian() const
{
  return MeanCurvatureLaplacian(
    this->Weights.rings, this->Weights.edgeWeights, this->Weights.voronoiAreas);
}

std::shared_ptr<const Vector> CotangentWeights::GetSoftEdgeWeights() const
{
  return this->Get(this->SoftWeights,
    [&]
    {
      const Triangles& T = this->Mesh.GetTriangles();
      return this->IsRobust ? nullptr
                            : SoftEdgeWeights(
                                this->Mesh.GetTopology(), T, Cotangents(this->Mesh.GetPoints(), T));
    });
}
}
