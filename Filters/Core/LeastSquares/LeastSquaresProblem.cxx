// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/LeastSquares/LeastSquaresProblem.h"

namespace lmo
{
double Energy(const LeastSquaresProblem& problem, const Points& d)
{
  const Points still = Points::Zero(d.rows() > 0 ? 0 : problem.Size(), 3);
  const Points& x = d.rows() > 0 ? d : still;
  return std::apply(
    [&x](const auto&... terms) { return (terms.Energy(x) + ...); }, problem.Terms());
}

DiagonalBlock DiagonalAt(const LeastSquaresProblem& problem, Index i)
{
  DiagonalBlock block;
  std::apply([&](const auto&... terms) { (terms.AddDiagonal(i, block), ...); }, problem.Terms());
  block.isotropic = block.isotropic > 0 ? block.isotropic : 1;
  return block;
}

Points Residual(const LeastSquaresProblem& problem, const Points& d)
{
  Points residual(problem.Size(), 3);
  ComputeResidual(problem, d, [&](Index i, const Vector3& value) { residual.row(i) = value; });
  return residual;
}
}
