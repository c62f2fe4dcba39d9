// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_DistributedDirectSolver_h
#define lmo_DistributedDirectSolver_h

#include "DistributedEquations.h"

namespace lmo
{
/// Factorises the matrix of the equations, with MUMPS or as the options -lmo_direct_... say, and
/// solves them. Collective.
/// \return displacements that are right at the ghosts too
/// \throw SolverError if the matrix is singular or PETSc lacks the package.
Points SolveDirectly(const DistributedEquations& equations);
}

#endif
