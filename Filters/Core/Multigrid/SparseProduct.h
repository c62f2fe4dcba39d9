// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_SparseProduct_h
#define lmo_SparseProduct_h

#include "Core/Base/Types.h"

namespace lmo
{
/// Sparse matrix by rows, in single precision.
using SparseRows = Eigen::SparseMatrix<float, Eigen::RowMajor, Index>;

/// Builds a sparse matrix row by row on several threads. The entries of a row stay in the order in
/// which their columns come first.
/// \param expectedEntries in a row, a guess that saves time
/// \param fill called as fill(i, add), which calls add(column, value) in any order; values of the
/// same column are added
template <typename Fill>
SparseRows MakeSparseRows(Index rows, Index columns, Index expectedEntries, const Fill& fill);

/// The rows of a sparse matrix, as Multiply() takes them.
class SparseRowList
{
public:
  explicit SparseRowList(const SparseRows& matrix)
    : Matrix(matrix)
  {
  }

  Index Size() const { return static_cast<Index>(this->Matrix.rows()); }

  /// Calls visit(column, value) for the entries of row i.
  template <typename Visit>
  void ForEachEntry(Index i, const Visit& visit) const
  {
    for (SparseRows::InnerIterator entry(this->Matrix, i); entry; ++entry)
    {
      visit(static_cast<Index>(entry.col()), entry.value());
    }
  }

private:
  const SparseRows& Matrix;
};

/// Entry i of the diagonal of a matrix that has ForEachEntry().
template <typename Matrix>
double DiagonalEntry(const Matrix& A, Index i)
{
  double diagonal = 0;
  A.ForEachEntry(i, [&](Index j, double value) { diagonal = j == i ? value : diagonal; });
  return diagonal;
}

/// A B on several threads; Eigen's own product has one.
/// \param A a list of rows, with Size() and ForEachEntry()
template <typename Rows>
SparseRows Multiply(const Rows& A, const SparseRows& B, Index expectedEntries);
}

#include "Core/Multigrid/SparseProduct.txx"

#endif
