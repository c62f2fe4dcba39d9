// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_ConjugateGradient_txx
#define lmo_ConjugateGradient_txx

#include "Core/Base/Threading.h"

#include <cmath>
#include <utility>

namespace lmo
{
/// a / b; 0 for a coordinate that has converged.
inline Dots DivideDots(const Dots& a, const Dots& b)
{
  return (a > 0 && b > 0).select(a / b, 0.0);
}

template <typename Scalar, typename Preconditioner>
ConjugateGradient<Scalar, Preconditioner>::ConjugateGradient(const LeastSquaresProblem& problem,
  NormalOperator<Scalar>& A, Preconditioner& M, const Subdomain& domain)
  : Problem(problem)
  , A(A)
  , M(M)
  , Domain(domain)
  , IsCoupled(problem.IsCoupled())
  , Residual(4, problem.Size())
  , Direction(4, problem.Size())
  , Product(4, problem.Size())
  , Steps(4, problem.Size())
{
}

template <typename Scalar, typename Preconditioner>
void ConjugateGradient<Scalar, Preconditioner>::Run(
  const SolverOptions& options, Index affordable, ProgressMonitor& monitor, Solution& solution)
{
  ConvergenceTest test(options, affordable, monitor, solution.relativeResidual);
  this->Scale = solution.rightHandSideNorm;
  ParallelFor(this->Problem.Size(),
    [direction = View(this->Direction), steps = View(this->Steps)](Index i) mutable
    {
      direction.col(i).setZero();
      steps.col(i).setZero();
    });
  this->ReplaceResidual(solution.displacement);
  this->Precondition(monitor);
  this->UpdateDirection(Dots::Zero());
  solution.ProvideRows(this->Problem.Size());
  while (solution.relativeResidual > options.tolerance &&
         solution.iterations < options.maximumIterations)
  {
    this->Alpha =
      DivideDots(this->Rho, this->Domain.Sum(this->A.Multiply(this->Direction, this->Product)));
    const Dots oldRho = this->Rho;
    const double norm = this->StepResidual();
    ++solution.iterations;
    test.Add(norm);
    const bool isHopeless = test.IsHopeless();
    const bool isLast = solution.iterations == options.maximumIterations ||
                        !(this->Alpha > 0).any() || !(norm > options.tolerance) || isHopeless;
    const bool isReplaced =
      isLast || norm < Preconditioner::ReplacementRatio * solution.relativeResidual;
    bool isDrift = false;
    if (isReplaced)
    {
      const double old = solution.relativeResidual;
      this->Collect(solution.displacement);
      solution.relativeResidual = this->ReplaceResidual(solution.displacement);
      if (isHopeless || !(solution.relativeResidual < old / 2) ||
          solution.relativeResidual <= options.tolerance)
      {
        break;
      }
      // Directions belong to the residual that was carried along; far from it they mislead.
      isDrift = solution.relativeResidual > LargestDrift * norm;
    }
    if (isReplaced || !Preconditioner::IsRowWise)
    {
      this->Precondition(monitor);
    }
    this->UpdateDirection(isDrift ? Dots(Dots::Zero()) : DivideDots(this->Rho, oldRho));
  }
}

template <typename Scalar, typename Preconditioner>
double ConjugateGradient<Scalar, Preconditioner>::ReplaceResidual(const Points& d)
{
  const double unit = 1 / this->Scale;
  const double norm = ComputeResidual(this->Problem, d,
    [unit, packed = View(this->Residual)](Index i, const Vector3& residual) mutable
    {
      const Vector3 scaled = unit * residual;
      packed.col(i) << Scalar(scaled[0]), Scalar(scaled[1]), Scalar(scaled[2]), Scalar(0);
    });
  return this->Domain.Norm(norm) * unit;
}

template <typename Scalar, typename Preconditioner>
void ConjugateGradient<Scalar, Preconditioner>::Precondition(ProgressMonitor& monitor)
{
  this->M.Prepare(this->Residual, monitor);
  const DotSum sum = ParallelSum(this->Problem.Size(), DotSum(),
    [residual = View(std::as_const(this->Residual)), M = this->M.GetRows()](DotSum& dots, Index i)
    {
      const Row r = residual.col(i);
      dots.Add(Row(r * M(i, r)));
    });
  this->Rho = this->Domain.Sum(this->Couple(sum.Get()));
}

template <typename Scalar, typename Preconditioner>
double ConjugateGradient<Scalar, Preconditioner>::StepResidual()
{
  struct Sums
  {
    DotSum rho;
    DotSum squares;
    void operator+=(const Sums& other)
    {
      this->rho += other.rho;
      this->squares += other.squares;
    }
  };
  const Sums sums = ParallelSum(this->Problem.Size(), Sums(),
    [residual = View(this->Residual), product = View(std::as_const(this->Product)),
      M = this->M.GetRows(),
      alpha = Row(this->Alpha.template cast<Scalar>())](Sums& sum, Index i) mutable
    {
      const Row r = residual.col(i) - alpha * product.col(i);
      residual.col(i) = r;
      sum.squares.Add(Row(r * r));
      if (Preconditioner::IsRowWise)
      {
        sum.rho.Add(Row(r * M(i, r)));
      }
    });
  if (Preconditioner::IsRowWise)
  {
    this->Rho = this->Domain.Sum(this->Couple(sums.rho.Get()));
  }
  return this->Domain.Norm(std::sqrt(sums.squares.Get().sum()));
}

template <typename Scalar, typename Preconditioner>
void ConjugateGradient<Scalar, Preconditioner>::Collect(Points& d)
{
  const Row alpha = this->Alpha.template cast<Scalar>();
  ParallelFor(this->Problem.Size(),
    [&](Index i)
    {
      const Row step = this->Steps.col(i) + alpha * this->Direction.col(i);
      const Vector3 exactStep = step.template head<3>().template cast<double>().matrix();
      d.row(i) += this->Scale * this->Problem.constraints.Project(i, exactStep);
      this->Steps.col(i).setZero();
    });
  this->Domain.UpdateGhosts(d);
  this->Alpha.setZero();
}

template <typename Scalar, typename Preconditioner>
void ConjugateGradient<Scalar, Preconditioner>::UpdateDirection(const Dots& betas)
{
  ParallelFor(this->Problem.Size(),
    [residual = View(std::as_const(this->Residual)), direction = View(this->Direction),
      steps = View(this->Steps), M = this->M.GetRows(),
      alpha = Row(this->Alpha.template cast<Scalar>()),
      beta = Row(betas.template cast<Scalar>())](Index i) mutable
    {
      const Row p = direction.col(i);
      steps.col(i) += alpha * p;
      direction.col(i) = M(i, residual.col(i)) + beta * p;
    });
  this->Domain.UpdateGhosts(this->Direction);
}
}

#endif
