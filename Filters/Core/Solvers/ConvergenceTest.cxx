// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solvers/ConvergenceTest.h"

#include <algorithm>
#include <cmath>

namespace lmo
{
namespace
{
/// The number of iterations is predicted after this share of the affordable ones.
constexpr Index TrialShare = 5;
}

double PredictIterations(const std::vector<double>& norms, double tolerance)
{
  const std::size_t done = norms.size() - 1;
  const std::size_t half = done / 2;
  const double fall = std::log(norms[half] / norms[done]);
  const double left = std::log(norms[done] / tolerance);
  return left <= 0 ? 0 : fall <= 0 ? HUGE_VAL : left / fall * (done - half);
}

ConvergenceTest::ConvergenceTest(
  const SolverOptions& options, Index affordable, ProgressMonitor& monitor, double relativeResidual)
  : Options(options)
  , Affordable(affordable)
  , Monitor(monitor)
  , Norms{ relativeResidual }
{
}

void ConvergenceTest::Add(double relativeResidual)
{
  this->Norms.push_back(relativeResidual);
  this->Monitor.Report(
    std::clamp(std::log(relativeResidual) / std::log(this->Options.tolerance), 0.0, 1.0));
}

bool ConvergenceTest::IsHopeless() const
{
  return static_cast<Index>(this->Norms.size()) > this->Affordable / TrialShare &&
         PredictIterations(this->Norms, this->Options.tolerance) > this->Affordable;
}
}
