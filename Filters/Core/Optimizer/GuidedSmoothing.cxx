// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Optimizer/GuidedSmoothing.h"

#include "Core/Base/Threading.h"
#include "Core/Solvers/LinearSolver.h"

#include <Eigen/Eigenvalues>

#include <utility>

namespace lmo
{
namespace
{
constexpr double FreeEigenvalue = 0.05; ///< of a direction that is free, per triangle at the vertex

/// T_i
Matrix3 FreeDirections(const AdjacencyLists& cornersAt, const Points& normals, Index i)
{
  Matrix3 tensor = Matrix3::Zero();
  for (const Index corner : cornersAt[i])
  {
    tensor += normals.row(corner / 3).transpose() * normals.row(corner / 3);
  }
  const Eigen::SelfAdjointEigenSolver<Matrix3> eigen(tensor);
  Matrix3 free = Matrix3::Zero();
  for (int k = 0; k < 3; ++k)
  {
    if (eigen.eigenvalues()[k] < FreeEigenvalue * cornersAt.Size(i))
    {
      free += eigen.eigenvectors().col(k) * eigen.eigenvectors().col(k).transpose();
    }
  }
  return free;
}
}

Solution FollowNormals(const Points& V, const Triangles& triangles, const MeshTopology& topology,
  Points normals, const Laplacian& L, const DisplacementConstraints& constraints,
  double detailWeight, Points guess, const SolverOptions& options, ProgressMonitor& monitor)
{
  const Index size = topology.vertices;
  LeastSquaresProblem problem;
  problem.constraints = constraints;
  problem.position.weights = Vector::Constant(size, detailWeight);
  problem.laplacian.L = L;
  problem.laplacian.weights = Vector::Ones(size);
  problem.laplacian.projectors.resize(size);
  auto target = std::make_shared<Points>(size, 3);
  ParallelFor(size,
    [&](Index i)
    {
      target->row(i) = -LaplacianRow(L, V, i);
      problem.laplacian.projectors[i] = FreeDirections(topology.cornersAt, normals, i);
      guess.row(i) = constraints.Project(i, guess.row(i));
    });
  problem.laplacian.target = std::move(target);
  problem.normalAlignment =
    NormalAlignmentTerm(V, triangles, topology.cornersAt, std::move(normals));
  return SolveByDiagonal(problem, options, monitor, std::move(guess));
}
}
