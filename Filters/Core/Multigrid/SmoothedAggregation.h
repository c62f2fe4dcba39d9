// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_SmoothedAggregation_h
#define lmo_SmoothedAggregation_h

#include "Core/Multigrid/SparseProduct.h"

#include <vector>

/// Coarsening of a symmetric matrix by smoothed aggregation (Vanek, Mandel, Brezina 1996). Matrices
/// are lists of rows, with Size() and ForEachEntry(row, visit).
namespace lmo
{
/// What SmootherScale() bounds.
constexpr float LargestEigenvalue = 2;

/// A diagonal: reciprocals of half the rows' sums of magnitudes. No eigenvalue of the matrix scaled
/// by it is above 2 (Gershgorin). Unlike one bound for the whole matrix it is local: triangles with
/// large negative cotangents slow down a smoother only where they are.
template <typename Rows>
Eigen::ArrayXf SmootherScale(const Rows& A);

/// Groups of strongly connected unknowns.
struct Aggregation
{
  std::vector<Index> aggregateOf; ///< of each unknown; -1 for one without strong connections, which
                                  ///< the smoother alone solves for
  Index count = 0;
};

template <typename Rows>
Aggregation Aggregate(const Rows& A);

/// (I - 4 / (3 lambda) D A) times the piecewise constant prolongation, D the smoother's scale.
template <typename Rows>
SparseRows SmoothedProlongation(
  const Rows& A, const Eigen::ArrayXf& smootherScale, const Aggregation& aggregation);
}

#include "Core/Multigrid/SmoothedAggregation.txx"

#endif
