// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "PetscSolver.h"

#include "Core/Solvers/ConjugateGradient.h"
#include "Core/Solvers/SolverPolicy.h"
#include "DistributedDirectSolver.h"
#include "MultigridPreconditioner.h"

#include <cmath>
#include <exception>
#include <memory>

namespace lmo
{
namespace
{
/// Predicted iterations above which the multigrid preconditioner pays for its setup.
constexpr Index AffordableJacobiIterations = 400;
constexpr Index AffordableMultigridIterations = 200;

/// One run of conjugate gradients, as PETSc's callbacks see it.
struct Run
{
  ConvergenceTest test;
  double scale;             ///< |b|
  double tolerance;         ///< relative residual
  Index allowed;            ///< iterations
  std::exception_ptr error; ///< of the monitor
};

KSPConvergedReason Judge(Run& run, Index iteration, double norm)
{
  if (!std::isfinite(norm))
  {
    return KSP_DIVERGED_NANORINF;
  }
  if (iteration > 0)
  {
    run.test.Add(norm / run.scale);
  }
  if (norm / run.scale <= run.tolerance)
  {
    return KSP_CONVERGED_RTOL;
  }
  const bool isUsedUp = iteration >= run.allowed;
  return isUsedUp || run.test.IsHopeless() ? KSP_DIVERGED_ITS : KSP_CONVERGED_ITERATING;
}

PetscErrorCode TestConvergence(
  KSP, PetscInt iteration, PetscReal norm, KSPConvergedReason* reason, void* context)
{
  Run& run = *static_cast<Run*>(context);
  try
  {
    *reason = Judge(run, static_cast<Index>(iteration), norm);
  }
  catch (...)
  {
    run.error = std::current_exception();
    *reason = KSP_DIVERGED_BREAKDOWN;
  }
  return 0;
}

/// PETSc's view of a preconditioner.
using Application = std::function<void(Vec, Vec)>;

PetscErrorCode ApplyPreconditioner(PC pc, Vec residual, Vec result)
{
  return ReturnCode(
    [&]
    {
      const Application* apply = nullptr;
      Check(PCShellGetContext(pc, &apply));
      (*apply)(residual, result);
    });
}

class Iteration
{
public:
  /// Keeps references to the arguments.
  Iteration(DistributedEquations& equations, const Application& preconditioner)
    : Equations(equations)
    , Residual(equations.MakeVector(3))
    , Correction(equations.MakeVector(3))
  {
    Check(KSPCreate(equations.GetComm(), &this->Krylov));
    Check(KSPSetOptionsPrefix(this->Krylov, "lmo_"));
    Check(KSPSetOperators(this->Krylov, equations.GetMatrix(), equations.GetMatrix()));
    Check(KSPSetType(this->Krylov, KSPCG));
    Check(KSPSetNormType(this->Krylov, KSP_NORM_UNPRECONDITIONED));
    PC pc = nullptr;
    Check(KSPGetPC(this->Krylov, &pc));
    Check(PCSetType(pc, PCSHELL));
    Check(PCShellSetContext(pc, const_cast<Application*>(&preconditioner)));
    Check(PCShellSetApply(pc, ApplyPreconditioner));
    Check(KSPSetFromOptions(this->Krylov));
  }

  /// Improves the solution until it meets the tolerance or there is no progress. Each run solves
  /// for a correction, from a residual that is computed anew.
  Solution Improve(
    const SolverOptions& options, Index affordable, ProgressMonitor& monitor, Solution solution)
  {
    solution.ProvideRows(this->Equations.GetProblem().Size());
    bool goesOn = true;
    while (goesOn && solution.relativeResidual > options.tolerance &&
           solution.iterations < options.maximumIterations)
    {
      Run run{ ConvergenceTest(options, affordable, monitor, solution.relativeResidual),
        solution.rightHandSideNorm, options.tolerance,
        options.maximumIterations - solution.iterations, {} };
      Points d = this->SolveForCorrection(run, solution);
      this->Equations.ComputeResidual(d, this->Residual);
      const double relative = Norm(this->Residual) / solution.rightHandSideNorm;
      goesOn = !run.test.IsHopeless() && relative < solution.relativeResidual / 2;
      if (relative < solution.relativeResidual)
      {
        solution.displacement = std::move(d);
        solution.relativeResidual = relative;
      }
    }
    return solution;
  }

private:
  Points SolveForCorrection(Run& run, Solution& solution)
  {
    this->Equations.ComputeResidual(solution.displacement, this->Residual);
    Check(KSPSetConvergenceTest(this->Krylov, TestConvergence, &run, nullptr));
    Check(KSPSolve(this->Krylov, this->Residual, this->Correction));
    if (run.error)
    {
      std::rethrow_exception(run.error);
    }
    PetscInt iterations = 0;
    Check(KSPGetIterationNumber(this->Krylov, &iterations));
    solution.iterations += static_cast<Index>(iterations);
    Points d = solution.displacement;
    this->Equations.Add(this->Correction, d);
    return d;
  }

