// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_SmoothedAggregation_h
#define lmo_SmoothedAggregation_h

#include "Core/Multigrid/ChebyshevSmoother.h"
#include "Core/Multigrid/SparseProduct.h"

#include <vector>

/// Coarsening of a symmetric matrix by smoothed aggregation (Vanek, Mandel, Brezina 1996). A matrix
/// has Size() and ForEachEntry() as ChebyshevSmoother describes them.
namespace lmo
{
/// Groups of strongly connected unknowns.
struct Aggregation
{
  std::vector<Index> aggregateOf; ///< of each unknown; -1 for one without strong connections, which
                                  ///< the smoother alone solves for
  Index count = 0;
};

template <typename Matrix>
Aggregation Aggregate(const Matrix& A);

/// (I - 4 / (3 lambda) D A) times the piecewise constant prolongation, D and lambda the smoother's
/// scale and bound of the eigenvalues.
template <typename Matrix>
SparseRows SmoothedProlongation(
  const Matrix& A, const ChebyshevSmoother& smoother, const Aggregation& aggregation);
}

#include "Core/Multigrid/SmoothedAggregation.txx"

#endif
