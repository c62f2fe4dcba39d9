// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MultigridPreconditioner.h"

namespace lmo
{
MultigridPreconditioner::MultigridPreconditioner(const DistributedEquations& equations)
  : Equations(equations)
  , Shifted(equations.GetProblem(), nullptr)
  , Component(equations.MakeVector(1))
  , Intermediate(equations.MakeVector(1))
{
  this->FormMatrix();
  Check(PCCreate(equations.GetComm(), &this->Inverse));
  Check(PCSetOptionsPrefix(this->Inverse, "lmo_amg_"));
  Check(PCSetType(this->Inverse, PCHYPRE));
  Check(PCHYPRESetType(this->Inverse, "boomeramg"));
  Check(PCSetOperators(this->Inverse, this->Matrix, this->Matrix));
  Check(PCSetFromOptions(this->Inverse));
  Check(PCSetUp(this->Inverse));
}

void MultigridPreconditioner::FormMatrix()
{
  const DistributedMesh& mesh = this->Equations.GetMesh();
  const Index owned = mesh.GetNumberOfOwned();
  std::vector<PetscInt> offsets{ 0 };
  std::vector<PetscInt> columns;
  std::vector<double> values;
  for (Index i = 0; i < owned; ++i)
  {
    this->Shifted.ForEachEntryWithIdentity(i,
      [&](Index column, double value)
      {
        columns.push_back(static_cast<PetscInt>(mesh.GetRow(column)));
        values.push_back(value);
      });
    offsets.push_back(static_cast<PetscInt>(columns.size()));
  }
  Check(MatCreateMPIAIJWithArrays(this->Equations.GetComm(), owned, owned, PETSC_DETERMINE,
    PETSC_DETERMINE, offsets.data(), columns.data(), values.data(), &this->Matrix));
}

void MultigridPreconditioner::Apply(Vec residual, Vec result) const
{
  this->Equations.ApplyJacobi(residual, result); // for the vertices left out
  const Index owned = this->Equations.GetMesh().GetNumberOfOwned();
  for (int c = 0; c < 3; ++c)
  {
    {
      const VectorValues values(residual);
      const VectorRoom room(this->Component);
      for (Index i = 0; i < owned; ++i)
      {
        room.Get()[i] = this->Shifted.isLeftOut[i] ? 0 : values.Get()[3 * std::ptrdiff_t(i) + c];
      }
    }
    Check(PCApply(this->Inverse, this->Component, this->Intermediate));
    {
      const VectorRoom room(this->Intermediate);
      for (Index i = 0; i < owned; ++i)
      {
        room.Get()[i] *= this->Shifted.inverseQ[i];
      }
    }
    Check(PCApply(this->Inverse, this->Intermediate, this->Component));
    const VectorValues values(this->Component);
    const VectorRoom room(result);
    for (Index i = 0; i < owned; ++i)
    {
      if (!this->Shifted.isLeftOut[i])
      {
        room.Get()[3 * std::ptrdiff_t(i) + c] = values.Get()[i];
      }
    }
  }
}
}
