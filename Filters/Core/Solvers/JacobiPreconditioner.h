// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_JacobiPreconditioner_h
#define lmo_JacobiPreconditioner_h

#include "Core/Base/ProgressMonitor.h"
#include "Core/LeastSquares/NormalOperator.h"

namespace lmo
{
/// Approximates A by its diagonal, or by its 3 x 3 diagonal blocks where x, y and z are coupled.
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
  class Rows
  {
  public:
    PackedRow<Scalar> operator()(Index i, const PackedRow<Scalar>& residual) const
    {
      PackedRow<Scalar> row = this->InverseDiagonal[i] * residual;
      if (this->NormalFactor)
      {
        const PackedRow<Scalar> normal = this->Normals.col(i);
        row -= this->NormalFactor[i] * (normal * residual).sum() * normal;
      }
      return row;
    }

  private:
    friend class JacobiPreconditioner;

    explicit Rows(const JacobiPreconditioner& M)
      : InverseDiagonal(M.InverseDiagonal.data())
      , Normals(View(M.Normals))
      , NormalFactor(M.Normals.cols() > 0 ? M.NormalFactor.data() : nullptr)
    {
    }

    const Scalar* InverseDiagonal;
    ConstPackedView<Scalar> Normals;
    const Scalar* NormalFactor;
  };

  Rows GetRows() const { return Rows(*this); }

private:
  using Values = Eigen::Array<Scalar, Eigen::Dynamic, 1>;

  Values InverseDiagonal;       ///< 0 at fixed vertices
  PackedPoints<Scalar> Normals; ///< of the tangent planes; no columns if there are none
  Values NormalFactor;          ///< of the second term in the inverse of a I + w^2 n n^T
};

extern template class JacobiPreconditioner<float>;
extern template class JacobiPreconditioner<double>;
}

#endif
