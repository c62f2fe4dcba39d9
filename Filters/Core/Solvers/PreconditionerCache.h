// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_PreconditionerCache_h
#define lmo_PreconditionerCache_h

#include "Core/Multigrid/Multigrid.h"
#include "Core/Multigrid/ShiftedCholesky.h"

namespace lmo
{
/// Inverses of K + R, kept for the next problem: the last of each kind is used again if the matrix
/// is the same, and its order of the unknowns if the pattern is.
class PreconditionerCache
{
public:
  /// \throw Cancelled if the monitor says so.
  std::shared_ptr<Multigrid> GetMultigrid(
    std::shared_ptr<const ShiftedStiffness> matrix, ProgressMonitor& monitor);

  /// \throw SolverError if the matrix is singular.
  /// \throw Cancelled if the monitor says so.
  std::shared_ptr<ShiftedCholesky> GetFactorisation(
    const std::shared_ptr<const ShiftedStiffness>& matrix, ProgressMonitor& monitor);

  /// How many have been made so far.
  int GetNumberOfHierarchies() const { return this->NumberOfHierarchies; }
  int GetNumberOfFactorisations() const { return this->NumberOfFactorisations; }
  int GetNumberOfOrders() const { return this->NumberOfOrders; }

private:
  std::shared_ptr<Multigrid> Hierarchy;
  std::shared_ptr<ShiftedCholesky> Factorisation;
  int NumberOfHierarchies = 0;
  int NumberOfFactorisations = 0;
  int NumberOfOrders = 0;
};
}

#endif