  DistributedEquations& Equations;
  PetscVector Residual;
  PetscVector Correction;
  PetscKrylov Krylov;
};

/// The problem of the vertices that this process owns. The others follow their owners.
LeastSquaresProblem FixGhostVertices(const LeastSquaresProblem& problem, const Subdomain& domain)
{
  LeastSquaresProblem owned = problem;
  for (Index i = 0; i < owned.Size(); ++i)
  {
    if (!domain.OwnsVertex(i))
    {
      owned.constraints.freedom[i] = DisplacementConstraints::FIXED;
    }
  }
  return owned;
}

/// True if the user chose options for PETSc's conjugate gradients.
bool HasOptionsOfIteration(MPI_Comm comm)
{
  return HasPetscOptions(comm, "-lmo_ksp_") || HasPetscOptions(comm, "-lmo_pc_");
}

/// The solvers of several processes. The first stage is that of one process, unless the user chose
/// options for PETSc's conjugate gradients; all else is PETSc's.
class DistributedSolvers : public SolverFamily
{
public:
  /// Keeps references to the arguments.
  /// \param owned the problem with its ghost vertices FIXED
  DistributedSolvers(const LeastSquaresProblem& problem, const LeastSquaresProblem& owned,
    const SolverOptions& options, ProgressMonitor& monitor, const DistributedSubdomain& domain)
    : Problem(problem)
    , Owned(owned)
    , Options(options)
    , Monitor(monitor)
    , Domain(domain)
  {
  }

  std::vector<IterativeStage> GetStages() override
  {
    const bool isForPetsc = HasOptionsOfIteration(this->Domain.GetMesh().GetCommunicator().Get());
    return {
      { AffordableJacobiIterations, 0,
        [=](Index affordable, const Solution& start)
        {
          return isForPetsc ? this->IterateWithDiagonal(affordable, start)
                            : this->IterateInSingle(affordable, start);
        } },
      { AffordableMultigridIterations, 0,
        [=](Index affordable, const Solution& start)
        { return this->IterateWithMultigrid(affordable, start); } },
    };
  }

  Points SolveDirectly() override { return lmo::SolveDirectly(this->GetEquations()); }

  Solution IterateInDouble(const Solution& start) override
  {
    return this->IterateWithDiagonal(this->Options.maximumIterations, start);
  }

private:
  /// Takes a third of the time and memory traffic of PETSc's conjugate gradients.
  Solution IterateInSingle(Index affordable, Solution solution)
  {
    NormalOperator<float> A(this->Owned);
    JacobiPreconditioner<float> M(this->Owned);
    ConjugateGradient<float, JacobiPreconditioner<float>>(this->Owned, A, M, this->Domain)
      .Run(this->Options, affordable, this->Monitor, solution);
    return solution;
  }

  Solution IterateWithDiagonal(Index affordable, const Solution& start)
  {
    DistributedEquations& equations = this->GetEquations();
    const Application jacobi = [&](Vec residual, Vec result)
    { equations.ApplyJacobi(residual, result); };
    return Iteration(equations, jacobi).Improve(this->Options, affordable, this->Monitor, start);
  }

  Solution IterateWithMultigrid(Index affordable, const Solution& start)
  {
    DistributedEquations& equations = this->GetEquations();
    const MultigridPreconditioner multigrid(equations);
    const Application apply = [&](Vec residual, Vec result) { multigrid.Apply(residual, result); };
    return Iteration(equations, apply).Improve(this->Options, affordable, this->Monitor, start);
  }

  DistributedEquations& GetEquations()
  {
    if (!this->Equations)
    {
      this->Equations =
        std::make_unique<DistributedEquations>(this->Problem, this->Domain.GetMesh());
    }
    return *this->Equations;
  }

  const LeastSquaresProblem& Problem;
  const LeastSquaresProblem& Owned;
  const SolverOptions& Options;
  ProgressMonitor& Monitor;
  const DistributedSubdomain& Domain;
  std::unique_ptr<DistributedEquations> Equations; ///< made when they are needed
};

void CheckSize(std::int64_t vertices)
{
  if (vertices > PETSC_MAX_INT / 3)
  {
    throw SolverError("The mesh has " + std::to_string(vertices) +
                      " points, more than this PETSc can count. Use one that was configured "
                      "--with-64-bit-indices.");
  }
}
}

Solution SolveDistributed(const LeastSquaresProblem& problem, SolverType type,
  const SolverOptions& options, ProgressMonitor& monitor, const DistributedSubdomain& domain)
{
  const DistributedMesh& mesh = domain.GetMesh();
  const PetscSession session(mesh.GetCommunicator().Get());
  CheckSize(mesh.GetGlobalNumberOfVertices());
  const LeastSquaresProblem owned = FixGhostVertices(problem, domain);
  DistributedSolvers solvers(problem, owned, options, monitor, domain);
  return SolverPolicy(owned, options, domain, solvers).Solve(type, monitor);
}
}
