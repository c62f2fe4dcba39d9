// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_ConjugateGradient_h
#define lmo_ConjugateGradient_h

#include "Core/Mesh/Subdomain.h"
#include "Core/Solvers/ConvergenceTest.h"
#include "Core/Solvers/JacobiPreconditioner.h"

namespace lmo
{
/// Preconditioned conjugate gradients on x, y and z at once. Independent coordinates have step
/// lengths of their own and share the stopping test. Search directions have the precision of
/// Scalar; d and, from time to time, the residual are computed in double (residual replacement, van
/// der Vorst and Ye 2000), so that single precision reaches any tolerance at half the memory
/// traffic.
///
/// On a part of a mesh the processes iterate together. Ghosts are FIXED there: their owners move
/// them, and their rows drop out of all sums.
template <typename Scalar, typename Preconditioner>
class ConjugateGradient
{
public:
  /// Keeps references to the arguments.
  ConjugateGradient(const LeastSquaresProblem& problem, NormalOperator<Scalar>& A,
    Preconditioner& M, const Subdomain& domain);

  /// Improves \a solution until it meets the tolerance, the
  /// iterations are used up, the precision of Scalar allows no progress or more than \a affordable
  /// further iterations are predicted. Predictions are low where the residual falls ever slower.
  /// \throw Cancelled if the monitor says so; it is asked in every iteration, and more
  /// often where they take long.
  void Run(
    const SolverOptions& options, Index affordable, ProgressMonitor& monitor, Solution& solution);

private:
  using Row = PackedRow<Scalar>;

  /// A residual this much larger than the one carried along starts the directions anew.
  static constexpr double LargestDrift = 2;

  /// Computes the residual of d.
  /// \return its norm relative to |b|
  double ReplaceResidual(const Points& d);

  /// Computes M^-1 r and its inner product with r.
  void Precondition(ProgressMonitor& monitor);

  /// r -= alpha A p, and its inner product with M^-1 r if that needs no more than rows.
  /// \return the norm of r
  double StepResidual();

  /// d += the steps since the last call
  void Collect(Points& d);

  void UpdateDirection(const Dots& beta);

  Dots Couple(const Dots& dots) const
  {
    return this->IsCoupled ? Dots(Dots::Constant(dots.sum())) : dots;
  }

  const LeastSquaresProblem& Problem;
  NormalOperator<Scalar>& A;
  Preconditioner& M;
  const Subdomain& Domain;
  const bool IsCoupled; ///< the same in all processes that have vertices
  double Scale = 1;     ///< |b|, the unit of the packed vectors
  PackedPoints<Scalar> Residual;
  PackedPoints<Scalar> Direction;
  PackedPoints<Scalar> Product; ///< A times Direction
  PackedPoints<Scalar> Steps;   ///< sum of alpha p not yet in d
  Dots Alpha = Dots::Zero();
  Dots Rho = Dots::Zero(); ///< r M^-1 r
};
}

#include "Core/Solvers/ConjugateGradient.txx"

#endif
