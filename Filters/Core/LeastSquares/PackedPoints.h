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
}

#endif
