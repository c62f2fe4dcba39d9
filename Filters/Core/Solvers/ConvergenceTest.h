// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_ConvergenceTest_h
#define lmo_ConvergenceTest_h

#include "Core/Base/ProgressMonitor.h"
#include "Core/Solvers/SolverOptions.h"

#include <vector>

namespace lmo
{
/// How many more iterations it takes to the tolerance if the norms go on to fall as in the second
/// half of those that there are.
/// \param norms relative residuals before the first iteration and after each one
/// \return 0 at the tolerance, infinity if the norms do not fall
double PredictIterations(const std::vector<double>& norms, double tolerance);

/// Watches the residual of an iterative solver, reports its progress, and tells when the solver
/// should give up in favour of a more expensive one.
class ConvergenceTest
{
public:
  /// Keeps references to \a options and \a monitor.
  /// \param affordable iterations; with more to come, the solver should give up
  /// \param relativeResidual before the first iteration
  ConvergenceTest(const SolverOptions& options, Index affordable, ProgressMonitor& monitor,
    double relativeResidual);

  /// Takes the residual after an iteration and reports log(residual) / log(tolerance) as progress.
  /// \throw Cancelled if the monitor says so.
  void Add(double relativeResidual);

  /// True if more than the affordable number of further iterations is predicted. Predictions begin
  /// after a trial of a fifth of the affordable iterations.
  bool IsHopeless() const;

private:
  const SolverOptions& Options;
  const Index Affordable;
  ProgressMonitor& Monitor;
  std::vector<double> Norms;
};
}

#endif
