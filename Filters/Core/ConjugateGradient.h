// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_ConjugateGradient_h
#define lmo_ConjugateGradient_h

#include "LinearSolver.h"

namespace lmo
{
/// Preconditioned conjugate gradients from d = 0, on x, y and z at once. Independent coordinates
/// have step lengths of their own and share the stopping test.
/// \throw Cancelled if the monitor says so; it is asked in every iteration.
Solution SolveIteratively(const NormalEquations& equations, const Points& b,
  const Preconditioner& preconditioner, const SolverOptions& options, Monitor& monitor);
}

#endif
