// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_DistributedSolver_h
#define lmo_DistributedSolver_h

#include "../Core/LinearSolver.h"
#include "DistributedMesh.h"

namespace lmo
{
/// Solve() for a problem on a distributed mesh, by PETSc's conjugate gradients: with the diagonal
/// as preconditioner and, if that takes too many iterations, with multigrid; then, as the direct
/// solver does from the start, by a factorisation, with MUMPS. Options of PETSc with the prefixes
/// lmo_, lmo_amg_ and lmo_direct_ change these. Collective.
/// \return displacements that are right at the copies too
/// \throw SolverError for errors of PETSc, and if the matrix is singular.
Solution SolveDistributed(const LeastSquaresProblem& problem, SolverType type,
  const SolverOptions& options, Monitor& monitor, const DistributedMesh& mesh);
}

#endif
