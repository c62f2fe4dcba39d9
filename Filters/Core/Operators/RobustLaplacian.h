// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_RobustLaplacian_h
#define lmo_RobustLaplacian_h

#include "Core/Operators/Laplacian.h"

namespace lmo
{
/// What L_c and L_ck are made of.
struct RobustWeights
{
  std::shared_ptr<const AdjacencyLists> rings; ///< neighbours, which need not share a mesh edge
  std::shared_ptr<const Vector> edgeWeights;   ///< omega_ij >= 0 for each entry of rings
  Vector voronoiAreas;                         ///< their sum is the area of the surface
};

/// Cotangent weights of the mollified intrinsic Delaunay triangulation of the tufted cover (Sharp
/// and Crane 2020), half of those of the cover. Never negative, on any mesh; on a manifold mesh
/// whose triangulation is Delaunay they are those of Eqn. 4.
RobustWeights ComputeRobustWeights(const Points& V, const Triangles& triangles);
}

#endif
