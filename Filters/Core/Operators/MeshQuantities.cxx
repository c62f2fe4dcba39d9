// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Operators/MeshQuantities.h"

#include "Core/Mesh/TriangleGeometry.h"

#include <algorithm>

namespace lmo
{
MeshQuantities::MeshQuantities(
  Points V, Triangles triangles, Polygons polygons, std::shared_ptr<const Subdomain> subdomain)
  : V(std::move(V))
  , T(std::move(triangles))
  , Topology(std::make_shared<MeshTopology>(
      BuildTopology(static_cast<Index>(this->V.rows()), this->T, std::move(polygons))))
  , Domain(std::move(subdomain))
  , Box(this->Domain->Unite(BoundingBox(this->V, *this->Topology)))
{
}

std::shared_ptr<const AdjacencyLists> MeshQuantities::GetOneRings() const
{
  return { this->Topology, &this->Topology->oneRings };
}

bool MeshQuantities::HasBoundary() const
{
  return this->Get(this->Boundary,
    [&]
    {
      const Mask isBoundary = this->Domain->OwnedOf(this->Topology->isBoundary);
      const bool isHere = std::find(isBoundary.begin(), isBoundary.end(), 1) != isBoundary.end();
      return this->Domain->Maximum(isHere) > 0;
    });
}

const Laplacian& MeshQuantities::GetUniformLaplacian() const
{
  return this->Get(this->Uniform, [&] { return UniformLaplacian(this->GetOneRings()); });
}

std::shared_ptr<const MeshQuality> MeshQuantities::GetQuality() const
{
  return this->Get(this->Quality,
    [&]
    {
      return std::make_shared<const MeshQuality>(
        MeasureQuality(this->V, this->T, this->GetPolygons(), *this->Domain));
    });
}

const std::vector<Index>& MeshQuantities::GetComponents() const
{
  return this->Get(this->Components, [&] { return ConnectedComponents(this->Topology->oneRings); });
}
}
