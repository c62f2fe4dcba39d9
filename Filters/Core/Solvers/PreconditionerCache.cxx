// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solvers/PreconditionerCache.h"

#include "Core/Base/BackgroundTask.h"

#include <utility>

namespace lmo
{
std::shared_ptr<Multigrid> PreconditionerCache::GetMultigrid(
  std::shared_ptr<const ShiftedStiffness> matrix, ProgressMonitor& monitor)
{
  if (!this->Hierarchy || !this->Hierarchy->GetMatrix().IsEqualTo(*matrix))
  {
    this->Hierarchy.reset(); // its memory serves for the next one
    this->Hierarchy = std::make_shared<Multigrid>(std::move(matrix), monitor);
    ++this->NumberOfHierarchies;
  }
  return this->Hierarchy;
}

std::shared_ptr<ShiftedCholesky> PreconditionerCache::GetFactorisation(
  const std::shared_ptr<const ShiftedStiffness>& matrix, ProgressMonitor& monitor)
{
  if (!this->Factorisation || !this->Factorisation->GetMatrix().IsEqualTo(*matrix))
  {
    const std::shared_ptr<ShiftedCholesky> previous = std::move(this->Factorisation);
    this->Factorisation = RunInBackground(monitor,
      [matrix, previous] { return std::make_shared<ShiftedCholesky>(matrix, previous.get()); });
    ++this->NumberOfFactorisations;
    this->NumberOfOrders += !previous || previous->GetOrder() != this->Factorisation->GetOrder();
  }
  return this->Factorisation;
}
}
