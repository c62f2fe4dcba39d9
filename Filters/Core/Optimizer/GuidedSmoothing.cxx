// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Optimizer/GuidedSmoothing.h"

#include "Core/Base/Threading.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace lmo
{
namespace
{
constexpr double ShapeWeight = 1;       ///< beta
constexpr double FreeEigenvalue = 0.05; ///< of a direction that is free, per triangle at the vertex

/// The normal equations of the problem.
class GuidedEquations
{
public:
  GuidedEquations(const Points& V, const Triangles& triangles, const MeshTopology& topology,
    const Points& normals, const Laplacian& L, const DisplacementConstraints& motion,
    double detailWeight)
    : T(triangles)
    , CornersAt(topology.cornersAt)
    , Normals(normals)
    , L(L)
    , Motion(motion)
    , SquaredDetailWeight(detailWeight * detailWeight)
    , FreeDirections(topology.vertices)
    , Preconditioner(topology.vertices)
  {
    ParallelFor(topology.vertices, [this](Index i) { this->FreeDirections[i] = this->FreeAt(i); });
    ParallelFor(
      topology.vertices, [this](Index i) { this->Preconditioner[i] = this->InverseBlock(i); });
    this->RightHandSide = -this->Gradient(V, 0);
  }

  const Points& GetRightHandSide() const { return this->RightHandSide; }

  /// A d
  Points Apply(const Points& d) const { return this->Gradient(d, this->SquaredDetailWeight); }

  Points Precondition(const Points& residual) const
  {
    Points result(residual.rows(), 3);
    ParallelFor(static_cast<Index>(residual.rows()), [&](Index i)
      { result.row(i) = this->Motion.Project(i, residual.row(i) * this->Preconditioner[i]); });
    return result;
  }

private:
  Index Size(Index i) const { return this->CornersAt.Size(i); }

  template <typename Visit>
  void ForEachTriangleAt(Index i, const Visit& visit) const
  {
    for (const Index* c = this->CornersAt.Begin(i); c != this->CornersAt.End(i); ++c)
    {
      visit(*c / 3);
    }
  }

  /// T_i
  Matrix3 FreeAt(Index i) const
  {
    Matrix3 tensor = Matrix3::Zero();
    this->ForEachTriangleAt(
      i, [&](Index t) { tensor += this->Normals.row(t).transpose() * this->Normals.row(t); });
    const Eigen::SelfAdjointEigenSolver<Matrix3> eigen(tensor);
    Matrix3 free = Matrix3::Zero();
    for (int k = 0; k < 3; ++k)
    {
      if (eigen.eigenvalues()[k] < FreeEigenvalue * this->Size(i))
      {
        free += eigen.eigenvectors().col(k) * eigen.eigenvectors().col(k).transpose();
      }
    }
    return free;
  }

  /// Of the diagonal block of A, without what the neighbours' T_j add.
  Matrix3 InverseBlock(Index i) const
  {
    Matrix3 block = this->SquaredDetailWeight * Matrix3::Identity();
    this->ForEachTriangleAt(i,
      [&](Index t) { block += 2.0 / 3 * this->Normals.row(t).transpose() * this->Normals.row(t); });
    const double scale = this->L.rowScale[i] * WeightSum(this->L, i);
    block += ShapeWeight * ShapeWeight * scale * scale * this->FreeDirections[i];
    return block.inverse();
  }

  /// Half the gradient of the energy, as far as it is linear in v; within the motion allowed.
  Points Gradient(const Points& v, double squaredWeight) const
  {
    const auto size = static_cast<Index>(v.rows());
    Points rows(size, 3); // beta^2 G T L v with L = -G K
    ParallelFor(size,
      [&](Index i)
      {
        const double scale = ShapeWeight * this->L.rowScale[i];
        rows.row(i) = scale * scale * StiffnessRow(this->L, v, i) * this->FreeDirections[i];
      });
    Points gradient(size, 3);
    ParallelFor(size,
      [&](Index i)
      {
        Vector3 sum = StiffnessRow(this->L, rows, i) + squaredWeight * v.row(i);
        this->ForEachTriangleAt(i,
          [&](Index t)
          {
            const Vector3 centroid =
              (v.row(this->T(t, 0)) + v.row(this->T(t, 1)) + v.row(this->T(t, 2))) / 3;
            const Vector3 normal = this->Normals.row(t);
            sum += normal.dot(v.row(i) - centroid) * normal;
          });
        gradient.row(i) = this->Motion.Project(i, sum);
      });
    return gradient;
  }

  const Triangles& T;
  const AdjacencyLists& CornersAt;
  const Points& Normals;
  const Laplacian& L;
  const DisplacementConstraints& Motion;
  const double SquaredDetailWeight; ///< mu^2
  std::vector<Matrix3> FreeDirections;
  std::vector<Matrix3> Preconditioner;
  Points RightHandSide;
};

double Dot(const Points& a, const Points& b)
{
  return ParallelSum(static_cast<Index>(a.rows()), 0.0,
    [&](double& sum, Index i) { sum += a.row(i).dot(b.row(i)); });
}
}

Solution FollowNormals(const Points& V, const Triangles& triangles, const MeshTopology& topology,
  const Points& normals, const Laplacian& L, const DisplacementConstraints& motion,
  double detailWeight, Points guess, const SolverOptions& options, ProgressMonitor& monitor)
{
  const GuidedEquations A(V, triangles, topology, normals, L, motion, detailWeight);
  const Points& b = A.GetRightHandSide();
  Solution solution;
  solution.rightHandSideNorm = std::sqrt(Dot(b, b));
  const auto relative = [&](const Points& residual)
  {
    return solution.rightHandSideNorm > 0
             ? std::sqrt(Dot(residual, residual)) / solution.rightHandSideNorm
             : 0;
  };
  ParallelFor(topology.vertices, [&](Index i) { guess.row(i) = motion.Project(i, guess.row(i)); });
  solution.displacement = std::move(guess);
  Points residual = b - A.Apply(solution.displacement);
  solution.relativeResidual = relative(residual);
  Points direction = Points::Zero(V.rows(), 3);
  double rho = 1;
  while (solution.relativeResidual > options.tolerance &&
         solution.iterations < options.maximumIterations)
  {
    monitor.Report(
      std::clamp(std::log(solution.relativeResidual) / std::log(options.tolerance), 0.0, 1.0));
    const Points preconditioned = A.Precondition(residual);
    const double oldRho = rho;
    rho = Dot(residual, preconditioned);
    direction = preconditioned + (solution.iterations > 0 ? rho / oldRho : 0) * direction;
    const Points product = A.Apply(direction);
    const double curvature = Dot(direction, product);
    if (!(curvature > 0))
    {
      break;
    }
    const double alpha = rho / curvature;
    solution.displacement += alpha * direction;
    residual -= alpha * product;
    ++solution.iterations;
    solution.relativeResidual = relative(residual);
  }
  solution.relativeResidual = relative(b - A.Apply(solution.displacement));
  return solution;
}
}
