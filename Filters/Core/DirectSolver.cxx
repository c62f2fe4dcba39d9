// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "DirectSolver.h"

#include "Exceptions.h"

#ifdef LMO_USE_CHOLMOD
#include <Eigen/CholmodSupport>
#else
#include <Eigen/SparseCholesky>
#endif
#ifdef LMO_USE_METIS
// MetisSupport uses std::cerr without including it.
#include <iostream>

#include <Eigen/MetisSupport>
#endif

namespace lmo
{
namespace
{
#ifdef LMO_USE_METIS
using Ordering = Eigen::MetisOrdering<Index>;
#else
using Ordering = Eigen::AMDOrdering<Index>;
#endif

#ifdef LMO_USE_CHOLMOD
using Factorisation = Eigen::CholmodSupernodalLLT<SparseMatrix, Eigen::Lower>;
#else
using Factorisation = Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower, Ordering>;
#endif

template <typename Values>
Values FactoriseAndSolve(const SparseMatrix& A, const Values& b)
{
  Factorisation factorisation(A);
  if (factorisation.info() == Eigen::Success)
  {
    Values x = factorisation.solve(b);
    if (factorisation.info() == Eigen::Success && x.allFinite())
    {
      return x;
    }
  }
  throw SolverError("The linear system is singular: the weights leave some points undetermined. "
                    "Give them position weights, or use the iterative solver.");
}

/// Replaces the rows and columns of fixed vertices and of vertices that no term touches by the
/// identity.
void EliminateFixed(const MotionConstraints& motion, SparseMatrix& A)
{
  A.prune(
    [&](Index row, Index column, double)
    {
      return row == column || (motion.freedom[row] != MotionConstraints::FIXED &&
                                motion.freedom[column] != MotionConstraints::FIXED);
    });
  for (Index i = 0; i < A.rows(); ++i)
  {
    double& diagonal = A.coeffRef(i, i);
    if (motion.freedom[i] == MotionConstraints::FIXED || diagonal == 0)
    {
      diagonal = 1;
    }
  }
}

/// P (A kron I + w^2 n n^T) P + (I - P), where P projects on the motion allowed; vertex i has the
/// rows 3i, 3i + 1, 3i + 2.
SparseMatrix FormCoupledMatrix(const NormalEquations& equations, const SparseMatrix& A)
{
  const MotionConstraints& motion = equations.GetProblem().motion;
  std::vector<Eigen::Triplet<double, Index>> entries;
  entries.reserve(9 * A.nonZeros());
  for (Index j = 0; j < A.cols(); ++j)
  {
    for (SparseMatrix::InnerIterator entry(A, j); entry; ++entry)
    {
      const Index i = entry.row();
      for (int d = 0; d < 3; ++d)
      {
        const Vector3 unit = Vector3::Unit(d);
        const Vector3 allowed = motion.Project(j, unit);
        Vector3 column = entry.value() * allowed;
        if (i == j)
        {
          column += equations.ApplyTangentPlane(i, allowed);
        }
        column = motion.Project(i, column);
        if (i == j)
        {
          column += unit - allowed;
        }
        for (int c = 0; c < 3; ++c)
        {
          if (column[c] != 0)
          {
            entries.emplace_back(3 * i + c, 3 * j + d, column[c]);
          }
        }
      }
    }
  }
  SparseMatrix coupled(3 * A.rows(), 3 * A.cols());
  coupled.setFromTriplets(entries.begin(), entries.end());
  return coupled;
}
}

SparseMatrix FormMatrix(const NormalEquations& equations)
{
  const LeastSquaresProblem& problem = equations.GetProblem();
  SparseMatrix A(equations.Size(), equations.Size());
  A.setIdentity();
  A = Vector(problem.positionWeights.array().square()).asDiagonal() * A;
  for (std::size_t term = 0; term < problem.terms.size(); ++term)
  {
    const SparseMatrix K = StiffnessMatrix(problem.terms[term].L);
    const SparseMatrix weighted = equations.RowWeights(term).asDiagonal() * K;
    A += SparseMatrix(K * weighted);
  }
  return A;
}

Points SolveDirectly(const NormalEquations& equations, const Points& b)
{
  SparseMatrix A = FormMatrix(equations);
  EliminateFixed(equations.GetProblem().motion, A);
  if (!equations.IsCoupled())
  {
    return FactoriseAndSolve(A, b);
  }
  const Vector stacked = Eigen::Map<const Vector>(b.data(), b.size());
  const Vector x = FactoriseAndSolve(FormCoupledMatrix(equations, A), stacked);
  return Eigen::Map<const Points>(x.data(), b.rows(), 3);
}
}
