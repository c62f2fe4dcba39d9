// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_MultigridPreconditioner_h
#define lmo_MultigridPreconditioner_h

#include "Core/Multigrid/ShiftedStiffness.h"
#include "DistributedEquations.h"

namespace lmo
{
/// M = (K + R) Q (K + R) as in BilaplacianPreconditioner, where a cycle of hypre's BoomerAMG, or
/// another preconditioner chosen with the options -lmo_amg_..., stands for (K + R)^-1.
class MultigridPreconditioner
{
public:
  /// Collective. Keeps a reference to \a equations.
  explicit MultigridPreconditioner(const DistributedEquations& equations);

  /// result = M^-1 residual
  void Apply(Vec residual, Vec result) const;

private:
  void FormMatrix();

  const DistributedEquations& Equations;
  ShiftedStiffness Shifted;
  PetscMatrix Matrix; ///< K + R
  PetscPreconditioner Inverse;
  PetscVector Component;
  PetscVector Intermediate;
};
}

#endif
