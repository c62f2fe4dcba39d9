// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_SolverPolicy_h
#define lmo_SolverPolicy_h

#include "Core/Base/ProgressMonitor.h"
#include "Core/LeastSquares/LeastSquaresProblem.h"
#include "Core/Mesh/Subdomain.h"
#include "Core/Solvers/SolverOptions.h"

#include <functional>
#include <vector>

namespace lmo
{
/// An iterative solver that goes on from a solution so far.
struct IterativeStage
{
  /// Iterations above which the next stage costs less. The stage is skipped if it is expected to
  /// take as many, and gives up if more are predicted while it runs (ConvergenceTest).
  Index affordable;

  /// Iterations expected before the stage begins; 0 if there is no estimate.
  double expected;

  /// \return the solution after further iterations, whose number is added to that of \a start
  std::function<Solution(Index affordable, const Solution& start)> iterate;
};

/// The solvers among which SolverPolicy chooses. One process and several have different ones.
class SolverFamily
{
public:
  virtual ~SolverFamily() = default;

  /// What a solution minimises. 0 stands for an energy that is not known; then residuals alone
  /// decide between solutions.
  /// \param d no rows stand for 0
  virtual double GetEnergy(const Points& d) const
  {
    static_cast<void>(d);
    return 0;
  }

  /// The iterative solvers in order of cost, the cheapest first.
  virtual std::vector<IterativeStage> GetStages() = 0;

  /// The displacement from a factorisation of A.
  /// \throw SolverError if the matrix is singular or too dense.
  virtual Points SolveDirectly() = 0;

  /// Conjugate gradients in double precision with the diagonal as preconditioner. They reach what
  /// single precision cannot represent, such as weights of 1e-25.
  virtual Solution IterateInDouble(const Solution& start) = 0;
};

/// Chooses how to solve a problem, for one process and for several that call it together. Iterative
/// solvers run in order of cost, each from where the last one gave up; then follow, if the solver
/// type allows it, the direct solver, and the iterations in double precision.
class SolverPolicy
{
public:
  /// Keeps references to the arguments.
  /// \param problem ghost vertices are FIXED: their owners move them
  SolverPolicy(const LeastSquaresProblem& problem, const SolverOptions& options,
    const Subdomain& domain, SolverFamily& solvers);

  /// \throw SolverError if a direct solution is asked for and the matrix is singular or too dense,
  /// or its solution is worse than no displacement.
  /// \throw Cancelled if the monitor says so.
  Solution Solve(SolverType type, ProgressMonitor& monitor) const;

  /// A guess with its residual. If d = 0 is exact, that is the solution.
  /// \param guess of the displacement, within the constraints; no rows stand for 0
  Solution Start(Points guess = Points(0, 3)) const;

  /// Takes another solution if its residual and its energy are not larger; counts its iterations in
  /// any case.
  void Accept(Solution next, Solution& solution) const;

  bool IsSolved(const Solution& solution) const;

  /// Solved, or all iterations are used up.
  bool IsFinished(const Solution& solution) const;

private:
  double ResidualNorm(const Points& d) const;

  /// True if the energy is not above that of another displacement by more than round-off. Where the
  /// matrix is nearly singular, a small residual does not say so.
  bool IsNoWorse(const Points& d, const Points& other) const;

  /// \throw SolverError if the solution is worse than no displacement.
  void CheckEnergy(const Solution& solution) const;

  /// The direct solution with its residual.
  Solution SolveDirectly(const Solution& start) const;

  const LeastSquaresProblem& Problem;
  const SolverOptions& Options;
  const Subdomain& Domain;
  SolverFamily& Solvers;
};
}

#endif
