// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solvers/JacobiPreconditioner.h"

#include "Core/Base/Threading.h"

#include <Eigen/LU>

#include <algorithm>

namespace lmo
{
namespace
{
/// The inverse of P B P within the displacements allowed, on which P projects; 0 on the others.
Matrix3 InverseWithin(
  const DisplacementConstraints& constraints, Index i, const DiagonalBlock& block)
{
  constexpr double smallestRatio = 1e-12; // keeps rounding from making B singular
  const double a = std::max(block.isotropic, smallestRatio * block.coupled.trace());
  if (constraints.freedom[i] == DisplacementConstraints::FREE)
  {
    return Matrix3(a * Matrix3::Identity() + block.coupled).inverse();
  }
  Matrix3 P;
  for (int c = 0; c < 3; ++c)
  {
    P.row(c) = constraints.Project(i, Vector3::Unit(c));
  }
  const Matrix3 B = a * Matrix3::Identity() + P * block.coupled * P;
  return P * B.inverse() * P;
}
}

template <typename Scalar>
JacobiPreconditioner<Scalar>::JacobiPreconditioner(const LeastSquaresProblem& problem)
{
  const Index size = problem.Size();
  const bool isCoupled = problem.HasCoupledTerms();
  this->InverseDiagonal.resize(isCoupled ? 0 : size);
  this->InverseBlocks.resize(12, isCoupled ? size : 0);
  ParallelFor(size,
    [&](Index i)
    {
      const DiagonalBlock block = DiagonalAt(problem, i);
      if (isCoupled)
      {
        StoreMatrix(InverseWithin(problem.constraints, i, block), i, this->InverseBlocks);
      }
      else
      {
        const bool isFixed = problem.constraints.freedom[i] == DisplacementConstraints::FIXED;
        this->InverseDiagonal[i] = static_cast<Scalar>(isFixed ? 0 : 1 / block.isotropic);
      }
    });
}

template class JacobiPreconditioner<float>;
template class JacobiPreconditioner<double>;
}
