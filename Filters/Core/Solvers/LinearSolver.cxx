// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solvers/LinearSolver.h"

#include "Core/Base/Threading.h"
#include "Core/Solvers/BilaplacianPreconditioner.h"
#include "Core/Solvers/ConjugateGradient.h"
#include "Core/Solvers/DirectSolver.h"
#include "Core/Solvers/MultilevelPreconditioner.h"
#include "Core/Solvers/SolverPolicy.h"

#include <cmath>
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

/// Rough guess of the iterations that the Jacobi preconditioner needs: about 11 over a typical
/// ratio of W_p to the weights of L, whose square is the smallest eigenvalue.
double ExpectedJacobiIterations(const LeastSquaresProblem& problem)
{
  const double sum = ParallelSum(problem.Size(), 0.0,
    [&](double& total, Index i)
    {
      const double rowWeight =
        WeightSum(problem.laplacian.L, i) * std::sqrt(problem.laplacian.RowWeight(i));
      const bool isFree = problem.constraints.freedom[i] != DisplacementConstraints::FIXED;
      total += isFree && problem.position.weights[i] < rowWeight
                 ? problem.position.weights[i] / rowWeight
                 : 1;
    });
  return 11 * problem.Size() / sum;
}

/// Goes on from a solution.
/// \param affordable as in ConjugateGradient::Run()
template <typename Preconditioner, typename Scalar>
Solution Iterate(NormalOperator<Scalar>& A, Preconditioner M, const SolverOptions& options,
  Index affordable, ProgressMonitor& monitor, Solution solution)
{
  ConjugateGradient<Scalar, Preconditioner>(A.GetProblem(), A, M, Subdomain())
    .Run(options, affordable, monitor, solution);
  return solution;
}

/// The solvers of one process that holds the mesh whole. The stages are conjugate gradients in
/// single precision with one preconditioner after the other.
class LocalSolvers : public SolverFamily
{
public:
  /// Keeps references to the arguments.
  LocalSolvers(const LeastSquaresProblem& problem, const SolverOptions& options,
    ProgressMonitor& monitor, PreconditionerCache& inverses)
    : Problem(problem)
    , Options(options)
    , Monitor(monitor)
    , Inverses(inverses)
  {
  }

  double GetEnergy(const Points& d) const override { return Energy(this->Problem, d); }

  std::vector<IterativeStage> GetStages() override
  {
    this->A = std::make_unique<NormalOperator<float>>(this->Problem);
    return {
      { AffordableJacobiIterations, ExpectedJacobiIterations(this->Problem),
        [this](Index affordable, const Solution& start)
        { return this->IterateWithDiagonal(affordable, start); } },
      { AffordableMultigridIterations(this->Problem.Size()), 0,
        [this](Index affordable, const Solution& start)
        { return this->IterateWithMultigrid(affordable, start); } },
      { this->Options.maximumIterations, 0,
        [this](Index affordable, const Solution& start)
        { return this->IterateWithFactorisation(affordable, start); } },
    };
  }

  Points SolveDirectly() override
  {
    this->ReleaseStages();
    return lmo::SolveDirectly(this->Problem, this->Monitor);
  }

  Solution IterateInDouble(const Solution& start) override
  {
    this->ReleaseStages();
    NormalOperator<double> A(this->Problem);
    return Iterate(A, JacobiPreconditioner<double>(this->Problem), this->Options,
      this->Options.maximumIterations, this->Monitor, start);
  }

private:
  Solution IterateWithDiagonal(Index affordable, const Solution& start)
  {
    return Iterate(*this->A, JacobiPreconditioner<float>(this->Problem), this->Options, affordable,
      this->Monitor, start);
  }

  /// Multigrid converges faster with clamped cotangents.
  Solution IterateWithMultigrid(Index affordable, const Solution& start)
  {
    this->Monitor.Report(0);
    this->Shifted = std::make_shared<const ShiftedStiffness>(
      this->Problem, this->A->GetStiffness(), this->Problem.laplacian.clampedEdgeWeights);
    return this->IterateWith(
      this->Inverses.GetMultigrid(this->Shifted, this->Monitor), affordable, start);
  }

  /// A factorisation serves where the V-cycle converges slowly. It needs no clamped cotangents.
  Solution IterateWithFactorisation(Index affordable, const Solution& start)
  {
    this->Monitor.Report(0);
    if (!this->Shifted || this->Problem.laplacian.clampedEdgeWeights)
    {
      this->Shifted =
        std::make_shared<const ShiftedStiffness>(this->Problem, this->A->GetStiffness());
    }
    try
    {
      return this->IterateWith(
        this->Inverses.GetFactorisation(this->Shifted, this->Monitor), affordable, start);
    }
    catch (const SolverError&)
    {
      return start; // K + R is singular to double precision
    }
  }

  template <typename Inverse>
  Solution IterateWith(std::shared_ptr<Inverse> inverse, Index affordable, const Solution& start)
  {
    return Iterate(*this->A,
      BilaplacianPreconditioner<Inverse>(this->Problem, this->Shifted, std::move(inverse)),
      this->Options, affordable, this->Monitor, start);
  }

  /// Their memory serves for what follows.
  void ReleaseStages()
  {
    this->A.reset();
    this->Shifted.reset();
  }

  const LeastSquaresProblem& Problem;
  const SolverOptions& Options;
  ProgressMonitor& Monitor;
  PreconditionerCache& Inverses;
  std::unique_ptr<NormalOperator<float>> A;
  std::shared_ptr<const ShiftedStiffness> Shifted; ///< of the last stage that had one
};

/// By conjugate gradients with one preconditioner, in single and, if need be, in double precision.
template <typename MakePreconditioner>
Solution SolveWith(const MakePreconditioner& make, const LeastSquaresProblem& problem,
  const SolverOptions& options, ProgressMonitor& monitor, Points guess)
{
  const Subdomain whole;
  PreconditionerCache none;
  LocalSolvers solvers(problem, options, monitor, none);
  const SolverPolicy policy(problem, options, whole, solvers);
  Solution solution = policy.Start(std::move(guess));
  if (!policy.IsFinished(solution))
  {
    NormalOperator<float> A(problem);
    policy.Accept(
      Iterate(A, make(), options, options.maximumIterations, monitor, solution), solution);
  }
  if (!policy.IsFinished(solution))
  {
    policy.Accept(solvers.IterateInDouble(solution), solution);
  }
  solution.ProvideRows(problem.Size());
  return solution;
}
}

Solution SolveByDiagonal(const LeastSquaresProblem& problem, const SolverOptions& options,
  ProgressMonitor& monitor, Points guess)
{
  return SolveWith([&] { return JacobiPreconditioner<float>(problem); }, problem, options, monitor,
    std::move(guess));
}

Solution SolveByLevels(const LeastSquaresProblem& problem, MultilevelBasis& basis,
  const SolverOptions& options, ProgressMonitor& monitor)
{
  return SolveWith([&] { return MultilevelPreconditioner(problem, basis); }, problem, options,
    monitor, Points(0, 3));
}

Solution Solve(const LeastSquaresProblem& problem, SolverType type, const SolverOptions& options,
  ProgressMonitor& monitor, PreconditionerCache& inverses)
{
  const Subdomain whole;
  LocalSolvers solvers(problem, options, monitor, inverses);
  return SolverPolicy(problem, options, whole, solvers).Solve(type, monitor);
}
}
