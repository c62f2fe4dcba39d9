// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_DirectSolver_h
#define lmo_DirectSolver_h

#include "Core/Base/ProgressMonitor.h"
#include "Core/LeastSquares/LeastSquaresProblem.h"

namespace lmo
{
/// The matrix A of the normal equations, formed: n x n for x, y and z alike, or, if the problem is
/// coupled, 3n x 3n with the rows 3i, 3i + 1, 3i + 2 for vertex i. A displacement that is not
/// allowed has rows and columns of the identity.
SparseMatrix NormalMatrix(const LeastSquaresProblem& problem);

/// Solves the normal equations of a problem by a sparse factorisation: n x n for x, y and z at
/// once, or 3n x 3n where they are coupled.
/// \throw SolverError if the matrix is singular or too dense.
/// \throw Cancelled if the monitor says so.
Points SolveDirectly(const LeastSquaresProblem& problem, ProgressMonitor& monitor);
}

#endif
