// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "GhostVertices.h"

namespace lmo
{
namespace
{
/// Several numbers as one unit of communication. A single one has MPI's own type: PETSc takes types
/// of the same content for each other, but reduces none that are derived.
class UnitType
{
public:
  UnitType(int components, MPI_Datatype number)
    : IsDerived(components > 1)
    , Type(number)
  {
    if (this->IsDerived)
    {
      MPI_Type_contiguous(components, number, &this->Type);
      MPI_Type_commit(&this->Type);
    }
  }
  ~UnitType()
  {
    if (this->IsDerived)
    {
      MPI_Type_free(&this->Type);
    }
  }
  UnitType(const UnitType&) = delete;
  void operator=(const UnitType&) = delete;

  operator MPI_Datatype() const { return this->Type; }

private:
  const bool IsDerived;
  MPI_Datatype Type;
};
}

GhostVertices::GhostVertices(
  const Communicator& comm, Index owned, const std::vector<VertexPlace>& places)
{
  std::vector<PetscSFNode> owners(places.size());
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    owners[i] = { places[i].rank, places[i].number };
  }
  Check(PetscSFCreate(comm.Get(), &this->Forest));
  Check(PetscSFSetGraph(this->Forest, owned, static_cast<PetscInt>(owners.size()), nullptr,
    PETSC_COPY_VALUES, owners.data(), PETSC_COPY_VALUES));
  Check(PetscSFSetUp(this->Forest));
}

void GhostVertices::Update(const double* owners, double* ghosts, int components) const
{
  this->UpdateUnits(owners, ghosts, UnitType(components, MPI_DOUBLE));
}

void GhostVertices::Update(const float* owners, float* ghosts, int components) const
{
  this->UpdateUnits(owners, ghosts, UnitType(components, MPI_FLOAT));
}

void GhostVertices::UpdateUnits(const void* owners, void* ghosts, MPI_Datatype unit) const
{
  Check(PetscSFBcastBegin(this->Forest, unit, owners, ghosts, MPI_REPLACE));
  Check(PetscSFBcastEnd(this->Forest, unit, owners, ghosts, MPI_REPLACE));
}

void GhostVertices::ReduceMaximum(const double* ghosts, double* owners) const
{
  Check(PetscSFReduceBegin(this->Forest, MPI_DOUBLE, ghosts, owners, MPI_MAX));
  Check(PetscSFReduceEnd(this->Forest, MPI_DOUBLE, ghosts, owners, MPI_MAX));
}
}
