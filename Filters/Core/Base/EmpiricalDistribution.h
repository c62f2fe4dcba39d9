// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_EmpiricalDistribution_h
#define lmo_EmpiricalDistribution_h

#include "Core/Base/Types.h"

namespace lmo
{
/// Value below which the share \a q, 0 to 1, of the values lies: linear between neighbouring order
/// statistics; 0 if there are no values.
double Quantile(std::vector<double> values, double q);

/// For each value the share, in [0, 1], of the values that count which are at most as large; ties
/// share the upper rank.
/// \param values >= 0
Vector CumulativeShares(const Vector& values, const Mask& counts);
}

#endif
