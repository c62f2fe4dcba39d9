// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Preconditioner.h"

#include "Parallel.h"

namespace lmo
{
JacobiPreconditioner::JacobiPreconditioner(const NormalEquations& equations)
  : Problem(equations.GetProblem())
  , Diagonal(equations.Diagonal())
{
}

void JacobiPreconditioner::Apply(const Points& residual, Points& result) const
{
  ParallelFor(static_cast<Index>(residual.rows()),
    [&](Index i) { result.row(i) = this->SolveBlock(i, residual.row(i)); });
}

Vector3 JacobiPreconditioner::SolveBlock(Index i, const Vector3& x) const
{
  const double a = this->Diagonal[i];
  if (this->Problem.tangentPlaneNormals.rows() == 0)
  {
    return x / a;
  }
  const Vector3 n = this->Problem.tangentPlaneNormals.row(i);
  const double squaredWeight = this->Problem.tangentPlaneWeight * this->Problem.tangentPlaneWeight;
  if (this->Problem.motion.freedom[i] == MotionConstraints::ALONG_LINE)
  {
    const double slope = n.dot(this->Problem.motion.tangents.row(i));
    return x / (a + squaredWeight * slope * slope);
  }
  // Sherman-Morrison; n has unit length, or length 0 where there is no normal.
  return (x - squaredWeight / (a + squaredWeight) * n.dot(x) * n) / a;
}
}
