// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "OperatorFixtures.h"

#include "Core/Optimizer/ProblemSetup.h"
#include "Core/Solvers/ConvergenceTest.h"
#include "Core/Solvers/DirectSolver.h"
#include "Core/Solvers/SolverPolicy.h"

#include <algorithm>
#include <cmath>

using namespace lmo;

namespace
{
LeastSquaresProblem SmallProblem()
{
  const TestMesh mesh = Irregular(Icosphere(2), 0.02);
  const MeshQuantities quantities(mesh.V, mesh.T);
  ProgressMonitor monitor;
  return MakePlan(CotangentQuantities(quantities, false), Options(Mode::SMOOTH), {}, monitor)
    .problem;
}

/// Solvers whose results are given: each reaches a share of the exact displacement.
class GivenSolvers : public SolverFamily
{
public:
  struct Stage
  {
    std::string name;
    double share;
    Index affordable = 100;
    double expected = 0;
  };

  explicit GivenSolvers(const LeastSquaresProblem& problem)
    : Problem(problem)
    , Exact(lmo::SolveDirectly(problem, this->Monitor))
  {
  }

  std::vector<Stage> stages;
  bool isSingular = false;
  double directShare = 1;
  double shareInDouble = 1;
  std::string calls; ///< names of the solvers that ran

  double GetEnergy(const Points& d) const override { return Energy(this->Problem, d); }

  std::vector<IterativeStage> GetStages() override
  {
    std::vector<IterativeStage> result;
    for (const Stage& stage : this->stages)
    {
      result.push_back({ stage.affordable, stage.expected, [=](Index, const Solution& start) {
                          return this->Reach(stage.share, start, stage.name + ' ');
                        } });
    }
    return result;
  }

  Points SolveDirectly() override
  {
    this->calls += "direct ";
    if (this->isSingular)
    {
      throw SolverError("singular");
    }
    return this->directShare * this->Exact;
  }

  Solution IterateInDouble(const Solution& start) override
  {
    return this->Reach(this->shareInDouble, start, "double ");
  }

  /// Distance of a solution from a share of the exact one.
  double Error(const Solution& solution, double share) const
  {
    return (solution.displacement - share * this->Exact).cwiseAbs().maxCoeff();
  }

private:
  Solution Reach(double share, Solution solution, const std::string& name)
  {
    this->calls += name;
    solution.displacement = share * this->Exact;
    solution.relativeResidual =
      ComputeResidual(this->Problem, solution.displacement, [](Index, const Vector3&) {}) /
      solution.rightHandSideNorm;
    solution.iterations += 10;
    return solution;
  }

