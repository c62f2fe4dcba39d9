// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_MeshQuantities_h
#define lmo_MeshQuantities_h

#include "Core/Mesh/Subdomain.h"
#include "Core/Mesh/TriangleQuality.h"
#include "Core/Operators/Laplacian.h"
#include "Core/Operators/LazyParts.h"

#include <Eigen/Geometry>

namespace lmo
{
/// A mesh and what depends on it alone, not on the weights of a Laplacian.
class MeshQuantities : public LazyParts
{
public:
  /// \param triangles ids below the number of rows of \a V
  /// \param polygons to which the triangles belong; empty if the triangles are the cells
  /// \param subdomain what part of the whole mesh this is
  MeshQuantities(Points V, Triangles triangles, Polygons polygons = Polygons(),
    std::shared_ptr<const Subdomain> subdomain = std::make_shared<Subdomain>());

  const Points& GetPoints() const { return this->V; }
  const Triangles& GetTriangles() const { return this->T; }
  const MeshTopology& GetTopology() const { return *this->Topology; }
  const Polygons& GetPolygons() const { return this->Topology->polygons; }
  std::shared_ptr<const AdjacencyLists> GetOneRings() const;
  const Subdomain& GetSubdomain() const { return *this->Domain; }

  /// Bounding box of the vertices that a triangle uses, and its diagonal; as all that is no list,
  /// of the whole mesh.
  const Eigen::AlignedBox3d& GetBox() const { return this->Box; }
  double GetDiagonal() const { return this->Box.isEmpty() ? 0 : this->Box.diagonal().norm(); }

  /// An edge has exactly one cell.
  bool HasBoundary() const;

  /// At least one triangle, and no boundary.
  bool IsClosed() const { return !this->Box.isEmpty() && !this->HasBoundary(); }

  /// L_u.
  const Laplacian& GetUniformLaplacian() const;

  /// Eqn. 12, and CellQuality() of larger polygons.
  std::shared_ptr<const MeshQuality> GetQuality() const;

  /// Connected component of each vertex.
  const std::vector<Index>& GetComponents() const;

private:
  const Points V;
  const Triangles T;
  const std::shared_ptr<const MeshTopology> Topology;
  const std::shared_ptr<const Subdomain> Domain;
  const Eigen::AlignedBox3d Box;
  mutable std::optional<bool> Boundary;
  mutable std::optional<Laplacian> Uniform;
  mutable std::optional<std::shared_ptr<const MeshQuality>> Quality;
  mutable std::optional<std::vector<Index>> Components;
};
}

#endif
