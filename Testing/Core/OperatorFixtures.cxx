// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "OperatorFixtures.h"

#include "Core/Mesh/TriangleGeometry.h"

using namespace lmo;

OperatorFixtures::OperatorFixtures(const TestMesh& mesh)
  : topology(
      std::make_shared<MeshTopology>(BuildTopology(static_cast<Index>(mesh.V.rows()), mesh.T)))
  , oneRings(topology, &topology->oneRings)
{
  const CornerValues cotangents = Cotangents(mesh.V, mesh.T);
  const auto edgeWeights = CotangentEdgeWeights(*this->topology, mesh.T, cotangents);
  this->voronoiAreas = MixedVoronoiAreas(mesh.V, mesh.T, *this->topology, cotangents);
  this->uniform = UniformLaplacian(this->oneRings);
  this->cotangent = CotangentLaplacian(this->oneRings, edgeWeights);
  this->meanCurvature = MeanCurvatureLaplacian(this->oneRings, edgeWeights, this->voronoiAreas);
}

Eigen::MatrixXd DenseMatrix(const Laplacian& L)
{
  const Eigen::Index n = L.rowScale.size();
  Eigen::MatrixXd matrix(n, n);
  for (Eigen::Index j = 0; j < n; ++j)
  {
    Points unit = Points::Zero(n, 3);
    unit(j, 0) = 1;
    matrix.col(j) = Apply(L, unit).col(0);
  }
  return matrix;
}

Eigen::MatrixXd StiffnessMatrix(Laplacian L)
{
  L.rowScale.setOnes();
  return -DenseMatrix(L);
}

OptimizerResult Run(
  const TestMesh& mesh, const OptimizerOptions& options, const VertexArrays& arrays)
{
  ProgressMonitor monitor;
  return Optimize(mesh.V, mesh.T, options, arrays, monitor);
}

OptimizerOptions Options(Mode mode, LaplacianType laplacianType)
{
  OptimizerOptions options;
  options.mode = mode;
  options.laplacianType = laplacianType;
  options.solverType = SolverType::DIRECT;
  return options;
}
