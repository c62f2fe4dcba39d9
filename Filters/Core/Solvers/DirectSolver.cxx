// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solvers/DirectSolver.h"

#include "Core/Base/BackgroundTask.h"
#include "Core/Base/Exceptions.h"
#include "Core/Multigrid/FillReducingOrdering.h"

#include <algorithm>
#include <cmath>

#ifdef LMO_USE_CHOLMOD
#include <Eigen/CholmodSupport>
#else
#include <Eigen/SparseCholesky>
#endif

namespace lmo
{
namespace
{
#ifdef LMO_USE_CHOLMOD
using Factorisation = Eigen::CholmodSupernodalLLT<SparseMatrix, Eigen::Lower>;
#else
using Factorisation = Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower, FillReducingOrdering>;
#endif

[[noreturn]] void ThrowSingular()
{
  throw SolverError("The linear system is singular: the weights leave some points undetermined. "
                    "Give them position weights, or use the iterative solver.");
}

/// A vertex with n neighbours makes a full block of n x n entries: with ten thousand neighbours
/// more than the memory of most machines holds.
/// \throw SolverError if the entries are too many.
void CheckDensity(const LeastSquaresProblem& problem)
{
  constexpr double entriesPerVertex = 500;
  constexpr double affordableEntries = 1e7;
  const AdjacencyLists& rings = *problem.laplacian.L.rings;
  double entries = 0;
  Index largest = 0;
  for (Index i = 0; i < problem.Size(); ++i)
  {
    const double size = problem.laplacian.L.rowScale[i] != 0 ? rings.Size(i) : 0;
    entries += size * size;
    largest = std::max(largest, rings.Size(i));
  }
  if (entries > affordableEntries + entriesPerVertex * problem.Size())
  {
    throw SolverError("The matrix of the direct solver would have " +
                      std::to_string(std::llround(entries)) +
                      " entries because of points with up to " + std::to_string(largest) +
                      " neighbours; use the iterative solver.");
  }
}

/// Replaces the rows and columns of fixed vertices and of vertices that no term touches by the
/// identity.
void EliminateFixed(const DisplacementConstraints& constraints, SparseMatrix& A)
{
  A.prune(
    [&](Index row, Index column, double)
    {
      return row == column || (constraints.freedom[row] != DisplacementConstraints::FIXED &&
                                constraints.freedom[column] != DisplacementConstraints::FIXED);
    });
  for (Index i = 0; i < A.rows(); ++i)
  {
    double& diagonal = A.coeffRef(i, i);
    if (constraints.freedom[i] == DisplacementConstraints::FIXED || diagonal == 0)
    {
      diagonal = 1;
    }
  }
}

/// P (A kron I + blocks) P + (I - P), where P projects on the displacements allowed; vertex i has
/// the rows 3i, 3i + 1, 3i + 2.
SparseMatrix FormCoupledMatrix(const DisplacementConstraints& constraints, const SparseMatrix& A,
  const std::vector<BlockEntry>& blocks)
{
  std::vector<Eigen::Triplet<double, Index>> entries;
  entries.reserve(9 * (A.nonZeros() + blocks.size()));
  const auto addColumn = [&](Index i, Index j, int d, const Vector3& column)
  {
    for (int c = 0; c < 3; ++c)
    {
      if (column[c] != 0)
      {
        entries.emplace_back(3 * i + c, 3 * j + d, column[c]);
      }
    }
  };
  const auto addBlock = [&](Index i, Index j, const Matrix3& block)
  {
    for (int d = 0; d < 3; ++d)
    {
      addColumn(i, j, d, constraints.Project(i, constraints.Project(j, Vector3::Unit(d)) * block));
    }
  };
  for (Index j = 0; j < A.cols(); ++j)
  {
    for (SparseMatrix::InnerIterator entry(A, j); entry; ++entry)
    {
      addBlock(entry.row(), j, entry.value() * Matrix3::Identity());
    }
    for (int d = 0; d < 3; ++d)
    {
      const Vector3 unit = Vector3::Unit(d);
      addColumn(j, j, d, unit - constraints.Project(j, unit));
    }
  }
  for (const BlockEntry& block : blocks)
  {
    addBlock(block.row, block.column, block.value);
  }
  SparseMatrix coupled(3 * A.rows(), 3 * A.cols());
  coupled.setFromTriplets(entries.begin(), entries.end());
  return coupled;
}
}

SparseMatrix NormalMatrix(const LeastSquaresProblem& problem)
{
  CheckDensity(problem);
  MatrixEntries entries;
  std::apply([&](const auto&... terms) { (terms.AddEntries(entries), ...); }, problem.Terms());
  SparseMatrix A(problem.Size(), problem.Size());
  A.setFromTriplets(entries.isotropic.begin(), entries.isotropic.end());
  EliminateFixed(problem.constraints, A);
  return problem.IsCoupled() ? FormCoupledMatrix(problem.constraints, A, entries.coupled) : A;
}

namespace
{
Points FactoriseAndSolve(const LeastSquaresProblem& problem)
{
  const bool isCoupled = problem.IsCoupled();
  const Factorisation factorisation(NormalMatrix(problem));
  if (factorisation.info() != Eigen::Success)
  {
    ThrowSingular();
  }
  Points d = Points::Zero(problem.Size(), 3);
  // The second step removes most of what the formation of L^T L cost in digits.
  for (int step = 0; step < 2; ++step)
  {
    const Points residual = Residual(problem, d);
    if (isCoupled)
    {
      const Eigen::Map<const Vector> stacked(residual.data(), residual.size());
      const Vector correction = factorisation.solve(stacked);
      d += Eigen::Map<const Points>(correction.data(), residual.rows(), 3);
    }
    else
    {
      d += factorisation.solve(residual);
    }
  }
  if (!d.allFinite())
  {
    ThrowSingular();
  }
  return d;
}
}

Points SolveDirectly(const LeastSquaresProblem& problem, ProgressMonitor& monitor)
{
  return RunInBackground(monitor, [copy = std::make_shared<const LeastSquaresProblem>(problem)]
    { return FactoriseAndSolve(*copy); });
}
}
