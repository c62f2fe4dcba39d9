// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_BilaplacianPreconditioner_h
#define lmo_BilaplacianPreconditioner_h

#include "Core/Base/Threading.h"
#include "Core/Multigrid/ShiftedStiffness.h"
#include "Core/Solvers/JacobiPreconditioner.h"

#include <utility>

namespace lmo
{
/// M = (K + R) Q (K + R) for the vertices that are free to move, the diagonal for the others. The
/// couplings of x, y and z are left to the iteration.
/// \tparam Inverse (K + R)^-1 or an approximation B: Apply(rightHandSide, solution, monitor) for B,
/// ApplyTransposed() for B^T. M^-1 is then B^T Q^-1 B.
template <typename Inverse>
class BilaplacianPreconditioner
{
public:
  static constexpr bool IsRowWise = false;

  /// Problems that need this preconditioner lose digits sooner.
  static constexpr double ReplacementRatio = 1e-1;

  /// \param matrix Q and the vertices left out
  BilaplacianPreconditioner(const LeastSquaresProblem& problem,
    std::shared_ptr<const ShiftedStiffness> matrix, std::shared_ptr<Inverse> inverse)
    : Matrix(std::move(matrix))
    , Factor(std::move(inverse))
    , Jacobi(problem)
    , Intermediate(4, this->Matrix->Size())
    , Result(4, this->Matrix->Size())
  {
  }

  /// Computes M^-1 residual.
  /// \throw Cancelled if the monitor says so.
  void Prepare(const PackedPoints<float>& residual, ProgressMonitor& monitor)
  {
    this->Factor->Apply(residual, this->Intermediate, monitor);
    ParallelFor(this->Matrix->Size(),
      [x = View(this->Intermediate), inverseQ = this->Matrix->inverseQ.data()](Index i) mutable
      { x.col(i) *= inverseQ[i]; });
    this->Factor->ApplyTransposed(this->Intermediate, this->Result, monitor);
  }

  /// The rows of M^-1 residual; cheap to copy.
  auto GetRows() const
  {
    return [result = View(this->Result), jacobi = this->Jacobi.GetRows(),
             isLeftOut = this->Matrix->isLeftOut.data()](Index i, const PackedRow<float>& residual)
    { return isLeftOut[i] ? jacobi(i, residual) : PackedRow<float>(result.col(i)); };
  }

private:
  std::shared_ptr<const ShiftedStiffness> Matrix;
  std::shared_ptr<Inverse> Factor;
  JacobiPreconditioner<float> Jacobi;
  PackedPoints<float> Intermediate;
  PackedPoints<float> Result;
};
}

#endif
