// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_JacobiPreconditioner_h
#define lmo_JacobiPreconditioner_h

#include "Core/Base/ProgressMonitor.h"
#include "Core/LeastSquares/NormalOperator.h"

namespace lmo
{
/// Approximates A by its diagonal, or by its 3 x 3 diagonal blocks if a term mixes x, y and z.
/// A preconditioner M gives M^-1 r in two steps: Prepare(r) does what needs the whole residual, of
/// which there is nothing here, and GetRows()(i, r_i) returns row i of the result.
template <typename Scalar>
class JacobiPreconditioner
{
public:
  static constexpr bool IsRowWise = true; ///< rows need nothing but r_i

  /// A residual this much smaller than the last one computed in double is computed anew.
  static constexpr double ReplacementRatio = 1e-6;

  explicit JacobiPreconditioner(const LeastSquaresProblem& problem);

  void Prepare(const PackedPoints<Scalar>&, ProgressMonitor&) {}

  /// Cheap to copy.
  auto GetRows() const
  {
    return [isCoupled = this->InverseBlocks.cols() > 0, blocks = this->InverseBlocks.data(),
             diagonal = this->InverseDiagonal.data()](Index i, const PackedRow<Scalar>& residual)
    {
      return isCoupled ? MultiplyPacked(blocks + 12 * std::ptrdiff_t(i), residual)
                       : PackedRow<Scalar>(diagonal[i] * residual);
    };
  }

private:
  Eigen::Array<Scalar, Eigen::Dynamic, 1> InverseDiagonal; ///< 0 at fixed vertices
  PackedMatrices<Scalar> InverseBlocks;                    ///< instead, if a term mixes x, y and z
};

extern template class JacobiPreconditioner<float>;
extern template class JacobiPreconditioner<double>;
}

#endif
