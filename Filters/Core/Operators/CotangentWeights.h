// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_CotangentWeights_h
#define lmo_CotangentWeights_h

#include "Core/Operators/MeshQuantities.h"
#include "Core/Operators/RobustLaplacian.h"

namespace lmo
{
/// What L_c and L_ck of a mesh are made of: edge weights and Voronoi areas.
class CotangentWeights : public LazyParts
{
public:
  /// The weights of Eqn. 4, or ComputePolygonWeights() if the mesh has polygons.
  /// \param mesh must live longer
  explicit CotangentWeights(const MeshQuantities& mesh);

  /// \param weights what ComputeRobustWeights() returned for \a mesh
  CotangentWeights(const MeshQuantities& mesh, CotangentParts weights);

  const Vector& GetVoronoiAreas() const { return this->Weights.voronoiAreas; }

  /// L_c and L_ck.
  Laplacian MakeCotangentLaplacian() const;
  Laplacian MakeMeanCurvatureLaplacian() const;

  /// ClampedEdgeWeights() in the one-rings of L_c; null without needles, for robust weights, and
  /// for polygons.
  std::shared_ptr<const Vector> GetClampedEdgeWeights() const;

private:
  const MeshQuantities& Mesh;
  const bool IsRobust;
  const CotangentParts Weights;
  mutable std::optional<std::shared_ptr<const Vector>> ClampedWeights;
};
}

#endif
