// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_LeastSquaresProblem_txx
#define lmo_LeastSquaresProblem_txx

#include "Core/Base/Threading.h"

#include <cmath>

namespace lmo
{
template <typename Store>
double ComputeResidual(const LeastSquaresProblem& problem, const Points& d, const Store& store)
{
  const auto sumRows = [&](const auto&... rows)
  {
    return ParallelSum(problem.Size(), 0.0,
      [&, store = store](double& squaredNorm, Index i) mutable
      {
        Vector3 residual = Vector3::Zero();
        (rows(i, residual), ...);
        residual = problem.constraints.Project(i, residual);
        store(i, residual);
        squaredNorm += residual.squaredNorm();
      });
  };
  return std::sqrt(std::apply(
    [&](const auto&... terms) { return sumRows(terms.ResidualRows(d)...); }, problem.Terms()));
}
}

#endif
