// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_EllpackStiffness_h
#define lmo_EllpackStiffness_h

#include "Core/LeastSquares/PackedPoints.h"
#include "Core/Operators/Laplacian.h"

namespace lmo
{
/// K = E - S with the first neighbours of each vertex in slots of fixed number: no branch depends
/// on the valence, which the processor could not predict. An unused slot names the vertex itself.
template <typename Scalar>
class EllpackStiffness
{
public:
  explicit EllpackStiffness(const Laplacian& L);

  /// Calls body(rows), where rows(i) is row i of K x and cheap to copy.
  template <typename Body>
  void WithRows(const PackedPoints<Scalar>& x, const Body& body) const
  {
    if (this->Weights.cols() > 0)
    {
      body(Rows<true>(*this, x));
    }
    else
    {
      body(Rows<false>(*this, x));
    }
  }

private:
  static constexpr int Slots = 8;

  template <bool Weighted>
  class Rows;

  std::shared_ptr<const AdjacencyLists> OneRings;
  std::shared_ptr<const Vector> EdgeWeights;
  Eigen::Array<Index, Slots, Eigen::Dynamic> Neighbours;
  Eigen::Array<Scalar, Slots, Eigen::Dynamic> Weights; ///< no columns if all are 1
};

template <typename Scalar>
template <bool Weighted>
class EllpackStiffness<Scalar>::Rows
{
public:
  Rows(const EllpackStiffness& K, const PackedPoints<Scalar>& x)
    : X(View(x))
    , Neighbours(K.Neighbours.data())
    , Weights(K.Weights.data())
    , Offsets(K.OneRings->offsets.data())
    , Ids(K.OneRings->ids.data())
    , EdgeWeights(Weighted ? K.EdgeWeights->data() : nullptr)
  {
  }

  PackedRow<Scalar> operator()(Index i) const
  {
    const PackedRow<Scalar> centre = this->X.col(i);
    const Index* neighbours = this->Neighbours + std::ptrdiff_t(Slots) * i;
    PackedRow<Scalar> row;
    if (Weighted)
    {
      const Scalar* weights = this->Weights + std::ptrdiff_t(Slots) * i;
      row.setZero();
      for (int slot = 0; slot < Slots; ++slot)
      {
        row += weights[slot] * (centre - this->X.col(neighbours[slot]));
      }
    }
    else
    {
      PackedRow<Scalar> even = this->X.col(neighbours[0]);
      PackedRow<Scalar> odd = this->X.col(neighbours[1]);
      for (int slot = 2; slot < Slots; slot += 2) // two sums at a time
      {
        even += this->X.col(neighbours[slot]);
        odd += this->X.col(neighbours[slot + 1]);
      }
      row = Scalar(Slots) * centre - (even + odd);
    }
    if (this->Offsets[i] + Slots < this->Offsets[i + 1])
    {
      this->AddOthers(i, row);
    }
    return row;
  }

private:
  /// The neighbours that have no slot.
  void AddOthers(Index i, PackedRow<Scalar>& row) const;

  const ConstPackedView<Scalar> X;
  const Index* Neighbours;
  const Scalar* Weights;
  const Index* Offsets;
  const Index* Ids;
  const double* EdgeWeights;
};

template <typename Scalar>
template <bool Weighted>
void EllpackStiffness<Scalar>::Rows<Weighted>::AddOthers(Index i, PackedRow<Scalar>& row) const
{
  for (Index k = this->Offsets[i] + Slots; k < this->Offsets[i + 1]; ++k)
  {
    const Scalar weight = Weighted ? Scalar(this->EdgeWeights[k]) : Scalar(1);
    row += weight * (this->X.col(i) - this->X.col(this->Ids[k]));
  }
}

extern template class EllpackStiffness<float>;
extern template class EllpackStiffness<double>;
}

#endif
