// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/LeastSquares/EllpackStiffness.h"

#include "Core/Base/Threading.h"

namespace lmo
{
template <typename Scalar>
EllpackStiffness<Scalar>::EllpackStiffness(const Laplacian& L)
  : OneRings(L.rings)
  , EdgeWeights(L.edgeWeights)
{
  const AdjacencyLists& rings = *L.rings;
  const auto rows = static_cast<Index>(rings.offsets.size()) - 1;
  this->Neighbours.resize(Slots, rows);
  this->Weights.resize(Slots, L.edgeWeights ? rows : 0);
  ParallelFor(rows,
    [&](Index i)
    {
      const Index used = std::min<Index>(rings.Size(i), Slots);
      for (Index slot = 0; slot < Slots; ++slot)
      {
        this->Neighbours(slot, i) = slot < used ? rings.Begin(i)[slot] : i;
        if (L.edgeWeights)
        {
          this->Weights(slot, i) =
            slot < used ? Scalar((*L.edgeWeights)[rings.offsets[i] + slot]) : Scalar(0);
        }
      }
    });
}

template class EllpackStiffness<float>;
template class EllpackStiffness<double>;
}
