// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_DirectSolver_h
#define lmo_DirectSolver_h

#include "LeastSquaresProblem.h"

namespace lmo
{
/// d = A^-1 b by a sparse factorisation of the normal equations: n x n for x, y and z at once, or
/// 3n x 3n where they are coupled.
/// \throw SolverError if A is singular.
Points SolveDirectly(const NormalEquations& equations, const Points& b);

/// A as a sparse matrix without regard to coupling: sum K Q K + W_p^2, n x n.
SparseMatrix FormMatrix(const NormalEquations& equations);
}

#endif
