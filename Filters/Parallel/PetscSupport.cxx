// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "PetscSupport.h"

#include "Core/Base/Exceptions.h"

namespace lmo
{
namespace
{
/// MPI_Finalize() deletes the attributes of MPI_COMM_SELF first, when MPI still works.
int FinalizePetsc(MPI_Comm, int, void*, void*)
{
  PetscFinalize();
  return MPI_SUCCESS;
}

void InitializePetsc(MPI_Comm comm)
{
  PETSC_COMM_WORLD = comm;
  Check(PetscInitializeNoArguments());
  Check(PetscPopSignalHandler()); // signals are the application's
  int key = MPI_KEYVAL_INVALID;
  MPI_Comm_create_keyval(MPI_COMM_NULL_COPY_FN, FinalizePetsc, &key, nullptr);
  MPI_Comm_set_attr(MPI_COMM_SELF, key, nullptr);
  MPI_Comm_free_keyval(&key);
}
}

void Check(PetscErrorCode code)
{
  if (code)
  {
    const char* general = nullptr;
#if PETSC_VERSION_GE(3, 25, 0)
    const char* specific = nullptr;
#else
    char* specific = nullptr;
#endif
    PetscErrorMessage(code, &general, &specific);
    throw SolverError(std::string("PETSc: ") + (general ? general : "error") +
                      (specific && *specific ? std::string(": ") + specific : std::string()));
  }
}

double Norm(Vec vector)
{
  double norm = 0;
  Check(VecNorm(vector, NORM_2, &norm));
  return norm;
}

bool IsPetscReady()
{
  PetscBool isInitialized = PETSC_FALSE;
  PetscBool isFinalized = PETSC_FALSE;
  PetscInitialized(&isInitialized);
  PetscFinalized(&isFinalized);
  return isInitialized && !isFinalized;
}

bool HasPetscOptions(MPI_Comm comm, const std::string& beginning)
{
  char* options = nullptr;
  Check(PetscOptionsGetAll(nullptr, &options));
  int isFound = std::string(options).find(beginning) != std::string::npos;
  Check(PetscFree(options));
  MPI_Allreduce(MPI_IN_PLACE, &isFound, 1, MPI_INT, MPI_MAX, comm);
  return isFound != 0;
}

PetscSession::PetscSession(MPI_Comm comm)
{
  if (!IsPetscReady())
  {
    InitializePetsc(comm);
  }
  Check(PetscPushErrorHandler(PetscReturnErrorHandler, nullptr));
}

PetscSession::~PetscSession()
{
  PetscPopErrorHandler();
}
}
