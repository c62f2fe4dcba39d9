// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Operators/CotangentWeights.h"

#include "Core/Mesh/TriangleGeometry.h"
#include "Core/Operators/PolygonLaplacian.h"

namespace lmo
{
namespace
{
/// Those of Eqns. 4 and 7, for polygons by virtual refinement.
CotangentParts ComputePlainWeights(const MeshQuantities& mesh)
{
  const Points& V = mesh.GetPoints();
  const Triangles& T = mesh.GetTriangles();
  if (!mesh.GetPolygons().IsEmpty())
  {
    return ComputePolygonWeights(V, T, mesh.GetPolygons());
  }
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

CotangentWeights::CotangentWeights(const MeshQuantities& mesh, CotangentParts weights)
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

std::shared_ptr<const Vector> CotangentWeights::GetClampedEdgeWeights() const
{
  return this->Get(this->ClampedWeights,
    [&]
    {
      const Triangles& T = this->Mesh.GetTriangles();
      const bool areOfEdges = !this->IsRobust && this->Mesh.GetPolygons().IsEmpty();
      return areOfEdges ? ClampedEdgeWeights(
                            this->Mesh.GetTopology(), T, Cotangents(this->Mesh.GetPoints(), T))
                        : nullptr;
    });
}
}
