// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_CotangentQuantities_h
#define lmo_CotangentQuantities_h

#include "Core/Base/ProgressMonitor.h"
#include "Core/Operators/CotangentWeights.h"
#include "Core/Operators/Weights.h"

namespace lmo
{
/// What depends on a mesh and on the weights of its L_c and L_ck. Another choice of weights is
/// another object.
class CotangentQuantities : public LazyParts
{
public:
  /// \param mesh must live longer
  /// \param isRobust L_c and L_ck have the weights of ComputeRobustWeights() instead of those of
  ///   Eqn. 4
  CotangentQuantities(const MeshQuantities& mesh, bool isRobust);

  const MeshQuantities& GetMesh() const { return this->Mesh; }
  bool IsRobust() const { return this->HasRobustWeights; }

  /// The weights. As they are a third of the memory of a run, they live only as long as a caller
  /// keeps them, and the functions below compute them anew if no caller does.
  std::shared_ptr<const CotangentWeights> GetWeights() const;

  /// Computes kappa, and if asked for the target of Eqn. 10, which share the weights. Robust
  /// weights take long; the monitor is asked meanwhile.
  /// \param type Laplacian for which the caller needs the weights
  /// \return the weights for the caller to keep; null for UNIFORM, which has none
  /// \throw Cancelled if the monitor says so.
  std::shared_ptr<const CotangentWeights> Prepare(
    LaplacianType type, bool hasDetailTarget, ProgressMonitor& monitor) const;

  /// L_u, L_c or L_ck.
  Laplacian MakeLaplacian(LaplacianType type) const;

  /// kappa n and kappa of Eqn. 7.
  Points ComputeMeanCurvatureNormals() const;
  const Vector& GetMeanCurvatures() const;

  const CurvatureStatistics& GetStatistics() const;

  /// C(kappa) of Eqn. 13.
  const Vector& GetCumulativeWeights() const;

  /// c = delta_c - L_u V of Eqn. 10, with delta_c no longer than the longest edge at the vertex:
  /// nearly degenerate triangles make it explode.
  std::shared_ptr<const Points> GetDetailTarget() const;

private:
  /// The weights, computed if no caller has them.
  template <typename Compute>
  std::shared_ptr<const CotangentWeights> LockWeights(const Compute& computeRobustWeights) const;

  const MeshQuantities& Mesh;
  const bool HasRobustWeights;
  mutable std::weak_ptr<const CotangentWeights> Weights;
  mutable std::optional<Vector> Curvatures;
  mutable std::optional<CurvatureStatistics> Statistics;
  mutable std::optional<Vector> Cumulative;
  mutable std::optional<std::shared_ptr<const Points>> DetailTarget;
};
}

#endif
