// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solvers/LinearSolver.h"

#include "Core/Base/Threading.h"
#include "Core/Solvers/BilaplacianPreconditioner.h"
#include "Core/Solvers/DirectSolver.h"

#include <cmath>
#include <sstream>
#include <utility>

namespace lmo
{
namespace
{
/// Predicted iterations above which multigrid pays for its setup.
constexpr Index AffordableJacobiIterations = 150;

/// Predicted iterations above which a factorisation, whose cost grows as size^1.5, pays.
Index AffordableMultigridIterations(Index size)
{
  return static_cast<Index>(40 + 0.25 * std::sqrt(size));
}

double ResidualNorm(const LeastSquaresProblem& problem, const Points& d)
{
  return ComputeResidual(problem, d, [](Index, const Vector3&) {});
}

bool IsSolved(const Solution& solution, const SolverOptions& options)
{
  return solution.relativeResidual <= options.tolerance;
}

bool IsFinished(const Solution& solution, const SolverOptions& options)
{
  return IsSolved(solution, options) || solution.iterations >= options.maximumIterations;
}

/// True if the energy is not above that of another displacement by more than round-off. Where the
/// matrix is nearly singular a small residual does not say so.
bool IsNoWorse(const LeastSquaresProblem& problem, const Points& d, const Points& other)
{
  constexpr double roundOff = 1e-9;
  return Energy(problem, d) <= (1 + roundOff) * Energy(problem, other);
}

/// Goes on from the solution so far; keeps it if no better one is found.
/// \param affordable as in ConjugateGradient::Run()
template <typename Preconditioner, typename Scalar>
void Iterate(NormalOperator<Scalar>& A, Preconditioner&& M, const SolverOptions& options,
  Index affordable, ProgressMonitor& monitor, Solution& solution)
{
  Solution next = solution;
  ConjugateGradient<Scalar, Preconditioner>(A.GetProblem(), A, M, Subdomain())
    .Run(options, affordable, monitor, next);
  solution.iterations = next.iterations;
  if (next.relativeResidual <= solution.relativeResidual &&
      IsNoWorse(A.GetProblem(), next.displacement, solution.displacement))
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
      const double rowWeight =
        WeightSum(problem.laplacian.L, i) * std::sqrt(problem.laplacian.RowWeight(i));
      const bool isFree = problem.motion.freedom[i] != DisplacementConstraints::FIXED;
      total += isFree && problem.position.weights[i] < rowWeight
                 ? problem.position.weights[i] / rowWeight
                 : 1;
    });
  return 11 * problem.Size() / sum;
}

/// Conjugate gradients with the cheapest preconditioner first, then with stronger ones.
/// \throw SolverError if K + R is singular to double precision.
void SolveIteratively(const LeastSquaresProblem& problem, const SolverOptions& options,
  ProgressMonitor& monitor, PreconditionerCache& inverses, Solution& solution)
{
  NormalOperator<float> A(problem);
  if (ExpectedJacobiIterations(problem) < AffordableJacobiIterations)
  {
    Iterate(A, JacobiPreconditioner<float>(problem), options, AffordableJacobiIterations, monitor,
      solution);
  }
  if (IsFinished(solution, options))
  {
    return;
  }
  monitor.Report(0);
  const auto soft = std::make_shared<const ShiftedStiffness>(
    problem, A.GetStiffness(), problem.laplacian.softEdgeWeights);
  Iterate(A,
    BilaplacianPreconditioner<Multigrid>(problem, soft, inverses.GetMultigrid(soft, monitor)),
    options, AffordableMultigridIterations(problem.Size()), monitor, solution);
  if (IsFinished(solution, options))
  {
    return;
  }
  monitor.Report(0);
  // What multigrid cannot cope with is nothing to a factorisation.
  const auto exact = problem.laplacian.softEdgeWeights
                       ? std::make_shared<const ShiftedStiffness>(problem, A.GetStiffness())
                       : soft;
  Iterate(A,
    BilaplacianPreconditioner<ShiftedCholesky>(
      problem, exact, inverses.GetFactorisation(exact, monitor)),
    options, options.maximumIterations, monitor, solution);
}

