// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_PaddedCsrMatrix_h
#define lmo_PaddedCsrMatrix_h

#include "Core/LeastSquares/PackedPoints.h"
#include "Core/Multigrid/SparseProduct.h"

#include <vector>

namespace lmo
{
/// A sparse matrix for fast products with packed points: zeros fill each row up to a multiple of
/// four entries, since the processor could not predict where rows of any length end. They repeat
/// the column of the last entry.
class PaddedCsrMatrix
{
public:
  PaddedCsrMatrix() = default;
  explicit PaddedCsrMatrix(const SparseRows& matrix);

  /// Number of rows.
  Index Size() const { return static_cast<Index>(this->Offsets.size()) - 1; }

  /// Calls visit(column, value) for the entries of row i.
  template <typename Visit>
  void ForEachEntry(Index i, const Visit& visit) const
  {
    Index last = -1;
    for (Index k = this->Offsets[i]; k < this->Offsets[i + 1] && this->Columns[k] != last; ++k)
    {
      last = this->Columns[k];
      visit(last, this->Values[k]);
    }
  }

  /// Calls body(rows), where rows(i) is row i of A x and cheap to copy.
  template <typename Body>
  void WithRows(const PackedPoints<float>& x, const Body& body) const;

private:
  class Times;

  static constexpr Index Unit = 4;

  std::vector<Index> Offsets;
  Eigen::Array<Index, Eigen::Dynamic, 1> Columns;
  Eigen::ArrayXf Values;
};

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

/// product = A x
void Assign(const PaddedCsrMatrix& A, const PackedPoints<float>& x, PackedPoints<float>& product);

template <typename Body>
void PaddedCsrMatrix::WithRows(const PackedPoints<float>& x, const Body& body) const
{
  body(Times(*this, x));
}
}

#endif
