// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_LinearSolver_h
#define lmo_LinearSolver_h

#include "Monitor.h"
#include "Preconditioner.h"

namespace lmo
{
struct SolverOptions
{
  double tolerance = 1e-6;        ///< |b - A d| / |b| at which an iterative solver stops, in (0, 1)
  Index maximumIterations = 5000; ///< > 0
};

struct Solution
{
  Points displacement;         ///< d = V' - V
  Index iterations = 0;        ///< 0 from a direct solver
  double relativeResidual = 0; ///< |b - A d| / |b|, computed from the equations and d
};

/// How to solve the normal equations.
enum class SolverType
{
  AUTOMATIC, ///< iterative; direct if that does not reach the tolerance
  DIRECT,
  ITERATIVE
};

/// \throw SolverError if a direct solution is asked for and the matrix is singular.
/// \throw Cancelled if the monitor says so.
Solution Solve(const NormalEquations& equations, SolverType type, const SolverOptions& options,
  Monitor& monitor);

/// |b - A d| / |b|; 0 if b = 0.
double RelativeResidual(const NormalEquations& equations, const Points& b, const Points& d);
}

#endif
