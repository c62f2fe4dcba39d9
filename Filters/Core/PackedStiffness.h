// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_PackedStiffness_h
#define lmo_PackedStiffness_h

#include "Laplacian.h"

namespace lmo
{
/// A row (x, y, z, 0) per vertex, which the processor handles as one unit.
template <typename Scalar>
using PackedPoints = Eigen::Array<Scalar, 4, Eigen::Dynamic>;

template <typename Scalar>
using PackedRow = Eigen::Array<Scalar, 4, 1>;

/// K = E - S with the first neighbours of each vertex in slots of fixed number: no branch depends
/// on the valence, which the processor could not predict. An unused slot names the vertex itself.
template <typename Scalar>
class PackedStiffness
{
public:
  explicit PackedStiffness(const Laplacian& L);

  bool IsWeighted() const { return this->Weights.cols() > 0; }

  /// Row i of K x.
  template <bool Weighted>
  PackedRow<Scalar> Row(const PackedPoints<Scalar>& x, Index i) const
  {
    const PackedRow<Scalar> centre = x.col(i);
    PackedRow<Scalar> sum = PackedRow<Scalar>::Zero();
    for (int slot = 0; slot < Slots; ++slot)
    {
      const PackedRow<Scalar> difference = centre - x.col(this->Neighbours(slot, i));
      sum += Weighted ? PackedRow<Scalar>(this->Weights(slot, i) * difference) : difference;
    }
    const AdjacencyLists& rings = *this->L.rings;
    for (Index k = rings.offsets[i] + Slots; k < rings.offsets[i + 1]; ++k)
    {
      const Scalar weight = Weighted ? Scalar((*this->L.edgeWeights)[k]) : Scalar(1);
      sum += weight * (centre - x.col(rings.ids[k]));
    }
    return sum;
  }

private:
  static constexpr int Slots = 8;

  const Laplacian& L;
  Eigen::Array<Index, Slots, Eigen::Dynamic> Neighbours;
  Eigen::Array<Scalar, Slots, Eigen::Dynamic> Weights; ///< no columns if all are 1
};

extern template class PackedStiffness<float>;
extern template class PackedStiffness<double>;
}

#endif
