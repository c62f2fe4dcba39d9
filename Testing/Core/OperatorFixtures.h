// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OperatorFixtures_h
#define OperatorFixtures_h

#include "MeshFixtures.h"

#include "Core/Optimizer/Optimizer.h"

/// The topology and the three Laplacians of a mesh.
struct OperatorFixtures
{
  explicit OperatorFixtures(const TestMesh& mesh);

  std::shared_ptr<const lmo::MeshTopology> topology;
  std::shared_ptr<const lmo::AdjacencyLists> oneRings;
  lmo::Vector voronoiAreas;
  lmo::Laplacian uniform;       ///< L_u
  lmo::Laplacian cotangent;     ///< L_c
  lmo::Laplacian meanCurvature; ///< L_ck
};

/// The matrix of an operator, column by column.
Eigen::MatrixXd DenseMatrix(const lmo::Laplacian& L);

/// K = E - S with L = -G K.
Eigen::MatrixXd StiffnessMatrix(lmo::Laplacian L);

/// Optimize() without a monitor.
lmo::OptimizerResult Run(
  const TestMesh& mesh, const lmo::OptimizerOptions& options, const lmo::VertexArrays& arrays = {});

/// Options for this mode and operator, solved directly; else the defaults.
lmo::OptimizerOptions Options(
  lmo::Mode mode, lmo::LaplacianType laplacianType = lmo::LaplacianType::UNIFORM);

#endif
