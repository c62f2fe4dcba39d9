// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Multigrid/MultilevelBasis.h"

#include "Core/Base/Threading.h"
#include "Core/Multigrid/BasisEnergies.h"
#include "Core/Multigrid/BasisFunctions.h"

namespace lmo
{
MultilevelBasis::MultilevelBasis(const LeastSquaresProblem& problem, ProgressMonitor& monitor)
{
  constexpr Index expectedEntries = 8;
  SparseRows functions; // on the vertices
  for (const SparseRows& shares : BasisFunctions(*problem.laplacian.L.rings, monitor))
  {
    monitor.Report(0);
    functions =
      this->Scales.empty() ? shares : Multiply(SparseRowList(functions), shares, expectedEntries);
    const Eigen::ArrayXf energies = BasisEnergies(problem, functions);
    this->Scales.push_back({ PaddedCsrMatrix(shares), PaddedCsrMatrix(shares.transpose()),
      (energies > 0).select(1 / energies, 0.0f), PackedPoints<float>(4, energies.size()) });
  }
}

void MultilevelBasis::Expand(const PackedPoints<float>& residual)
{
  const PackedPoints<float>* finer = &residual;
  for (Scale& scale : this->Scales)
  {
    Assign(scale.restriction, *finer, scale.values);
    finer = &scale.values;
  }
  for (std::size_t k = this->Scales.size(); k-- > 0;)
  {
    Scale& scale = this->Scales[k];
    const auto weigh = [&](const auto& coarser)
    {
      ParallelFor(static_cast<Index>(scale.values.cols()),
        [coarser, values = View(scale.values), factors = scale.inverseEnergies.data()](
          Index i) mutable { values.col(i) = factors[i] * values.col(i) + coarser(i); });
    };
    if (k + 1 == this->Scales.size())
    {
      weigh([](Index) { return PackedRow<float>(PackedRow<float>::Zero()); });
    }
    else
    {
      this->Scales[k + 1].prolongation.WithRows(this->Scales[k + 1].values, weigh);
    }
  }
}
}
