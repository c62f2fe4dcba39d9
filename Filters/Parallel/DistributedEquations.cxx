// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "DistributedEquations.h"

#include "Core/Base/Threading.h"

namespace lmo
{
DistributedEquations::DistributedEquations(
  const LeastSquaresProblem& problem, const DistributedMesh& mesh)
  : Problem(problem)
  , Mesh(mesh)
  , A(problem)
  , Jacobi(problem)
  , X(4, problem.Size())
  , Product(4, problem.Size())
{
  const PetscInt size = 3 * PetscInt(mesh.GetNumberOfOwned());
  Check(MatCreateShell(
    this->GetComm(), size, size, PETSC_DETERMINE, PETSC_DETERMINE, this, &this->Matrix));
  PetscErrorCode (*multiply)(Mat, Vec, Vec) = &DistributedEquations::Multiply;
  Check(MatShellSetOperation(this->Matrix, MATOP_MULT, reinterpret_cast<void (*)(void)>(multiply)));
  Check(MatShellSetOperation(this->Matrix, MATOP_GET_DIAGONAL,
    reinterpret_cast<void (*)(void)>(&DistributedEquations::GetDiagonal)));
  Check(MatSetOption(this->Matrix, MAT_SPD, PETSC_TRUE));
}

PetscVector DistributedEquations::MakeVector(int components) const
{
  PetscVector vector;
  Check(VecCreateMPI(this->GetComm(), components * PetscInt(this->Mesh.GetNumberOfOwned()),
    PETSC_DETERMINE, &vector));
  return vector;
}

PetscErrorCode DistributedEquations::Multiply(Mat matrix, Vec x, Vec product)
{
  return ReturnCode(
    [&]
    {
      DistributedEquations* equations = nullptr;
      Check(MatShellGetContext(matrix, &equations));
      equations->Multiply(x, product);
    });
}

void DistributedEquations::Multiply(Vec x, Vec product)
{
  const Index owned = this->Mesh.GetNumberOfOwned();
  const VectorValues values(x);
  ParallelFor(owned,
    [packed = View(this->X), from = values.Get()](Index i) mutable
    {
      const double* row = from + 3 * std::ptrdiff_t(i);
      packed.col(i) << row[0], row[1], row[2], 0;
    });
  this->Mesh.UpdateGhosts(this->X.data(), 4);
  this->A.Multiply(this->X, this->Product);
  const VectorRoom room(product);
  ParallelFor(owned, [packed = View(std::as_const(this->Product)), to = room.Get()](Index i)
    { Eigen::Map<Eigen::Array3d>(to + 3 * std::ptrdiff_t(i)) = packed.col(i).head<3>(); });
}

PetscErrorCode DistributedEquations::GetDiagonal(Mat matrix, Vec diagonal)
{
  return ReturnCode(
    [&]
    {
      DistributedEquations* equations = nullptr;
      Check(MatShellGetContext(matrix, &equations));
      const VectorRoom room(diagonal);
      ParallelFor(equations->Mesh.GetNumberOfOwned(),
        [&](Index i)
        {
          const DiagonalBlock block = DiagonalAt(equations->Problem, i);
          Eigen::Map<Eigen::Array3d>(room.Get() + 3 * std::ptrdiff_t(i)) =
            block.isotropic + block.coupled.diagonal().array();
        });
    });
}

void DistributedEquations::ApplyJacobi(Vec residual, Vec result) const
{
  const VectorValues values(residual);
  const VectorRoom room(result);
  ParallelFor(this->Mesh.GetNumberOfOwned(),
    [M = this->Jacobi.GetRows(), from = values.Get(), to = room.Get()](Index i)
    {
      const std::ptrdiff_t first = 3 * std::ptrdiff_t(i);
      const PackedRow<double> row(from[first], from[first + 1], from[first + 2], 0);
      Eigen::Map<Eigen::Array3d>(to + first) = M(i, row).head<3>();
    });
}

void DistributedEquations::ComputeResidual(const Points& d, Vec residual) const
{
  const VectorRoom room(residual);
  lmo::ComputeResidual(this->Problem, d,
    [to = room.Get(), owned = this->Mesh.GetNumberOfOwned()](Index i, const Vector3& value)
    {
      if (i < owned)
      {
        Eigen::Map<Vector3>(to + 3 * std::ptrdiff_t(i)) = value;
      }
    });
}

void DistributedEquations::Add(Vec correction, Points& d) const
{
  const VectorValues values(correction);
  ParallelFor(this->Mesh.GetNumberOfOwned(),
    [&](Index i)
    {
      const Eigen::Map<const Vector3> step(values.Get() + 3 * std::ptrdiff_t(i));
      d.row(i) += this->Problem.constraints.Project(i, step);
    });
  this->Mesh.UpdateGhosts(d.data(), 3);
}
}
