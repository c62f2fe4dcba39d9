// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_LinearSolver_h
#define lmo_LinearSolver_h

#include "Core/LeastSquares/LeastSquaresProblem.h"
#include "Core/Multigrid/MultilevelBasis.h"
#include "Core/Solvers/PreconditionerCache.h"
#include "Core/Solvers/SolverOptions.h"

namespace lmo
{
/// Solves a problem as SolverPolicy chooses.
/// \param inverses from problems before, which may help
/// \throw SolverError if a direct solution is asked for and the matrix is singular or too dense, or
/// its solution is worse than no displacement.
/// \throw Cancelled if the monitor says so.
Solution Solve(const LeastSquaresProblem& problem, SolverType type, const SolverOptions& options,
  ProgressMonitor& monitor, PreconditionerCache& inverses);

/// The same by conjugate gradients with the diagonal alone, for problems that are known to suit it.
/// \param guess of the displacement, within the displacements allowed; no rows stand for 0
Solution SolveByDiagonal(const LeastSquaresProblem& problem, const SolverOptions& options,
  ProgressMonitor& monitor, Points guess = Points(0, 3));

/// The same with a MultilevelPreconditioner, for problems with at most two free directions at each
/// vertex.
/// \param basis of this problem or of one with other weights and axes
/// \throw Cancelled if the monitor says so.
Solution SolveByLevels(const LeastSquaresProblem& problem, MultilevelBasis& basis,
  const SolverOptions& options, ProgressMonitor& monitor);
}

#endif
