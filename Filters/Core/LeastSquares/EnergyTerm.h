// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_EnergyTerm_h
#define lmo_EnergyTerm_h

#include "Core/LeastSquares/PackedPoints.h"

/// A term of the energy is a struct with its data and with the forms in which the solvers need it:
///
/// - double Energy(const Points& d) const: its value at the displacement d.
/// - auto ResidualRows(const Points& d) const: a function (i, sum) that adds row i of -1/2 of the
///   gradient at d to the Vector3 sum. Here, d without rows stands for 0.
/// - void AddDiagonal(Index i, DiagonalBlock& block) const: its part of the i-th diagonal block of
///   the matrix A of the normal equations.
/// - void AddEntries(MatrixEntries& entries) const: its part of A.
/// - bool IsCoupled() const: true if it mixes x, y and z.
/// - template <typename Scalar> class Product: made from the term, a fast form of its part of A.
///   Prepare(x) does what needs other rows of x than the i-th; then WithRows(body) calls
///   body(rows), where rows, cheap to copy, is a function (i, row i of x, sum) that adds row i of
///   the product with x. IsForCoupled is true if problems that are not coupled never have the term.
///
/// A term that a problem does not have stores nothing and adds nothing.
namespace lmo
{
/// The matrix isotropic I + coupled, where I is the 3 x 3 identity.
struct DiagonalBlock
{
  double isotropic = 0;
  Matrix3 coupled = Matrix3::Zero();
};

/// A symmetric block of rows 3i to 3i + 2 and columns 3j to 3j + 2.
struct BlockEntry
{
  Index row;
  Index column;
  Matrix3 value;
};

/// Entries to be summed.
struct MatrixEntries
{
  std::vector<Eigen::Triplet<double, Index>> isotropic; ///< multiples of the 3 x 3 identity
  std::vector<BlockEntry> coupled;
};
}

#endif
