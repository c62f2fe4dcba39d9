// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_Preconditioner_h
#define lmo_Preconditioner_h

#include "LeastSquaresProblem.h"

namespace lmo
{
/// A symmetric positive definite approximation of the inverse of the normal equations' matrix.
class Preconditioner
{
public:
  virtual ~Preconditioner() = default;

  /// result = M^-1 residual, within the motion allowed.
  virtual void Apply(const Points& residual, Points& result) const = 0;
};

/// The inverse of the diagonal of A; with tangent-plane constraints of its 3 x 3 diagonal blocks.
class JacobiPreconditioner : public Preconditioner
{
public:
  /// Keeps a reference to \a equations.
  explicit JacobiPreconditioner(const NormalEquations& equations);

  void Apply(const Points& residual, Points& result) const override;

private:
  /// (a I + w^2 n n^T)^-1 x, or its restriction to the line along which the vertex moves.
  Vector3 SolveBlock(Index i, const Vector3& x) const;

  const LeastSquaresProblem& Problem;
  Vector Diagonal;
};
}

#endif
