// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solvers/JacobiPreconditioner.h"

#include "Core/Base/Threading.h"

namespace lmo
{
template <typename Scalar>
JacobiPreconditioner<Scalar>::JacobiPreconditioner(const LeastSquaresProblem& problem)
{
  const Index size = problem.Size();
  const bool hasPlanes = problem.tangentPlanes.normals.rows() > 0;
  const Vector diagonal = Diagonal(problem);
  this->InverseDiagonal.resize(size);
  this->Normals.resize(4, hasPlanes ? size : 0);
  this->NormalFactor.resize(hasPlanes ? size : 0);
  ParallelFor(size,
    [&](Index i)
    {
      const double a = diagonal[i];
      const auto freedom = problem.motion.freedom[i];
      double inverse = freedom == DisplacementConstraints::FIXED ? 0 : 1 / a;
      if (hasPlanes)
      {
        const double w = problem.tangentPlanes.weight * problem.tangentPlanes.weight;
        const Vector3 normal = problem.tangentPlanes.normals.row(i);
        const bool isFree = freedom == DisplacementConstraints::FREE;
        // Sherman-Morrison: (a I + w n n^T)^-1 = I / a - w / (a (a + w)) n n^T
        this->NormalFactor[i] = static_cast<Scalar>(isFree ? w / (a * (a + w)) : 0);
        this->Normals.col(i) << normal.transpose().array().template cast<Scalar>(), Scalar(0);
        if (freedom == DisplacementConstraints::ALONG_LINE)
        {
          const double slope = normal.dot(problem.motion.axes.row(i));
          inverse = 1 / (a + w * slope * slope);
        }
      }
      this->InverseDiagonal[i] = static_cast<Scalar>(inverse);
    });
}

template class JacobiPreconditioner<float>;
template class JacobiPreconditioner<double>;
}
