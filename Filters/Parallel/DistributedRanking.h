// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_DistributedRanking_h
#define lmo_DistributedRanking_h

#include "Communicator.h"
#include "Core/Base/Types.h"

namespace lmo
{
/// The functions of Core/Base/EmpiricalDistribution.h for values >= 0 that are distributed over
/// processes; exact, and the same in every process. Collective.
double DistributedQuantile(const Communicator& comm, const std::vector<double>& values, double q);
Vector DistributedShares(const Communicator& comm, const Vector& values, const Mask& counts);
}

#endif
