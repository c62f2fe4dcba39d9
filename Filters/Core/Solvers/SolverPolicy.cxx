// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solvers/SolverPolicy.h"

#include <sstream>
#include <utility>

namespace lmo
{
SolverPolicy::SolverPolicy(const LeastSquaresProblem& problem, const SolverOptions& options,
  const Subdomain& domain, SolverFamily& solvers)
  : Problem(problem)
  , Options(options)
  , Domain(domain)
  , Solvers(solvers)
{
}

Solution SolverPolicy::Solve(SolverType type, ProgressMonitor& monitor) const
{
  Solution solution = this->Start();
  if (this->IsSolved(solution))
  {
    return solution;
  }
  if (type == SolverType::DIRECT)
  {
    monitor.Report(0);
    solution = this->SolveDirectly(solution);
    this->CheckEnergy(solution);
    return solution;
  }
  for (const IterativeStage& stage : this->Solvers.GetStages())
  {
    if (!this->IsFinished(solution) && stage.expected < stage.affordable)
    {
      this->Accept(stage.iterate(stage.affordable, solution), solution);
    }
  }
  if (!this->IsSolved(solution) && type == SolverType::AUTOMATIC)
  {
    try
    {
      this->Accept(this->SolveDirectly(solution), solution);
    }
    catch (const SolverError&)
    {
      // The solution so far stays, and the caller sees its residual.
    }
  }
  if (!this->IsFinished(solution))
  {
    this->Accept(this->Solvers.IterateInDouble(solution), solution);
  }
  solution.ProvideRows(this->Problem.Size());
  return solution;
}

Solution SolverPolicy::Start(Points guess) const
{
  Solution solution;
  solution.rightHandSideNorm = this->ResidualNorm(solution.displacement);
  if (!(solution.rightHandSideNorm > 0))
  {
    solution.ProvideRows(this->Problem.Size());
    solution.relativeResidual = 0;
  }
  else if (guess.rows() > 0)
  {
    solution.displacement = std::move(guess);
    solution.relativeResidual =
      this->ResidualNorm(solution.displacement) / solution.rightHandSideNorm;
  }
  return solution;
}

void SolverPolicy::Accept(Solution next, Solution& solution) const
{
  solution.iterations = next.iterations;
  if (next.relativeResidual <= solution.relativeResidual &&
      this->IsNoWorse(next.displacement, solution.displacement))
  {
    solution = std::move(next);
  }
}

bool SolverPolicy::IsSolved(const Solution& solution) const
{
  return solution.relativeResidual <= this->Options.tolerance;
}

bool SolverPolicy::IsFinished(const Solution& solution) const
{
  return this->IsSolved(solution) || solution.iterations >= this->Options.maximumIterations;
}

double SolverPolicy::ResidualNorm(const Points& d) const
{
  return this->Domain.Norm(ComputeResidual(this->Problem, d, [](Index, const Vector3&) {}));
}

bool SolverPolicy::IsNoWorse(const Points& d, const Points& other) const
{
  constexpr double roundOff = 1e-9;
  return this->Solvers.GetEnergy(d) <= (1 + roundOff) * this->Solvers.GetEnergy(other);
}

void SolverPolicy::CheckEnergy(const Solution& solution) const
{
  if (!this->IsNoWorse(solution.displacement, {}))
  {
    std::ostringstream text;
    text << "The energy of the solver's result is "
         << this->Solvers.GetEnergy(solution.displacement) << ", worse than that of the input, "
         << this->Solvers.GetEnergy({})
         << ": the system is nearly singular. Choose weights that differ less in size, or use the "
            "iterative solver.";
    throw SolverError(text.str());
  }
}

Solution SolverPolicy::SolveDirectly(const Solution& start) const
{
  Solution solution;
  solution.displacement = this->Solvers.SolveDirectly();
  solution.iterations = start.iterations;
  solution.rightHandSideNorm = start.rightHandSideNorm;
  solution.relativeResidual = this->ResidualNorm(solution.displacement) / start.rightHandSideNorm;
  return solution;
}
}
