// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_PetscSolver_h
#define lmo_PetscSolver_h

#include "Core/Solvers/LinearSolver.h"
#include "DistributedSubdomain.h"

namespace lmo
{
/// Solve() for a problem on a distributed mesh. SolverPolicy chooses among conjugate gradients with
/// the diagonal as preconditioner, those of PETSc with multigrid, and a factorisation, with MUMPS.
/// Options of PETSc with the prefixes lmo_amg_ and lmo_direct_ change the last two; with options of
/// the prefixes lmo_ksp_ and lmo_pc_, PETSc does all iterations. Collective.
/// \return displacements that are right at the ghost vertices too
/// \throw SolverError for errors of PETSc, and as SolverPolicy does.
Solution SolveDistributed(const LeastSquaresProblem& problem, SolverType type,
  const SolverOptions& options, ProgressMonitor& monitor, const DistributedSubdomain& domain);
}

#endif
