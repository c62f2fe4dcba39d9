// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ConjugateGradient.h"

#include "Parallel.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace lmo
{
namespace
{
using Dots = Eigen::Array<double, 1, 3>;

/// Inner products of x, y and z; coupled coordinates share their sum.
Dots InnerProducts(const Points& a, const Points& b, bool isCoupled)
{
  Dots dots = ParallelSum(static_cast<Index>(a.rows()), Dots(Dots::Zero()),
    [&](Dots& sum, Index i) { sum += a.row(i).array() * b.row(i).array(); });
  if (isCoupled)
  {
    dots.setConstant(dots.sum());
  }
  return dots;
}

/// a / b; 0 for a coordinate that has converged to a = 0.
Dots Divide(const Dots& a, const Dots& b)
{
  return (a > 0 && b > 0).select(a / b, 0.0);
}

/// One run of the method: the residual is updated, not recomputed, and drifts by round-off.
class Run
{
public:
  Run(const NormalEquations& equations, const Preconditioner& preconditioner)
    : Equations(equations)
    , M(preconditioner)
    , IsCoupled(equations.IsCoupled())
    , Preconditioned(equations.Size(), 3)
    , Product(equations.Size(), 3)
  {
  }

  void Start(const Points& initialResidual)
  {
    this->Residual = initialResidual;
    this->M.Apply(this->Residual, this->Preconditioned);
    this->Direction = this->Preconditioned;
    this->Rho = InnerProducts(this->Residual, this->Preconditioned, this->IsCoupled);
  }

  /// Moves \a d along the search direction.
  /// \return false if no direction is left that improves it
  bool Step(Points& d)
  {
    this->Equations.Apply(this->Direction, this->Product);
    const Dots alpha =
      Divide(this->Rho, InnerProducts(this->Direction, this->Product, this->IsCoupled));
    if (!(alpha > 0).any())
    {
      return false;
    }
    ParallelFor(this->Equations.Size(),
      [&](Index i)
      {
        d.row(i).array() += alpha * this->Direction.row(i).array();
        this->Residual.row(i).array() -= alpha * this->Product.row(i).array();
      });
    this->M.Apply(this->Residual, this->Preconditioned);
    const Dots rho = InnerProducts(this->Residual, this->Preconditioned, this->IsCoupled);
    const Dots beta = Divide(rho, this->Rho);
    this->Rho = rho;
    ParallelFor(this->Equations.Size(),
      [&](Index i)
      {
        this->Direction.row(i).array() =
          this->Preconditioned.row(i).array() + beta * this->Direction.row(i).array();
      });
    return true;
  }

  double ResidualNorm() const { return Norm(this->Residual); }

private:
  const NormalEquations& Equations;
  const Preconditioner& M;
  const bool IsCoupled;
  Points Residual;
  Points Preconditioned;
  Points Direction;
  Points Product;
  Dots Rho = Dots::Zero();
};

/// Share of the way from residual 1 to the tolerance, on a logarithmic scale.
double Progress(double relativeResidual, double tolerance)
{
  return std::clamp(std::log(relativeResidual) / std::log(tolerance), 0.0, 1.0);
}
}

Solution SolveIteratively(const NormalEquations& equations, const Points& b,
  const Preconditioner& preconditioner, const SolverOptions& options, Monitor& monitor)
{
  Solution solution;
  solution.displacement = Points::Zero(b.rows(), 3);
  const double bNorm = Norm(b);
  if (!(bNorm > 0))
  {
    return solution;
  }
  Run run(equations, preconditioner);
  Points residual = b;
  solution.relativeResidual = 1;
  // Starts again from the true residual where the updated one was too optimistic.
  for (double previous = 2 * solution.relativeResidual;
       solution.relativeResidual > options.tolerance && solution.relativeResidual <= previous / 2 &&
       solution.iterations < options.maximumIterations;)
  {
    previous = solution.relativeResidual;
    run.Start(residual);
    while (run.ResidualNorm() > options.tolerance * bNorm &&
           solution.iterations < options.maximumIterations && run.Step(solution.displacement))
    {
      ++solution.iterations;
      monitor.Report(Progress(run.ResidualNorm() / bNorm, options.tolerance));
    }
    equations.Apply(solution.displacement, residual);
    residual = b - residual;
    solution.relativeResidual = Norm(residual) / bNorm;
  }
  return solution;
}
}
