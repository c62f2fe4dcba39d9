// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_SquaredPreconditioner_h
#define lmo_SquaredPreconditioner_h

#include "Parallel.h"
#include "ShiftedStiffness.h"

namespace lmo
{
/// M = (K + R) Q (K + R). The couplings of x, y and z are left to the iteration.
/// \tparam Inverse (K + R)^-1 or a symmetric approximation: Apply(rightHandSide, solution)
template <typename Inverse>
class SquaredPreconditioner
{
public:
  static constexpr bool IsRowWise = false;

  explicit SquaredPreconditioner(const ShiftedStiffness& matrix)
    : Factor(matrix)
    , InverseQ(matrix.inverseQ)
    , Intermediate(4, matrix.Size())
    , Result(4, matrix.Size())
  {
  }

  /// Computes M^-1 residual.
  void Prepare(const PackedPoints<float>& residual)
  {
    this->Factor.Apply(residual, this->Intermediate);
    ParallelFor(static_cast<Index>(this->InverseQ.size()),
      [x = View(this->Intermediate), inverseQ = this->InverseQ.data()](Index i) mutable
      { x.col(i) *= inverseQ[i]; });
    this->Factor.Apply(this->Intermediate, this->Result);
  }

  /// The rows of M^-1 residual; cheap to copy.
  auto GetRows() const
  {
    return [result = View(this->Result)](Index i, const PackedRow<float>&)
    { return PackedRow<float>(result.col(i)); };
  }

private:
  Inverse Factor;
  const ShiftedStiffness::Values& InverseQ;
  PackedPoints<float> Intermediate;
  PackedPoints<float> Result;
};
}

#endif
