// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_PetscSupport_h
#define lmo_PetscSupport_h

#include <petscksp.h>
#include <petscsf.h>

#include <string>
#include <utility>

namespace lmo
{
/// \throw SolverError with PETSc's text if \a code is not 0.
void Check(PetscErrorCode code);

/// The Euclidean norm, over all processes.
/// \throw SolverError for errors of PETSc.
double Norm(Vec vector);

/// Makes PETSc ready, if it is not, and its errors return codes as long as this object lives.
/// PETSc is finalized together with MPI. Options are read from the environment variable
/// PETSC_OPTIONS.
class PetscSession
{
public:
  /// Collective over \a comm, which becomes PETSc's world if PETSc is not ready.
  explicit PetscSession(MPI_Comm comm);
  ~PetscSession();
  PetscSession(const PetscSession&) = delete;
  void operator=(const PetscSession&) = delete;
};

/// False before PETSc is ready and after it is finalized.
bool IsPetscReady();

/// True if the name of an option, which has a leading '-', begins so in any process. Collective.
bool HasPetscOptions(MPI_Comm comm, const std::string& beginning);

/// Owns a PETSc object; leaves it alone if PETSc is finalized before.
template <typename Object, PetscErrorCode (*Destroy)(Object*)>
class PetscHandle
{
public:
  PetscHandle() = default;
  PetscHandle(PetscHandle&& other) noexcept { std::swap(this->Held, other.Held); }
  PetscHandle& operator=(PetscHandle&& other) noexcept
  {
    std::swap(this->Held, other.Held);
    return *this;
  }
  ~PetscHandle()
  {
    if (this->Held && IsPetscReady())
    {
      Destroy(&this->Held);
    }
  }

  operator Object() const { return this->Held; }

  /// For functions that create the object.
  Object* operator&() { return &this->Held; }

private:
  Object Held = nullptr;
};

using PetscVector = PetscHandle<Vec, VecDestroy>;
using PetscMatrix = PetscHandle<Mat, MatDestroy>;
using PetscKrylov = PetscHandle<KSP, KSPDestroy>;
using PetscPreconditioner = PetscHandle<PC, PCDestroy>;
using PetscStarForest = PetscHandle<PetscSF, PetscSFDestroy>;
}

#endif
