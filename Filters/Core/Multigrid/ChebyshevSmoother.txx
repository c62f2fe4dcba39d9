// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_ChebyshevSmoother_txx
#define lmo_ChebyshevSmoother_txx

#include "Core/Base/Threading.h"

#include <cmath>
#include <utility>

namespace lmo
{
template <typename Matrix>
ChebyshevSmoother::ChebyshevSmoother(const Matrix& A, int degree)
  : Steps(MakeSteps(degree))
  , Scale(A.Size())
  , Previous(4, A.Size())
{
  ParallelFor(A.Size(),
    [&](Index i)
    {
      float sum = 0;
      A.ForEachEntry(i, [&](Index, double value) { sum += std::abs(static_cast<float>(value)); });
      this->Scale[i] = sum > 0 ? 2 / sum : 0;
    });
}

template <typename Matrix>
void ChebyshevSmoother::SmoothFromZero(
  const Matrix& A, const PackedPoints<float>& b, PackedPoints<float>& x)
{
  ParallelFor(this->Size(),
    [b = View(b), x = View(x), previous = View(this->Previous), scale = this->Scale.data(),
      factor = this->Steps[0].factor](Index i) mutable
    {
      previous.col(i).setZero();
      x.col(i) = factor * scale[i] * b.col(i);
    });
  this->SmoothFrom(1, A, b, x);
}

template <typename Matrix>
void ChebyshevSmoother::SmoothFrom(
  std::size_t first, const Matrix& A, const PackedPoints<float>& b, PackedPoints<float>& x)
{
  using Row = PackedRow<float>;
  for (std::size_t k = first; k < this->Steps.size(); ++k)
  {
    A.WithRows(x,
      [&](const auto& rows)
      {
        ParallelFor(this->Size(),
          [rows, b = View(b), x = View(std::as_const(x)), previous = View(this->Previous),
            scale = this->Scale.data(), step = this->Steps[k], hasPrevious = k > 0](Index i) mutable
          {
            const Row old = x.col(i);
            const Row before = hasPrevious ? Row(previous.col(i)) : old;
            previous.col(i) =
              old + step.momentum * (old - before) + step.factor * scale[i] * (b.col(i) - rows(i));
          });
      });
    x.swap(this->Previous);
  }
}
}

#endif
