// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "DistributedOptimizer.h"

#include "DistributedSubdomain.h"
#include "PetscSolver.h"

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

/// \throw InputError for what works in one process only.
void CheckOptions(const OptimizerOptions& options)
{
  struct Choice
  {
    bool isChosen;
    const char* name;
    const char* remedy;
  };
  const Choice choices[] = {
    { options.mode == Mode::OPTIMIZE_WITHIN_DEVIATION, "Mode OPTIMIZE_WITHIN_DEVIATION",
      "Choose OPTIMIZE_TRIANGLES" },
    { options.mode == Mode::SMOOTH_GUIDED, "Mode SMOOTH_GUIDED", "Choose SMOOTH" },
    { options.robustLaplacian, "RobustLaplacian", "Switch it off" },
    { options.featureConstraints, "FeatureConstraints", "Switch them off" },
    { options.preserveVolume, "PreserveVolume", "Switch it off" },
  };
  for (const auto& [isChosen, name, remedy] : choices)
  {
    if (isChosen)
    {
      throw InputError(
        std::string(name) + " works in one process only. " + remedy + ", or run in one process.");
    }
  }
}
}

DistributedOptimizer::DistributedOptimizer(
  const Communicator& comm, Piece piece, Triangles triangles)
  : Comm(comm)
  , PieceTriangles(std::move(triangles))
{
  if (comm.Sum(std::int64_t(piece.points.rows())) == 0)
  {
    this->Vertices = std::make_unique<Optimizer>(Points(0, 3), Triangles(0, 3));
    return;
  }
  const PetscSession session(comm.Get());
  this->Mesh = std::make_shared<DistributedMesh>(comm, std::move(piece));
  Triangles vertexTriangles = this->Mesh->TakeTriangles();
  const auto subdomain = std::make_shared<const DistributedSubdomain>(this->Mesh, vertexTriangles);
  this->Vertices =
    std::make_unique<Optimizer>(this->Mesh->TakePoints(), std::move(vertexTriangles), subdomain,
      [subdomain](const LeastSquaresProblem& problem, SolverType type, const SolverOptions& solver,
        ProgressMonitor& monitor)
      { return SolveDistributed(problem, type, solver, monitor, *subdomain); });
}

OptimizerResult DistributedOptimizer::Run(
  const OptimizerOptions& options, const VertexArrays& arrays, ProgressMonitor& monitor)
{
  CheckOptions(options);
  if (!this->Mesh)
  {
    return this->Vertices->Run(options, {}, monitor);
  }
  const PetscSession session(this->Comm.Get());
  OptimizerOptions common = options;
  common.computeNormals = this->Comm.Maximum(options.computeNormals) > 0;
  common.roundToFloat = this->Comm.Maximum(options.roundToFloat) > 0;
  VertexArrays vertexArrays;
  vertexArrays.positionWeights = FromPiece(*this->Mesh, arrays.positionWeights, 1);
  vertexArrays.laplacianWeights = FromPiece(*this->Mesh, arrays.laplacianWeights, 1);
  vertexArrays.prescribedLaplacians = FromPiece(*this->Mesh, arrays.prescribedLaplacians, 3);
  vertexArrays.fixedPoints = FromPiece(*this->Mesh, arrays.fixedPoints, 1);
  OptimizerResult result = this->ToPiece(this->Vertices->Run(common, vertexArrays, monitor));
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
  Points before = mesh.ToPiece(this->Vertices->GetMesh().GetPoints());
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
