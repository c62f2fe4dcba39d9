// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_TangentPlaneTerm_h
#define lmo_TangentPlaneTerm_h

#include "Core/Base/Types.h"

namespace lmo
{
/// Eqn. 15: w^2 sum_i (n_i d_i)^2.
struct TangentPlaneTerm
{
  Points normals;    ///< n_i; no rows if there are no tangent-plane constraints
  double weight = 0; ///< w
};
}

#endif