/// Double precision reaches what single precision cannot represent, such as weights of 1e-25.
void IterateInDouble(const LeastSquaresProblem& problem, const SolverOptions& options,
  ProgressMonitor& monitor, Solution& solution)
{
  NormalOperator<double> A(problem);
  Iterate(A, JacobiPreconditioner<double>(problem), options, options.maximumIterations, monitor,
    solution);
}

/// Takes the direct solution if it is closer; keeps what there is if the matrix is singular, and
/// the caller sees its residual.
void ImproveDirectly(
  const LeastSquaresProblem& problem, ProgressMonitor& monitor, Solution& solution)
{
  try
  {
    Points direct = SolveDirectly(problem, monitor);
    const double residual = ResidualNorm(problem, direct) / solution.rightHandSideNorm;
    if (residual < solution.relativeResidual && IsNoWorse(problem, direct, solution.displacement))
    {
      solution.displacement = std::move(direct);
      solution.relativeResidual = residual;
    }
  }
  catch (const SolverError&)
  {
  }
}

/// \throw SolverError if a solution is worse than no motion.
void CheckEnergy(const LeastSquaresProblem& problem, const Solution& solution)
{
  if (!IsNoWorse(problem, solution.displacement, {}))
  {
    std::ostringstream text;
    text << "The energy of the solver's result is " << Energy(problem, solution.displacement)
         << ", worse than that of the input, " << Energy(problem, {})
         << ": the system is nearly singular. Choose weights that differ less in size, or use the "
            "iterative solver.";
    throw SolverError(text.str());
  }
}

/// The residual of d = 0; solved if it is 0.
Solution Start(const LeastSquaresProblem& problem)
{
  Solution solution;
  solution.rightHandSideNorm = ResidualNorm(problem, solution.displacement);
  if (!(solution.rightHandSideNorm > 0))
  {
    solution.displacement = Points::Zero(problem.Size(), 3);
    solution.relativeResidual = 0;
  }
  return solution;
}
}

Solution SolveByDiagonal(const LeastSquaresProblem& problem, const SolverOptions& options,
  ProgressMonitor& monitor, Points guess)
{
  Solution solution = Start(problem);
  if (guess.rows() > 0 && !IsSolved(solution, options))
  {
    solution.displacement = std::move(guess);
    solution.relativeResidual =
      ResidualNorm(problem, solution.displacement) / solution.rightHandSideNorm;
  }
  if (!IsFinished(solution, options))
  {
    NormalOperator<float> A(problem);
    Iterate(A, JacobiPreconditioner<float>(problem), options, options.maximumIterations, monitor,
      solution);
  }
  if (solution.displacement.rows() == 0)
  {
    solution.displacement = Points::Zero(problem.Size(), 3);
  }
  if (!IsFinished(solution, options))
  {
    IterateInDouble(problem, options, monitor, solution);
  }
  return solution;
}

Solution Solve(const LeastSquaresProblem& problem, SolverType type, const SolverOptions& options,
  ProgressMonitor& monitor, PreconditionerCache& inverses)
{
  Solution solution = Start(problem);
  if (IsSolved(solution, options))
  {
    return solution;
  }
  if (type == SolverType::DIRECT)
  {
    monitor.Report(0);
    solution.displacement = SolveDirectly(problem, monitor);
    solution.relativeResidual =
      ResidualNorm(problem, solution.displacement) / solution.rightHandSideNorm;
    CheckEnergy(problem, solution);
    return solution;
  }
  try
  {
    SolveIteratively(problem, options, monitor, inverses, solution);
  }
  catch (const SolverError&)
  {
    // What follows decides.
  }
  if (solution.displacement.rows() == 0)
  {
    solution.displacement = Points::Zero(problem.Size(), 3);
  }
  if (!IsSolved(solution, options) && type == SolverType::AUTOMATIC)
  {
    ImproveDirectly(problem, monitor, solution);
  }
  if (!IsFinished(solution, options))
  {
    IterateInDouble(problem, options, monitor, solution);
  }
  return solution;
}
}
