// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_ErrorAmplification_h
#define lmo_ErrorAmplification_h

#include "Core/Multigrid/ShiftedStiffness.h"

#include <vector>

namespace lmo
{
/// Unknowns of K + R at which an approximate inverse B has to be exact, of which no two are
/// connected: (K + R) Q (K + R) by way of B multiplies the error of B (K + R) in column i and row j
/// by sqrt(Q_i / Q_j). Where L is scaled by areas that differ by orders of magnitude (L_ck on thin
/// triangles), that would be much.
/// \return those that amplify most come first; none if they would be few
std::vector<Index> AmplifyingUnknowns(const ShiftedStiffness& matrix);
}

#endif
