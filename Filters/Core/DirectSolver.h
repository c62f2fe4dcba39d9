// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_DirectSolver_h
#define lmo_DirectSolver_h

#include "LeastSquaresProblem.h"

namespace lmo
{
/// Solves the normal equations of a problem by a sparse factorisation: n x n for x, y and z at
/// once, or 3n x 3n where they are coupled. \throw SolverError if the matrix is singular or too
/// dense.
Points SolveDirectly(const LeastSquaresProblem& problem);
}

#endif
