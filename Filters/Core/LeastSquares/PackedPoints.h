// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_PackedPoints_h
#define lmo_PackedPoints_h

#include "Core/Base/Types.h"

namespace lmo
{
/// A row (x, y, z, 0) per vertex, which the processor handles as one unit.
template <typename Scalar>
using PackedPoints = Eigen::Array<Scalar, 4, Eigen::Dynamic>;

template <typename Scalar>
using PackedRow = Eigen::Array<Scalar, 4, 1>;

/// Packed points by their address. Loops that are to be fast capture such views by value: then
/// addresses stay in registers.
template <typename Scalar>
using PackedView = Eigen::Map<PackedPoints<Scalar>, Eigen::Aligned16>;

template <typename Scalar>
PackedView<Scalar> View(PackedPoints<Scalar>& points)
{
  return { points.data(), 4, points.cols() };
}

template <typename Scalar>
using ConstPackedView = Eigen::Map<const PackedPoints<Scalar>, Eigen::Aligned16>;

template <typename Scalar>
ConstPackedView<Scalar> View(const PackedPoints<Scalar>& points)
{
  return { points.data(), 4, points.cols() };
}

template <typename Scalar>
PackedRow<Scalar> Pack(const Vector3& x)
{
  return { Scalar(x[0]), Scalar(x[1]), Scalar(x[2]), Scalar(0) };
}

template <typename Scalar>
Vector3 ToVector(const PackedRow<Scalar>& row)
{
  return row.template head<3>().template cast<double>();
}

/// A symmetric 3 x 3 matrix per vertex, as three packed rows.
template <typename Scalar>
using PackedMatrices = Eigen::Array<Scalar, 12, Eigen::Dynamic>;

template <typename Scalar>
void StoreMatrix(const Matrix3& matrix, Index i, PackedMatrices<Scalar>& matrices)
{
  for (int row = 0; row < 3; ++row)
  {
    matrices.col(i).template segment<3>(4 * row) = matrix.col(row).array().template cast<Scalar>();
    matrices(4 * row + 3, i) = 0;
  }
}

/// The product of a row with a symmetric matrix that starts at \a matrix.
template <typename Scalar>
EIGEN_ALWAYS_INLINE PackedRow<Scalar> MultiplyPacked(
  const Scalar* matrix, const PackedRow<Scalar>& x)
{
  using Row = Eigen::Map<const PackedRow<Scalar>, Eigen::Aligned16>;
  return x[0] * Row(matrix) + x[1] * Row(matrix + 4) + x[2] * Row(matrix + 8);
}
}

#endif
