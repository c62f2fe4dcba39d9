// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_RobustLaplacian_h
#define lmo_RobustLaplacian_h

#include "Core/Operators/Laplacian.h"

namespace lmo
{
/// Cotangent weights of the mollified intrinsic Delaunay triangulation of the tufted cover (Sharp
/// and Crane 2020), half of those of the cover. Never negative, on any mesh; on a manifold mesh
/// whose triangulation is Delaunay they are those of Eqn. 4.
CotangentParts ComputeRobustWeights(const Points& V, const Triangles& triangles);
}

#endif
