// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "PetscSolver.h"

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

/// The number of iterations is predicted after this share of the affordable ones.
constexpr Index TrialShare = 5;

/// One run of conjugate gradients, as PETSc's callbacks see it.
struct Run
{
  const SolverOptions& options;
  Index affordable;
  ProgressMonitor& monitor;
  double scale;  ///< |b|
  Index earlier; ///< iterations
  std::vector<double> norms;
  bool isHopeless = false;
  std::exception_ptr error; ///< of the monitor
};

KSPConvergedReason Judge(Run& run, Index iteration, double norm)
{
  run.norms.push_back(norm / run.scale);
  if (!std::isfinite(norm))
  {
    return KSP_DIVERGED_NANORINF;
  }
  const double tolerance = run.options.tolerance;
  const double relative = run.norms.back();
  run.monitor.Report(
    relative > 0 ? std::min(std::max(std::log(relative) / std::log(tolerance), 0.0), 1.0) : 1);
  run.isHopeless = iteration > run.affordable / TrialShare &&
                   PredictIterations(run.norms, tolerance) > run.affordable;
  if (relative <= tolerance)
  {
    return KSP_CONVERGED_RTOL;
  }
  const bool isUsedUp = run.earlier + iteration >= run.options.maximumIterations;
  return isUsedUp || run.isHopeless ? KSP_DIVERGED_ITS : KSP_CONVERGED_ITERATING;
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

double Norm(Vec vector)
{
  double norm = 0;
  Check(VecNorm(vector, NORM_2, &norm));
  return norm;
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
  void Improve(
    const SolverOptions& options, Index affordable, ProgressMonitor& monitor, Solution& solution)
  {
    bool goesOn = true;
    while (goesOn && solution.relativeResidual > options.tolerance &&
           solution.iterations < options.maximumIterations)
    {
      Run run{ options, affordable, monitor, solution.rightHandSideNorm, solution.iterations, {} };
      Points d = this->SolveForCorrection(run, solution);
      this->Equations.ComputeResidual(d, this->Residual);
      const double relative = Norm(this->Residual) / solution.rightHandSideNorm;
      goesOn = !run.isHopeless && relative < solution.relativeResidual / 2;
      if (relative < solution.relativeResidual)
      {
        solution.displacement = std::move(d);
        solution.relativeResidual = relative;
      }
    }
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

bool IsSolved(const Solution& solution, const SolverOptions& options)
{
  return solution.relativeResidual <= options.tolerance;
}

/// The rows of the vertices that this process owns: the others only follow their owners.
LeastSquaresProblem HoldCopies(const LeastSquaresProblem& problem, const Subdomain& domain)
{
  LeastSquaresProblem held = problem;
  for (Index i = 0; i < held.Size(); ++i)
  {
    if (!domain.OwnsVertex(i))
    {
      held.motion.freedom[i] = DisplacementConstraints::FIXED;
    }
  }
  return held;
}

/// The residual of d = 0.
/// \param problem its copies are held
Solution Start(const LeastSquaresProblem& problem, const Subdomain& domain)
{
  Solution solution;
  solution.displacement = Points::Zero(problem.Size(), 3);
  solution.rightHandSideNorm =
    domain.Norm(ComputeResidual(problem, Points(0, 3), [](Index, const Vector3&) {}));
  solution.relativeResidual = solution.rightHandSideNorm > 0 ? 1 : 0;
  return solution;
}

/// True if the user chose options for PETSc's conjugate gradients.
bool HasOptionsOfIteration(MPI_Comm comm)
{
  return HasPetscOptions(comm, "-lmo_ksp_") || HasPetscOptions(comm, "-lmo_pc_");
}

/// What one process does first: conjugate gradients in single precision, with the diagonal as
/// preconditioner. They take a third of the time and memory traffic of PETSc's.
/// \param problem its copies are held
void IterateInSingle(const LeastSquaresProblem& problem, const SolverOptions& options,
  ProgressMonitor& monitor, const Subdomain& domain, Solution& solution)
{
  NormalOperator<float> A(problem);
  JacobiPreconditioner<float> M(problem);
  Solution next = solution;
  ConjugateGradient<float, JacobiPreconditioner<float>>(problem, A, M, domain)
    .Run(options, AffordableJacobiIterations, monitor, next);
  solution.iterations = next.iterations;
  if (next.relativeResidual < solution.relativeResidual)
  {
    solution = std::move(next);
  }
}

void IterateWithDiagonal(DistributedEquations& equations, const SolverOptions& options,
  Index affordable, ProgressMonitor& monitor, Solution& solution)
{
  const Application jacobi = [&](Vec residual, Vec result)
  { equations.ApplyJacobi(residual, result); };
  Iteration(equations, jacobi).Improve(options, affordable, monitor, solution);
}

void IterateWithMultigrid(DistributedEquations& equations, const SolverOptions& options,
  ProgressMonitor& monitor, Solution& solution)
{
  if (IsSolved(solution, options) || solution.iterations >= options.maximumIterations)
  {
    return;
  }
  const MultigridPreconditioner multigrid(equations);
  const Application apply = [&](Vec residual, Vec result) { multigrid.Apply(residual, result); };
  Iteration(equations, apply).Improve(options, AffordableMultigridIterations, monitor, solution);
}

/// Takes the direct solution if it is closer; keeps what there is if there is none.
void ImproveDirectly(const DistributedEquations& equations, Solution& solution)
{
  try
  {
    Solution direct = SolveDirectly(equations, solution.rightHandSideNorm);
    if (direct.relativeResidual < solution.relativeResidual)
    {
      solution.displacement = std::move(direct.displacement);
      solution.relativeResidual = direct.relativeResidual;
    }
  }
  catch (const SolverError&)
  {
  }
}

/// Goes on from the solution so far with multigrid and then, if it may, a factorisation.
void ImproveByPetsc(DistributedEquations& equations, SolverType type, const SolverOptions& options,
  ProgressMonitor& monitor, Solution& solution)
{
  IterateWithMultigrid(equations, options, monitor, solution);
  if (!IsSolved(solution, options) && type == SolverType::AUTOMATIC)
  {
    ImproveDirectly(equations, solution);
  }
  else if (!IsSolved(solution, options))
  {
    IterateWithDiagonal(equations, options, options.maximumIterations, monitor, solution);
  }
}

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
  const LeastSquaresProblem held = HoldCopies(problem, domain);
  Solution solution = Start(held, domain);
  if (IsSolved(solution, options))
  {
    return solution;
  }
  if (type == SolverType::DIRECT)
  {
    monitor.Report(0);
    return SolveDirectly(DistributedEquations(problem, mesh), solution.rightHandSideNorm);
  }
  const bool isForPetsc = HasOptionsOfIteration(mesh.GetCommunicator().Get());
  if (!isForPetsc)
  {
    IterateInSingle(held, options, monitor, domain, solution);
  }
  if (!IsSolved(solution, options))
  {
    DistributedEquations equations(problem, mesh);
    if (isForPetsc)
    {
      IterateWithDiagonal(equations, options, AffordableJacobiIterations, monitor, solution);
    }
    ImproveByPetsc(equations, type, options, monitor, solution);
  }
  return solution;
}
}
