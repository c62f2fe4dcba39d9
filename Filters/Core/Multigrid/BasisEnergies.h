// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_BasisEnergies_h
#define lmo_BasisEnergies_h

#include "Core/LeastSquares/LeastSquaresProblem.h"
#include "Core/Multigrid/SparseProduct.h"

namespace lmo
{
/// The energies of functions w as displacements: half the sum over x, y and z, with their unit
/// vectors e, of d^T A d for the displacements d_i = P_i (w_i e), where P_i projects on what the
/// constraints allow. Of A, the terms of positions, Laplacians and polylines are taken.
/// \param functions a row for each vertex, a column for each function
Eigen::ArrayXf BasisEnergies(const LeastSquaresProblem& problem, const SparseRows& functions);
}

#endif
