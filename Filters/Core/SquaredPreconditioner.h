// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_SquaredPreconditioner_h
#define lmo_SquaredPreconditioner_h

#include "LeastSquaresProblem.h"
#include "Multigrid.h"

namespace lmo
{
/// M = (K + R) Q (K + R) with R = W_p / sqrt(Q): the square of a second-order operator, close to
/// A = K Q K + W_p^2 however different in size its two terms are. (K + R)^-1 is one multigrid
/// cycle. The couplings of x, y and z are left to the iteration.
class SquaredPreconditioner
{
public:
  static constexpr bool IsRowWise = false;

  /// Keeps references to the arguments.
  SquaredPreconditioner(const LeastSquaresProblem& problem, const PackedStiffness<float>& K);

  /// Computes M^-1 residual.
  void Prepare(const PackedPoints<float>& residual);

  PackedRow<float> Row(Index i, const PackedRow<float>&) const { return this->Result.col(i); }

private:
  const LeastSquaresProblem& Problem;
  Multigrid::Values InverseQ; ///< 0 at fixed vertices
  Multigrid Inverse;          ///< of K + R
  PackedPoints<float> Intermediate;
  PackedPoints<float> Result;
};
}

#endif
