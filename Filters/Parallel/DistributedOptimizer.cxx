// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "DistributedOptimizer.h"

#include "DistributedSubdomain.h"
#include "PetscSolver.h"

#include <stdexcept>

namespace lmo
{
namespace
{
/// An array for the vertices, in every process if one has it.
template <typename Values>
std::optional<Values> FromPiece(
  const DistributedMesh& mesh, const std::optional<Values>& array, Eigen::Index columns)
{
  if (mesh.GetCommunicator().Maximum(array.has_value()) == 0)
  {
    return std::nullopt;
  }
  return mesh.FromPiece(array ? *array : Values(0, columns));
}

/// All but features, reference and earlier step, whose modes need the whole surface. Another one
/// does not compile here before it has been thought of.
VertexArrays ArraysFromPiece(const DistributedMesh& mesh, const VertexArrays& arrays)
{
  const auto& [positionWeights, laplacianWeights, prescribedLaplacians, fixedPoints, featurePoints,
    labels, reference, earlier] = arrays;
  VertexArrays result;
  result.positionWeights = FromPiece(mesh, positionWeights, 1);
  result.laplacianWeights = FromPiece(mesh, laplacianWeights, 1);
  result.prescribedLaplacians = FromPiece(mesh, prescribedLaplacians, 3);
  result.fixedPoints = FromPiece(mesh, fixedPoints, 1);
  return result;
}

std::shared_ptr<const MeshQuality> PieceQuality(const DistributedMesh& mesh,
  const MeshQuality& vertices, const Points& V, const Triangles& triangles)
{
  auto quality = std::make_shared<MeshQuality>();
  quality->triangles = RadiusRatios(V, triangles);
  quality->vertices = mesh.ToPiece(vertices.vertices);
  quality->mean = vertices.mean;
  quality->minimum = vertices.minimum;
  return quality;
}
}

bool NeedsWholeSurface(const OptimizerOptions& options)
{
  return options.mode == Mode::OPTIMIZE_WITHIN_DEVIATION || options.mode == Mode::SMOOTH_GUIDED ||
         options.robustLaplacian || options.boundaryCondition == BoundaryCondition::CURVE ||
         options.featureSmoothing || options.featureConstraints || options.preserveVolume ||
         options.checkSelfIntersections;
}

DistributedOptimizer::Parts DistributedOptimizer::Distribute(const Communicator& comm, Piece piece)
{
  Parts parts;
  if (comm.Sum(std::int64_t(piece.points.rows())) == 0)
  {
    return parts;
  }
  const PetscSession session(comm.Get());
  parts.mesh = std::make_shared<DistributedMesh>(comm, std::move(piece));
  parts.points = parts.mesh->TakePoints();
  parts.triangles = parts.mesh->TakeTriangles();
  const auto subdomain = std::make_shared<const DistributedSubdomain>(parts.mesh, parts.triangles);
  parts.subdomain = subdomain;
  parts.solve = [subdomain](const LeastSquaresProblem& problem, SolverType type,
                  const SolverOptions& solver, ProgressMonitor& monitor)
  { return SolveDistributed(problem, type, solver, monitor, *subdomain); };
  return parts;
}

DistributedOptimizer::DistributedOptimizer(
  const Communicator& comm, Piece piece, Triangles triangles)
  : DistributedOptimizer(comm, Distribute(comm, std::move(piece)), std::move(triangles))
{
}

DistributedOptimizer::DistributedOptimizer(
  const Communicator& comm, Parts parts, Triangles triangles)
  : Optimizer(std::move(parts.points), std::move(parts.triangles), std::move(parts.subdomain),
      std::move(parts.solve))
  , Comm(comm)
  , PieceTriangles(std::move(triangles))
  , Mesh(std::move(parts.mesh))
{
}

OptimizerResult DistributedOptimizer::Run(
  const OptimizerOptions& options, const VertexArrays& arrays, ProgressMonitor& monitor)
{
  if (NeedsWholeSurface(options))
  {
    throw std::logic_error("DistributedOptimizer has a part of the surface only.");
  }
  if (!this->Mesh)
  {
    return this->Optimizer::Run(options, {}, monitor);
  }
  const PetscSession session(this->Comm.Get());
  OptimizerOptions common = options;
  common.computeNormals = this->Comm.Maximum(options.computeNormals) > 0;
  common.roundToFloat = this->Comm.Maximum(options.roundToFloat) > 0;
  OptimizerResult result =
    this->ToPiece(this->Optimizer::Run(common, ArraysFromPiece(*this->Mesh, arrays), monitor));
  result.volumeLoss = VolumeLossOfWhole(result.comparison);
  if (!options.computeNormals)
  {
    result.normals.resize(0, 3);
  }
  return result;
}

OptimizerResult DistributedOptimizer::ToPiece(OptimizerResult result) const
{
  const DistributedMesh& mesh = *this->Mesh;
  const bool hasNormals = this->Comm.Maximum(result.normals.rows() > 0) > 0;
  Points before = mesh.ToPiece(this->GetMesh().GetPoints());
  result.positions = mesh.ToPiece(result.positions);
  result.displacements = mesh.ToPiece(result.displacements);
  result.meanCurvatures = mesh.ToPiece(result.meanCurvatures);
  result.positionWeights = mesh.ToPiece(result.positionWeights);
  result.laplacianWeights = mesh.ToPiece(result.laplacianWeights);
  if (hasNormals)
  {
    result.normals = mesh.ToPiece(result.normals);
  }
  result.comparison.before =
    PieceQuality(mesh, *result.comparison.before, before, this->PieceTriangles);
  result.comparison.after =
    *PieceQuality(mesh, result.comparison.after, result.positions, this->PieceTriangles);
  return result;
}
}
