// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_SolverOptions_h
#define lmo_SolverOptions_h

#include "Core/Base/Types.h"

namespace lmo
{
/// How to solve a least-squares problem. The iterative solution is that of conjugate gradients,
/// whose preconditioner is chosen by how the residual falls: the diagonal, (K + R) Q (K + R) by
/// multigrid, or the same by a factorisation of K + R.
enum class SolverType
{
  AUTOMATIC, ///< iterative; direct if that does not reach the tolerance
  DIRECT,
  ITERATIVE
};

struct SolverOptions
{
  double tolerance = 1e-6;        ///< |b - A d| / |b| at which an iterative solver stops, in (0, 1)
  Index maximumIterations = 5000; ///< > 0
};

struct Solution
{
  Points displacement;          ///< d = V' - V; no rows stand for 0
  Index iterations = 0;         ///< 0 from a direct solver
  double rightHandSideNorm = 0; ///< |b|
  double relativeResidual = 1;  ///< |b - A d| / |b|, computed from the problem and d

  /// Gives d rows that are 0 if it has none.
  void ProvideRows(Index size)
  {
    if (this->displacement.rows() == 0)
    {
      this->displacement = Points::Zero(size, 3);
    }
  }
};
}

#endif
