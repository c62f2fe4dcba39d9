// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Multigrid/SchurElimination.h"

#include "Core/Base/Threading.h"

namespace lmo
{
void SchurElimination::Prolong(const PackedPoints<float>& others,
  const PackedPoints<float>& rightHandSide, PackedPoints<float>& solution) const
{
  this->Prolongation.WithRows(others,
    [&](const auto& rows)
    {
      ParallelFor(this->Prolongation.Size(),
        [=, b = View(rightHandSide), inverseD = this->InverseDiagonal.data(), x = View(solution)](
          Index i) mutable { x.col(i) = rows(i) + inverseD[i] * b.col(i); });
    });
}
}
