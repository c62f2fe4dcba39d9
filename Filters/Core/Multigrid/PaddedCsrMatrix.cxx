// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Multigrid/PaddedCsrMatrix.h"

#include "Core/Base/Threading.h"

#include <algorithm>

namespace lmo
{
PaddedCsrMatrix::PaddedCsrMatrix(const SparseRows& matrix)
  : Offsets(matrix.rows() + 1)
{
  const Index* const offsets = matrix.outerIndexPtr();
  for (Index i = 0; i < this->Size(); ++i)
  {
    const Index entries = offsets[i + 1] - offsets[i];
    this->Offsets[i + 1] = this->Offsets[i] + (entries + Unit - 1) / Unit * Unit;
  }
  this->Columns.resize(this->Offsets.back());
  this->Values.resize(this->Offsets.back());
  ParallelFor(this->Size(),
    [&](Index i)
    {
      const Index first = this->Offsets[i];
      std::copy(matrix.innerIndexPtr() + offsets[i], matrix.innerIndexPtr() + offsets[i + 1],
        this->Columns.data() + first);
      std::copy(matrix.valuePtr() + offsets[i], matrix.valuePtr() + offsets[i + 1],
        this->Values.data() + first);
      for (Index k = first + offsets[i + 1] - offsets[i]; k < this->Offsets[i + 1]; ++k)
      {
        this->Columns[k] = this->Columns[k - 1];
        this->Values[k] = 0;
      }
    });
}

void Assign(const PaddedCsrMatrix& A, const PackedPoints<float>& x, PackedPoints<float>& product)
{
  A.WithRows(x,
    [&](const auto& rows)
    {
      ParallelFor(
        A.Size(), [=, product = View(product)](Index i) mutable { product.col(i) = rows(i); });
    });
}
}
