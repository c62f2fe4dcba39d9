// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_DistributedSubdomain_h
#define lmo_DistributedSubdomain_h

#include "Core/Mesh/Subdomain.h"
#include "DistributedMesh.h"

namespace lmo
{
/// The part that this process has in a distributed mesh.
class DistributedSubdomain : public Subdomain
{
public:
  /// \param triangles of \a mesh
  DistributedSubdomain(std::shared_ptr<const DistributedMesh> mesh, const Triangles& triangles);

  const DistributedMesh& GetMesh() const { return *this->Mesh; }

  bool OwnsVertex(Index i) const override { return i < this->Mesh->GetNumberOfOwned(); }
  bool OwnsTriangle(Index t) const override { return this->IsTriangleOwned[t]; }
  double Sum(double value) const override;
  Eigen::Array4d Sum(const Eigen::Array4d& values) const override;
  double Norm(double part) const override;
  double Maximum(double value) const override;
  double Quantile(std::vector<double> values, double q) const override;
  Vector CumulativeShares(const Vector& values, const Mask& counts) const override;
  void UpdateGhosts(Vector& values) const override;
  void UpdateGhosts(Points& values) const override;
  void UpdateGhosts(Eigen::Array4Xf& values) const override;
  void UpdateGhosts(Eigen::Array4Xd& values) const override;
  void UniteFlags(const std::vector<Index>& component, Mask& flags) const override;
  void SumOverComponents(
    const std::vector<Index>& component, Eigen::ArrayXXd& values) const override;
  void ProjectOntoLines(
    const FeatureLines& features, const Points& V, Points& moved) const override;

private:
  /// For each component the largest row of a vertex that it is connected to.
  std::vector<double> UniteComponents(const std::vector<Index>& component, Index count) const;

  std::shared_ptr<const DistributedMesh> Mesh;
  Mask IsTriangleOwned;
};
}

#endif
