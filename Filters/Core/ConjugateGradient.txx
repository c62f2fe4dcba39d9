// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_ConjugateGradient_txx
#define lmo_ConjugateGradient_txx

#include "Parallel.h"

namespace lmo
{
/// a / b; 0 for a coordinate that has converged.
inline Dots DivideDots(const Dots& a, const Dots& b)
{
  return (a > 0 && b > 0).select(a / b, 0.0);
}

template <typename Scalar, typename Preconditioner>
ConjugateGradient<Scalar, Preconditioner>::ConjugateGradient(
  const LeastSquaresProblem& problem, PackedEquations<Scalar>& A, Preconditioner& M)
  : Problem(problem)
  , A(A)
  , M(M)
  , IsCoupled(problem.IsCoupled())
  , Residual(4, problem.Size())
  , Direction(4, problem.Size())
  , Product(4, problem.Size())
  , Steps(4, problem.Size())
{
}

template <typename Scalar, typename Preconditioner>
void ConjugateGradient<Scalar, Preconditioner>::Run(
  const SolverOptions& options, Monitor& monitor, Solution& solution)
{
  this->Scale = solution.rightHandSideNorm;
  ParallelFor(this->Problem.Size(),
    [&](Index i)
    {
      this->Direction.col(i).setZero();
      this->Steps.col(i).setZero();
    });
  double exactNorm = this->ReplaceResidual(solution.displacement);
  this->UpdateDirection(Dots::Zero());
  while (exactNorm > options.tolerance && solution.iterations < options.maximumIterations)
  {
    this->Alpha = DivideDots(this->Rho, this->A.Multiply(this->Direction, this->Product));
    const Dots oldRho = this->Rho;
    const double norm = this->UpdateResidual();
    ++solution.iterations;
    monitor.Report(std::clamp(std::log(norm) / std::log(options.tolerance), 0.0, 1.0));
    const bool isLast = solution.iterations == options.maximumIterations ||
                        !(this->Alpha > 0).any() || !(norm > options.tolerance);
    if (isLast || norm < ReplacementRatio * exactNorm)
    {
      const double oldExactNorm = exactNorm;
      this->Collect(solution.displacement);
      exactNorm = this->ReplaceResidual(solution.displacement);
      if (!(exactNorm < oldExactNorm / 2))
      {
        break;
      }
    }
    this->UpdateDirection(DivideDots(this->Rho, oldRho));
  }
  solution.relativeResidual = exactNorm;
}

template <typename Scalar, typename Preconditioner>
double ConjugateGradient<Scalar, Preconditioner>::ReplaceResidual(const Points& d)
{
  const double unit = 1 / this->Scale;
  const double norm = ComputeResidual(this->Problem, d,
    [&](Index i, const Vector3& residual)
    {
      const Vector3 scaled = unit * residual;
      this->Residual.col(i) << Scalar(scaled[0]), Scalar(scaled[1]), Scalar(scaled[2]), Scalar(0);
    });
  this->M.Prepare(this->Residual);
  this->Rho = this->ResidualDots();
  return norm * unit;
}

template <typename Scalar, typename Preconditioner>
Dots ConjugateGradient<Scalar, Preconditioner>::ResidualDots()
{
  const DotSum sum = ParallelSum(this->Problem.Size(), DotSum(),
    [&](DotSum& dots, Index i)
    {
      const Row r = this->Residual.col(i);
      dots.Add(Row(r * this->M.Row(i, r)));
    });
  return this->Couple(sum.Get());
}

template <typename Scalar, typename Preconditioner>
double ConjugateGradient<Scalar, Preconditioner>::UpdateResidual()
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
  const Row alpha = this->Alpha.template cast<Scalar>();
  const Sums sums = ParallelSum(this->Problem.Size(), Sums(),
    [&](Sums& sum, Index i)
    {
      const Row r = this->Residual.col(i) - alpha * this->Product.col(i);
      this->Residual.col(i) = r;
      sum.squares.Add(Row(r * r));
      if (Preconditioner::IsRowWise)
      {
        sum.rho.Add(Row(r * this->M.Row(i, r)));
      }
    });
  if (Preconditioner::IsRowWise)
  {
    this->Rho = this->Couple(sums.rho.Get());
  }
  else
  {
    this->M.Prepare(this->Residual);
    this->Rho = this->ResidualDots();
  }
  return std::sqrt(sums.squares.Get().sum());
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
      d.row(i) += this->Scale * this->Problem.motion.Project(i, exactStep);
      this->Steps.col(i).setZero();
    });
  this->Alpha.setZero();
}

template <typename Scalar, typename Preconditioner>
void ConjugateGradient<Scalar, Preconditioner>::UpdateDirection(const Dots& betas)
{
  const Row alpha = this->Alpha.template cast<Scalar>();
  const Row beta = betas.template cast<Scalar>();
  ParallelFor(this->Problem.Size(),
    [&](Index i)
    {
      const Row p = this->Direction.col(i);
      this->Steps.col(i) += alpha * p;
      this->Direction.col(i) = this->M.Row(i, this->Residual.col(i)) + beta * p;
    });
}
}

#endif
