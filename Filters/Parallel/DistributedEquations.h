// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_DistributedEquations_h
#define lmo_DistributedEquations_h

#include "Core/Solvers/JacobiPreconditioner.h"
#include "DistributedMesh.h"

namespace lmo
{
/// The normal equations of a problem on a distributed mesh for PETSc: vectors hold x, y, z of each
/// vertex that a process owns. The matrix is applied, never formed: ghosts are updated, then each
/// process does what one process does with a whole mesh.
class DistributedEquations
{
public:
  /// Keeps references to the arguments.
  DistributedEquations(const LeastSquaresProblem& problem, const DistributedMesh& mesh);
  DistributedEquations(const DistributedEquations&) = delete;
  void operator=(const DistributedEquations&) = delete;

  const LeastSquaresProblem& GetProblem() const { return this->Problem; }
  const DistributedMesh& GetMesh() const { return this->Mesh; }
  MPI_Comm GetComm() const { return this->Mesh.GetCommunicator().Get(); }

  /// The matrix A; it refers to this object.
  Mat GetMatrix() const { return this->Matrix; }

  /// A new vector of \a components values for each vertex that this process owns.
  PetscVector MakeVector(int components) const;

  /// M^-1 residual with the diagonal of A, or its blocks.
  void ApplyJacobi(Vec residual, Vec result) const;

  /// b - A d as a vector.
  /// \param d right at the ghosts too
  void ComputeResidual(const Points& d, Vec residual) const;

  /// d += correction.
  void Add(Vec correction, Points& d) const;

private:
  static PetscErrorCode Multiply(Mat matrix, Vec x, Vec product);
  static PetscErrorCode GetDiagonal(Mat matrix, Vec diagonal);
  void Multiply(Vec x, Vec product);

  const LeastSquaresProblem& Problem;
  const DistributedMesh& Mesh;
  NormalOperator<double> A;
  JacobiPreconditioner<double> Jacobi;
  PackedPoints<double> X;
  PackedPoints<double> Product;
  PetscMatrix Matrix;
};

/// The values of a vector that are in this process; readable as long as this object lives.
class VectorValues
{
public:
  explicit VectorValues(Vec vector)
    : Vector(vector)
  {
    Check(VecGetArrayRead(vector, &this->Values));
  }
  ~VectorValues() { VecRestoreArrayRead(this->Vector, &this->Values); }
  VectorValues(const VectorValues&) = delete;
  void operator=(const VectorValues&) = delete;

  const double* Get() const { return this->Values; }

private:
  Vec Vector;
  const double* Values = nullptr;
};

/// The same, to be written.
class VectorRoom
{
public:
  explicit VectorRoom(Vec vector)
    : Vector(vector)
  {
    Check(VecGetArrayWrite(vector, &this->Values));
  }
  ~VectorRoom() { VecRestoreArrayWrite(this->Vector, &this->Values); }
  VectorRoom(const VectorRoom&) = delete;
  void operator=(const VectorRoom&) = delete;

  double* Get() const { return this->Values; }

private:
  Vec Vector;
  double* Values = nullptr;
};

/// Calls body() and turns exceptions into codes, for functions that PETSc calls.
template <typename Body>
PetscErrorCode ReturnCode(const Body& body)
{
  try
  {
    body();
    return 0;
  }
  catch (const std::exception& error)
  {
    return PetscError(PETSC_COMM_SELF, __LINE__, "ReturnCode", __FILE__, PETSC_ERR_LIB,
      PETSC_ERROR_INITIAL, "%s", error.what());
  }
}
}

#endif
