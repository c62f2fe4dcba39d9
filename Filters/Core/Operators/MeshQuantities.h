// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_MeshQuantities_h
#define lmo_MeshQuantities_h

#include "Core/Base/ProgressMonitor.h"
#include "Core/Mesh/Subdomain.h"
#include "Core/Mesh/TriangleQuality.h"
#include "Core/Operators/Laplacian.h"
#include "Core/Operators/RobustLaplacian.h"
#include "Core/Operators/Weights.h"

#include <Eigen/Geometry>

#include <optional>

namespace lmo
{
/// What depends on the mesh alone: each part is computed when it is asked for the first time, and
/// kept.
class MeshQuantities
{
public:
  /// \param triangles ids below the number of rows of \a V
  /// \param subdomain what part of the whole mesh this is
  MeshQuantities(Points V, Triangles triangles,
    std::shared_ptr<const Subdomain> subdomain = std::make_shared<Subdomain>());
  MeshQuantities(const MeshQuantities&) = delete;
  void operator=(const MeshQuantities&) = delete;

  const Points& GetPoints() const { return this->V; }
  const Triangles& GetTriangles() const { return this->T; }
  const MeshTopology& GetTopology() const { return *this->Topology; }
  const Subdomain& GetSubdomain() const { return *this->Domain; }

  /// Bounding box of the vertices that a triangle uses, and its diagonal; as all that is no list,
  /// of the whole mesh.
  const Eigen::AlignedBox3d& GetBox() const { return this->Box; }
  double GetDiagonal() const { return this->Box.isEmpty() ? 0 : this->Box.diagonal().norm(); }

  /// An edge has exactly one triangle.
  bool HasBoundary();

  /// At least one triangle, and no boundary.
  bool IsClosed() { return !this->Box.isEmpty() && !this->HasBoundary(); }

  /// Whether L_c and L_ck have the weights of ComputeRobustWeights() instead of those of Eqn. 4.
  /// What follows from the other ones is forgotten.
  void SetRobustLaplacian(bool isRobust);

  /// Computes the robust weights now, which takes long, if GetMeanCurvatures() or GetLaplacian() of
  /// \a type need them.
  /// \throw Cancelled if the monitor says so.
  void PrepareRobustLaplacian(LaplacianType type, ProgressMonitor& monitor);

  /// L_u, L_c and L_ck.
  const Laplacian& GetLaplacian(LaplacianType type);

  /// SoftEdgeWeights() in the one-rings of L_c; null without needles, and for robust weights.
  std::shared_ptr<const Vector> GetSoftEdgeWeights();

  const Vector& GetVoronoiAreas();

  /// kappa n and kappa of Eqn. 7.
  const Points& GetMeanCurvatureNormals();
  const Vector& GetMeanCurvatures();

  const CurvatureStatistics& GetStatistics();

  /// C(kappa) of Eqn. 13.
  const Vector& GetCumulativeWeights();

  /// c = delta_c - L_u V of Eqn. 10, with delta_c no longer than the longest edge at the vertex:
  /// nearly degenerate triangles make it explode.
  std::shared_ptr<const Points> GetDetailTarget();

  /// Eqn. 12.
  std::shared_ptr<const MeshQuality> GetQuality();

  /// Connected component of each vertex.
  const std::vector<Index>& GetComponents();

  /// Forgets the parts that only lead to others, a third of the memory; they are computed anew when
  /// they are asked for. Keeps the Laplacian of \a type.
  void ReleaseIntermediateParts(LaplacianType type);

  /// How many parts have been computed so far.
  int GetNumberOfParts() const { return this->NumberOfParts; }

private:
  /// The part, computed by compute() if that has not been done.
  template <typename Part, typename Compute>
  const Part& Get(std::optional<Part>& part, const Compute& compute);

  std::shared_ptr<const AdjacencyLists> OneRings() const;

  /// Computes edge weights, their rings and Voronoi areas, which share the cotangents.
  void ComputeCotangentParts();

  void SetRobustWeights(RobustWeights weights);

  void ForgetWeights();

  const Points V;
  const Triangles T;
  const std::shared_ptr<const MeshTopology> Topology;
  const std::shared_ptr<const Subdomain> Domain;
  const Eigen::AlignedBox3d Box;
  int NumberOfParts = 1;
  bool IsRobust = false;
  std::shared_ptr<const AdjacencyLists> WeightRings; ///< to which EdgeWeights belong
  std::shared_ptr<const Vector> EdgeWeights;
  std::optional<std::shared_ptr<const Vector>> SoftWeights;
  Vector VoronoiAreas;
  std::optional<bool> Boundary;
  std::optional<Laplacian> Laplacians[3];
  std::optional<Points> CurvatureNormals;
  std::optional<Vector> Curvatures;
  std::optional<CurvatureStatistics> Statistics;
  std::optional<Vector> Cumulative;
  std::optional<std::shared_ptr<const Points>> DetailTarget;
  std::optional<std::shared_ptr<const MeshQuality>> Quality;
  std::optional<std::vector<Index>> Components;
};
}

#endif
