// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "DistributedDirectSolver.h"

#include "Core/Base/Exceptions.h"
#include "Core/Solvers/DirectSolver.h"

#include <algorithm>

namespace lmo
{
namespace
{
/// The problem with the constraints that owners set at the ghosts, for which this process does not
/// see all triangles.
LeastSquaresProblem WithConstraintsOfOwners(
  LeastSquaresProblem problem, const DistributedMesh& mesh)
{
  Vector freedom(problem.Size());
  std::copy(
    problem.constraints.freedom.begin(), problem.constraints.freedom.end(), freedom.begin());
  mesh.UpdateGhosts(freedom.data(), 1);
  std::transform(freedom.begin(), freedom.end(), problem.constraints.freedom.begin(),
    [](double value) { return static_cast<unsigned char>(value); });
  if (mesh.GetCommunicator().Maximum(problem.constraints.axes.rows() > 0) > 0)
  {
    mesh.UpdateGhosts(problem.constraints.axes.data(), 3);
  }
  return problem;
}

/// The rows of the formed matrix that belong to the vertices owned.
/// \param components rows for each vertex
PetscMatrix FormMatrix(const DistributedEquations& equations, int components)
{
  const DistributedMesh& mesh = equations.GetMesh();
  const SparseMatrix A = NormalMatrix(WithConstraintsOfOwners(equations.GetProblem(), mesh));
  const PetscInt size = components * PetscInt(mesh.GetNumberOfOwned());
  std::vector<PetscInt> offsets{ 0 };
  std::vector<PetscInt> columns;
  std::vector<double> values;
  for (PetscInt row = 0; row < size; ++row)
  {
    for (SparseMatrix::InnerIterator entry(A, row); entry; ++entry) // A is symmetric
    {
      const auto other = static_cast<Index>(entry.row());
      columns.push_back(
        static_cast<PetscInt>(components * mesh.GetRow(other / components) + other % components));
      values.push_back(entry.value());
    }
    offsets.push_back(static_cast<PetscInt>(columns.size()));
  }
  PetscMatrix matrix;
  Check(MatCreateMPIAIJWithArrays(equations.GetComm(), size, size, PETSC_DETERMINE, PETSC_DETERMINE,
    offsets.data(), columns.data(), values.data(), &matrix));
  Check(MatSetOption(matrix, MAT_SPD, PETSC_TRUE));
  return matrix;
}

PetscKrylov Factorise(const DistributedEquations& equations, Mat matrix)
{
  PetscKrylov krylov;
  Check(KSPCreate(equations.GetComm(), &krylov));
  Check(KSPSetOptionsPrefix(krylov, "lmo_direct_"));
  Check(KSPSetOperators(krylov, matrix, matrix));
  Check(KSPSetType(krylov, KSPPREONLY));
  PC pc = nullptr;
  Check(KSPGetPC(krylov, &pc));
  Check(PCSetType(pc, PCCHOLESKY));
  Check(PCFactorSetMatSolverType(pc, MATSOLVERMUMPS));
  Check(KSPSetFromOptions(krylov));
  Check(KSPSetUp(krylov));
  return krylov;
}

/// Solves for each component of x, y and z, or for all at once.
void SolveComponents(const PetscKrylov& krylov, int components, Vec residual, Vec correction,
  const PetscVector& right, const PetscVector& left)
{
  if (components == 3)
  {
    Check(KSPSolve(krylov, residual, correction));
    return;
  }
  Check(VecSetBlockSize(residual, 3));
  Check(VecSetBlockSize(correction, 3));
  for (int c = 0; c < 3; ++c)
  {
    Check(VecStrideGather(residual, c, right, INSERT_VALUES));
    Check(KSPSolve(krylov, right, left));
    Check(VecStrideScatter(left, c, correction, INSERT_VALUES));
  }
}
}

Points SolveDirectly(const DistributedEquations& equations)
{
  const bool isCoupled =
    equations.GetMesh().GetCommunicator().Maximum(equations.GetProblem().IsCoupled()) > 0;
  const int components = isCoupled ? 3 : 1;
  const PetscMatrix matrix = FormMatrix(equations, components);
  const PetscKrylov krylov = Factorise(equations, matrix);
  const PetscVector residual = equations.MakeVector(3);
  const PetscVector correction = equations.MakeVector(3);
  const PetscVector right = equations.MakeVector(1);
  const PetscVector left = equations.MakeVector(1);
  Points d = Points::Zero(equations.GetProblem().Size(), 3);
  equations.ComputeResidual(d, residual);
  const double rightHandSideNorm = Norm(residual);
  // The second step removes most of what the formation of L^T L cost in digits.
  for (int step = 0; step < 2; ++step)
  {
    SolveComponents(krylov, components, residual, correction, right, left);
    equations.Add(correction, d);
    equations.ComputeResidual(d, residual);
  }
  if (!(Norm(residual) < rightHandSideNorm))
  {
    throw SolverError("The linear system is singular: the weights leave some points undetermined. "
                      "Give them position weights, or use the iterative solver.");
  }
  return d;
}
}
