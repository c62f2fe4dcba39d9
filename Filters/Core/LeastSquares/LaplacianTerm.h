// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_LaplacianTerm_h
#define lmo_LaplacianTerm_h

#include "Core/Operators/Laplacian.h"

namespace lmo
{
/// |W_L (L d - c)|^2 with c = f - L V.
struct LaplacianTerm
{
  Laplacian L;
  Vector weights;                                ///< diagonal of W_L
  std::shared_ptr<const Points> target;          ///< c
  std::shared_ptr<const Vector> softEdgeWeights; ///< for multigrid: those of L without the
                                                 ///< largest; null stands for those of L

  /// Q = (G W_L)^2: with K = E - S, L^T W_L^2 L is K Q K.
  double RowWeight(Index i) const
  {
    const double weight = this->L.rowScale[i] * this->weights[i];
    return weight * weight;
  }
};
}

#endif
