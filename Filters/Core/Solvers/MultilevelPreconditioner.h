// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_MultilevelPreconditioner_h
#define lmo_MultilevelPreconditioner_h

#include "Core/Base/Threading.h"
#include "Core/LeastSquares/PackedProjections.h"
#include "Core/Multigrid/MultilevelBasis.h"
#include "Core/Solvers/JacobiPreconditioner.h"

namespace lmo
{
/// M^-1 r is the inverse diagonal of A times r, for short waves, plus the projection, on what the
/// constraints allow, of the MultilevelBasis' sum times r, for long ones.
class MultilevelPreconditioner
{
public:
  static constexpr bool IsRowWise = false;
  static constexpr double ReplacementRatio = JacobiPreconditioner<float>::ReplacementRatio;

  /// \param problem with LeastSquaresProblem::IsCoupled()
  /// \param basis of this or a similar problem
  MultilevelPreconditioner(const LeastSquaresProblem& problem, MultilevelBasis& basis)
    : Jacobi(problem)
    , Projections(problem)
    , Basis(basis)
    , Result(4, problem.Size())
  {
  }

  /// Computes M^-1 residual.
  void Prepare(const PackedPoints<float>& residual, ProgressMonitor&)
  {
    this->Basis.WithRows(residual,
      [&](const auto& longWaves)
      {
        ParallelFor(static_cast<Index>(this->Result.cols()),
          [longWaves, jacobi = this->Jacobi.GetRows(), project = this->Projections.GetRows(),
            residual = View(residual), result = View(this->Result)](Index i) mutable
          { result.col(i) = jacobi(i, residual.col(i)) + project(i, longWaves(i)); });
      });
  }

  /// The rows of M^-1 residual; cheap to copy.
  auto GetRows() const
  {
    return [result = View(this->Result)](Index i, const PackedRow<float>&)
    { return PackedRow<float>(result.col(i)); };
  }

private:
  JacobiPreconditioner<float> Jacobi;
  PackedProjections<float> Projections;
  MultilevelBasis& Basis;
  PackedPoints<float> Result;
};
}

#endif
