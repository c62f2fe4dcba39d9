// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LinearSolver.h"

#include "DirectSolver.h"

namespace lmo
{
namespace
{
double ResidualNorm(const LeastSquaresProblem& problem, const Points& d)
{
  return ComputeResidual(problem, d, [](Index, const Vector3&) {});
}

bool IsSolved(const Solution& solution, const SolverOptions& options)
{
  return solution.relativeResidual <= options.tolerance;
}

/// Goes on from the solution so far.
template <typename Scalar>
void Iterate(const LeastSquaresProblem& problem, const SolverOptions& options, Monitor& monitor,
  Solution& solution)
{
  PackedEquations<Scalar> A(problem);
  JacobiPreconditioner<Scalar> M(problem);
  ConjugateGradient<Scalar, JacobiPreconditioner<Scalar>>(problem, A, M)
    .Run(options, monitor, solution);
  if (!solution.displacement.allFinite())
  {
    solution.displacement.setZero();
    solution.relativeResidual = 1;
  }
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
  solution.displacement = Points::Zero(problem.Size(), 3);
  solution.rightHandSideNorm = ResidualNorm(problem, solution.displacement);
  if (!(solution.rightHandSideNorm > 0))
  {
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
  solution.relativeResidual = 1;
  Iterate<float>(problem, options, monitor, solution);
  if (!IsSolved(solution, options) && solution.iterations < options.maximumIterations)
  {
    Iterate<double>(problem, options, monitor, solution);
  }
  if (!IsSolved(solution, options) && type == SolverType::AUTOMATIC)
  {
    ImproveDirectly(problem, solution);
  }
  return solution;
}
}
