// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_PaddedCsrMatrix_h
#define lmo_PaddedCsrMatrix_h

#include "Core/LeastSquares/EllpackStiffness.h"
#include "Core/Multigrid/SparseProduct.h"

namespace lmo
{
/// A sparse matrix for fast products with packed points: zeros fill each row up to a multiple of
/// four entries, since the processor could not predict where rows of any length end.
class PaddedCsrMatrix
{
public:
  PaddedCsrMatrix() = default;
  explicit PaddedCsrMatrix(const SparseRows& matrix);

  Index Size() const { return static_cast<Index>(this->Offsets.size()) - 1; }

  class Times;

private:
  static constexpr Index Unit = 4;

  std::vector<Index> Offsets;
  std::vector<Index> Columns;
  std::vector<float> Values;
};

/// The rows of A x; cheap to copy.
class PaddedCsrMatrix::Times
{
public:
  Times(const PaddedCsrMatrix& A, const PackedPoints<float>& x)
    : X(View(x))
    , Offsets(A.Offsets.data())
    , Columns(A.Columns.data())
    , Values(A.Values.data())
  {
  }

  PackedRow<float> operator()(Index i) const
  {
    PackedRow<float> even = PackedRow<float>::Zero();
    PackedRow<float> odd = PackedRow<float>::Zero();
    const Index end = this->Offsets[i + 1];
    for (Index k = this->Offsets[i]; k < end; k += Unit)
    {
      even += this->Values[k] * this->X.col(this->Columns[k]);
      odd += this->Values[k + 1] * this->X.col(this->Columns[k + 1]);
      even += this->Values[k + 2] * this->X.col(this->Columns[k + 2]);
      odd += this->Values[k + 3] * this->X.col(this->Columns[k + 3]);
    }
    return even + odd;
  }

private:
  const ConstPackedView<float> X;
  const Index* Offsets;
  const Index* Columns;
  const float* Values;
};
}

#endif
