// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Multigrid/Multigrid.h"

#include "Core/Multigrid/ErrorAmplification.h"

#include <utility>

namespace lmo
{
namespace
{
/// Cotangents may be negative and need more smoothing, on the finest level.
int SmootherDegree(const ShiftedStiffness& matrix)
{
  return matrix.L.edgeWeights ? 5 : 3;
}

std::unique_ptr<SchurInverse<VCycle<PaddedCsrMatrix>>> Eliminate(
  const ShiftedStiffness& matrix, const std::vector<Index>& unknowns, ProgressMonitor& monitor)
{
  SchurElimination elimination(matrix, unknowns);
  monitor.Report(0);
  auto complement = std::make_shared<const PaddedCsrMatrix>(elimination.SchurComplement(matrix));
  const Index size = complement->Size();
  return std::make_unique<SchurInverse<VCycle<PaddedCsrMatrix>>>(std::move(elimination),
    std::make_unique<VCycle<PaddedCsrMatrix>>(
      std::move(complement), SmootherDegree(matrix), monitor),
    size);
}
}

Multigrid::Multigrid(std::shared_ptr<const ShiftedStiffness> matrix, ProgressMonitor& monitor)
  : Matrix(std::move(matrix))
{
  const std::vector<Index> unknowns = AmplifyingUnknowns(*this->Matrix);
  if (unknowns.empty())
  {
    this->Whole = std::make_unique<VCycle<ShiftedStiffness>>(
      this->Matrix, SmootherDegree(*this->Matrix), monitor);
  }
  else
  {
    this->Eliminated = Eliminate(*this->Matrix, unknowns, monitor);
  }
}

void Multigrid::Apply(
  const PackedPoints<float>& rightHandSide, PackedPoints<float>& solution, ProgressMonitor& monitor)
{
  monitor.Report(0);
  this->Whole ? this->Whole->Apply(rightHandSide, solution)
              : this->Eliminated->Apply(rightHandSide, solution);
}

void Multigrid::ApplyTransposed(
  const PackedPoints<float>& rightHandSide, PackedPoints<float>& solution, ProgressMonitor& monitor)
{
  monitor.Report(0);
  this->Whole ? this->Whole->ApplyTransposed(rightHandSide, solution)
              : this->Eliminated->ApplyTransposed(rightHandSide, solution);
}

std::size_t Multigrid::GetNumberOfLevels() const
{
  return this->Whole ? this->Whole->GetNumberOfLevels()
                     : this->Eliminated->GetInverse().GetNumberOfLevels();
}
}