  const LeastSquaresProblem& Problem;
  ProgressMonitor Monitor;
  const Points Exact;
};

Solution SolveBy(GivenSolvers& solvers, const LeastSquaresProblem& problem, SolverType type,
  Index maximumIterations = 1000)
{
  SolverOptions options;
  options.tolerance = 1e-6;
  options.maximumIterations = maximumIterations;
  ProgressMonitor monitor;
  const Subdomain whole;
  return SolverPolicy(problem, options, whole, solvers).Solve(type, monitor);
}

void CheckOrder(Checks& c, const LeastSquaresProblem& problem)
{
  GivenSolvers solvers(problem);
  solvers.stages = { { "slow", 0.5 }, { "skipped", 1, 100, 100 }, { "good", 1 }, { "unused", 1 } };
  const Solution solution = SolveBy(solvers, problem, SolverType::AUTOMATIC);
  c.Equal("stages run in order until one solves, but for those expected to take too long",
    solvers.calls, "slow good ");
  c.Error("the last stage's solution is taken", solvers.Error(solution, 1), 0);
  c.Equal("iterations of all stages count", solution.iterations, 20);
}

void CheckAcceptance(Checks& c, const LeastSquaresProblem& problem)
{
  GivenSolvers solvers(problem);
  solvers.stages = { { "good", 0.9 }, { "worse", 0.5 } };
  solvers.shareInDouble = 0.7;
  const Solution solution = SolveBy(solvers, problem, SolverType::ITERATIVE);
  c.Equal("iterations in double precision come last", solvers.calls, "good worse double ");
  c.Error("a worse solution is not taken", solvers.Error(solution, 0.9), 0);
  c.Equal("but its iterations count", solution.iterations, 30);

  GivenSolvers diverging(problem);
  diverging.stages = { { "diverging", -1 } };
  diverging.shareInDouble = -1;
  c.Error("where all solvers diverge, nothing moves",
    diverging.Error(SolveBy(diverging, problem, SolverType::ITERATIVE), 0), 0);
}

void CheckFallback(Checks& c, const LeastSquaresProblem& problem)
{
  GivenSolvers direct(problem);
  direct.stages = { { "slow", 0.5 } };
  c.Error("the direct solver helps if all stages give up",
    direct.Error(SolveBy(direct, problem, SolverType::AUTOMATIC), 1), 0);
  c.Equal("then nothing else runs", direct.calls, "slow direct ");

  GivenSolvers singular(problem);
  singular.stages = { { "slow", 0.5 } };
  singular.isSingular = true;
  SolveBy(singular, problem, SolverType::AUTOMATIC);
  c.Equal("iterations in double precision help if the matrix is singular", singular.calls,
    "slow direct double ");

  GivenSolvers used(problem);
  used.stages = { { "slow", 0.5 }, { "unused", 1 } };
  const Solution solution = SolveBy(used, problem, SolverType::ITERATIVE, 10);
  c.Equal("nothing follows if the iterations are used up", used.calls, "slow ");
  c.Error("the solution so far is returned then", used.Error(solution, 0.5), 0);
}

void CheckDirect(Checks& c, const LeastSquaresProblem& problem)
{
  GivenSolvers direct(problem);
  direct.stages = { { "unused", 1 } };
  const Solution solution = SolveBy(direct, problem, SolverType::DIRECT);
  c.Equal("the direct solver runs alone if it is asked for", direct.calls, "direct ");
  c.Error("its residual is computed", solution.relativeResidual, 1e-9);
  direct.isSingular = true;
  c.Throws<SolverError>(
    "a singular matrix is an error then", [&] { SolveBy(direct, problem, SolverType::DIRECT); });
  direct.isSingular = false;
  direct.directShare = -1;
  c.Throws<SolverError>("so is a solution that is worse than no displacement",
    [&] { SolveBy(direct, problem, SolverType::DIRECT); });
}

/// Notes the progress.
class Progress : public ProgressMonitor
{
public:
  double last = 0;

protected:
  void ShowProgress(double fraction) override { this->last = fraction; }
};

void CheckConvergenceTest(Checks& c)
{
  SolverOptions options;
  options.tolerance = 1e-6;
  Progress progress;
  ConvergenceTest test(options, 50, progress, 1);
  bool isHopelessInTrial = false;
  for (int iteration = 1; iteration < 10; ++iteration)
  {
    test.Add(std::pow(0.99, iteration));
    isHopelessInTrial = isHopelessInTrial || test.IsHopeless();
  }
  c.True("no solver gives up in its trial", !isHopelessInTrial);
  test.Add(std::pow(0.99, 10));
  c.True("after it, it gives up if the residual falls slowly", test.IsHopeless());
  ConvergenceTest fast(options, 50, progress, 1);
  for (int iteration = 1; iteration < 12; ++iteration)
  {
    fast.Add(std::pow(0.7, iteration));
  }
  c.True("a fast one goes on", !fast.IsHopeless());
  fast.Add(1e-3);
  c.Error("half of the digits are half of the progress", std::abs(progress.last - 0.5), 1e-12);
}
}

int TestSolverPolicy(int argc, char* argv[])
{
  Groups groups(argc, argv);
  groups.Run("Order", [](Checks& c) { CheckOrder(c, SmallProblem()); });
  groups.Run("Acceptance", [](Checks& c) { CheckAcceptance(c, SmallProblem()); });
  groups.Run("Fallback", [](Checks& c) { CheckFallback(c, SmallProblem()); });
  groups.Run("Direct", [](Checks& c) { CheckDirect(c, SmallProblem()); });
  groups.Run("ConvergenceTest", CheckConvergenceTest);
  return groups.Result();
}
