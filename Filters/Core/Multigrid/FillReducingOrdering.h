// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_FillReducingOrdering_h
#define lmo_FillReducingOrdering_h

#include "Core/Base/Types.h"

#ifdef LMO_USE_METIS
// MetisSupport uses std::cerr without including it.
#include <iostream>

#include <Eigen/MetisSupport>
#else
#include <Eigen/OrderingMethods>
#endif

namespace lmo
{
/// Order of the unknowns in which a factorisation has few entries.
#ifdef LMO_USE_METIS
using FillReducingOrdering = Eigen::MetisOrdering<Index>;
#else
using FillReducingOrdering = Eigen::AMDOrdering<Index>;
#endif
}

#endif
