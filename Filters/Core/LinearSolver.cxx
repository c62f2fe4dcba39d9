// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LinearSolver.h"

#include "DirectSolver.h"
#include "Multigrid.h"
#include "Parallel.h"
#include "SquaredPreconditioner.h"
#include "StiffnessFactorisation.h"

#include <cmath>

namespace lmo
{
namespace
{
/// Predicted iterations above which another preconditioner pays for its setup.
constexpr Index AffordableJacobiIterations = 150;
constexpr Index AffordableMultigridIterations = 60;

double ResidualNorm(const LeastSquaresProblem& problem, const Points& d)
{
  return ComputeResidual(problem, d, [](Index, const Vector3&) {});
}

bool IsSolved(const Solution& solution, const SolverOptions& options)
{
  return solution.relativeResidual <= options.tolerance;
}

/// Goes on from the solution so far, unless it is good enough; keeps it if no better one is found.
/// \tparam Preconditioner made from \a sources
/// \param affordable as in ConjugateGradient::Run()
template <typename Preconditioner, typename Scalar, typename... Sources>
void Iterate(PackedEquations<Scalar>& A, const SolverOptions& options, Index affordable,
  Monitor& monitor, Solution& solution, const Sources&... sources)
{
  if (IsSolved(solution, options) || solution.iterations >= options.maximumIterations)
  {
    return;
  }
  monitor.Report(0);
  Preconditioner M(sources...);
  Solution next = solution;
  ConjugateGradient<Scalar, Preconditioner>(A.GetProblem(), A, M)
    .Run(options, affordable, monitor, next);
  solution.iterations = next.iterations;
  if (next.relativeResidual <= solution.relativeResidual)
  {
    solution = std::move(next);
  }
}

/// Rough guess of the iterations that the Jacobi preconditioner needs: about 11 over a typical
/// ratio of W_p to the weights of L, whose square is the smallest eigenvalue.
double ExpectedJacobiIterations(const LeastSquaresProblem& problem)
{
  const double sum = ParallelSum(problem.Size(), 0.0,
    [&](double& total, Index i)
    {
      const double rowWeight = WeightSum(problem.L, i) * std::sqrt(RowWeight(problem, i));
      const bool isFree = problem.motion.freedom[i] != MotionConstraints::FIXED;
      total += isFree && problem.positionWeights[i] < rowWeight
                 ? problem.positionWeights[i] / rowWeight
                 : 1;
    });
  return 11 * problem.Size() / sum;
}

/// Conjugate gradients with the cheapest preconditioner first, then with stronger ones.
void SolveIteratively(const LeastSquaresProblem& problem, const SolverOptions& options,
  Monitor& monitor, Solution& solution)
{
  PackedEquations<float> A(problem);
  if (ExpectedJacobiIterations(problem) < AffordableJacobiIterations)
  {
    Iterate<JacobiPreconditioner<float>>(
      A, options, AffordableJacobiIterations, monitor, solution, problem);
  }
  if (IsSolved(solution, options))
  {
    return;
  }
  const ShiftedStiffness matrix(problem, A.GetStiffness());
  Iterate<SquaredPreconditioner<Multigrid>>(
    A, options, AffordableMultigridIterations, monitor, solution, problem, matrix);
  try
  {
    Iterate<SquaredPreconditioner<StiffnessFactorisation>>(
      A, options, options.maximumIterations, monitor, solution, problem, matrix);
  }
  catch (const SolverError&)
  {
    // K + R is singular to double precision; what follows decides.
  }
}

/// Double precision reaches what single precision cannot represent, such as weights of 1e-25.
void IterateInDouble(const LeastSquaresProblem& problem, const SolverOptions& options,
  Monitor& monitor, Solution& solution)
{
  PackedEquations<double> A(problem);
  Iterate<JacobiPreconditioner<double>>(
    A, options, options.maximumIterations, monitor, solution, problem);
}

/// Takes the direct solution if it is closer; keeps what there is if the matrix is singular, and
/// the caller sees its residual.
void ImproveDirectly(const LeastSquaresProblem& problem, Solution& solution)
{
  try
  {
    Points direct = SolveDirectly(problem);
    const double residual = ResidualNorm(problem, direct) / solution.rightHandSideNorm;
    if (residual < solution.relativeResidual)
    {
      solution.displacement = std::move(direct);
      solution.relativeResidual = residual;
    }
  }
  catch (const SolverError&)
  {
  }
}
}

Solution Solve(const LeastSquaresProblem& problem, SolverType type, const SolverOptions& options,
  Monitor& monitor)
{
  Solution solution;
  solution.rightHandSideNorm = ResidualNorm(problem, solution.displacement);
  if (!(solution.rightHandSideNorm > 0))
  {
    solution.displacement = Points::Zero(problem.Size(), 3);
    solution.relativeResidual = 0;
    return solution;
  }
  if (type == SolverType::DIRECT)
  {
    monitor.Report(0);
    solution.displacement = SolveDirectly(problem);
    solution.relativeResidual =
      ResidualNorm(problem, solution.displacement) / solution.rightHandSideNorm;
    return solution;
  }
  SolveIteratively(problem, options, monitor, solution);
  if (solution.displacement.rows() == 0)
  {
    solution.displacement = Points::Zero(problem.Size(), 3);
  }
  if (!IsSolved(solution, options))
  {
    type == SolverType::AUTOMATIC ? ImproveDirectly(problem, solution)
                                  : IterateInDouble(problem, options, monitor, solution);
  }
  return solution;
}
}
