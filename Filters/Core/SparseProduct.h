// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_SparseProduct_h
#define lmo_SparseProduct_h

#include "Types.h"

namespace lmo
{
/// Sparse matrix by rows, in single precision.
using SparseRows = Eigen::SparseMatrix<float, Eigen::RowMajor, Index>;

/// Builds a sparse matrix row by row on several threads.
/// \param fill called as fill(i, add), which calls add(column, value) in any order; values of the
/// same column are added
template <typename Fill>
SparseRows MakeSparseRows(Index rows, Index columns, const Fill& fill);

/// A B on several threads; Eigen's own product has one.
SparseRows Multiply(const SparseRows& A, const SparseRows& B);
}

#include "SparseProduct.txx"

#endif
