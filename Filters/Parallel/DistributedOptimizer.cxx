// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "DistributedOptimizer.h"

#include "DistributedDeviation.h"
#include "DistributedSubdomain.h"
#include "PetscSolver.h"

#include <algorithm>
#include <set>

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

/// All but labels, reference and earlier step, which need the whole surface. Another one
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
  result.featurePoints = FromPiece(mesh, featurePoints, 1);
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

ModeResult DistributedOptimizer::OptimizeWithin(RunPlan& plan, ProgressMonitor& monitor)
{
  const auto* subdomain =
    dynamic_cast<const DistributedSubdomain*>(&this->GetMesh().GetSubdomain());
  return subdomain ? OptimizeWithinDeviation(this->GetMesh(), *subdomain, plan, monitor)
                   : this->Optimizer::OptimizeWithin(plan, monitor);
}

std::unique_ptr<const DistributedPlaces> DistributedOptimizer::FindPlaces(
  const Points& positions) const
{
  return std::make_unique<const DistributedPlaces>(this->GetMesh(),
    dynamic_cast<const DistributedSubdomain&>(this->GetMesh().GetSubdomain()), positions);
}

Mask DistributedOptimizer::MarksOfPiece(const Mask& isMarked) const
{
  using Triple = std::array<double, 3>;
  const DistributedMesh& mesh = *this->Mesh;
  const Vector rows = mesh.GetRows();
  const auto tripleOf = [](const Triangles& triangles, Index t, const Vector& names)
  {
    Triple triple{ names[triangles(t, 0)], names[triangles(t, 1)], names[triangles(t, 2)] };
    std::sort(triple.begin(), triple.end());
    return triple;
  };
  std::vector<Triple> marked;
  const Triangles& T = this->GetMesh().GetTriangles();
  for (Index t = 0; t < static_cast<Index>(isMarked.size()); ++t)
  {
    if (isMarked[t] && this->GetMesh().GetSubdomain().OwnsTriangle(t))
    {
      marked.push_back(tripleOf(T, t, rows));
    }
  }
  marked = this->Comm.Join(marked);
  const std::set<Triple> all(marked.begin(), marked.end());
  const Vector pieceRows = mesh.ToPiece(rows);
  Mask ofPiece(this->PieceTriangles.rows(), 0);
  for (Index t = 0; t < static_cast<Index>(this->PieceTriangles.rows()) && !all.empty(); ++t)
  {
    ofPiece[t] = all.count(tripleOf(this->PieceTriangles, t, pieceRows)) > 0;
  }
  return ofPiece;
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
  if (result.featureClass)
  {
    result.featureClass = mesh.ToPiece(*result.featureClass);
  }
  if (result.intersections.isKnown)
  {
    result.intersections.isIntersecting = this->MarksOfPiece(result.intersections.isIntersecting);
  }
  result.comparison.before =
    PieceQuality(mesh, *result.comparison.before, before, this->PieceTriangles);
  result.comparison.after =
    *PieceQuality(mesh, result.comparison.after, result.positions, this->PieceTriangles);
  return result;
}
}
