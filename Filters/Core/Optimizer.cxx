// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Optimizer.h"

#include "Curvature.h"
#include "Features.h"
#include "Parallel.h"
#include "Quality.h"
#include "TriangleGeometry.h"
#include "Weights.h"

#include <cmath>

namespace lmo
{
namespace
{
/// What depends on the input mesh alone.
struct MeshAnalysis
{
  std::shared_ptr<const MeshTopology> topology;
  std::shared_ptr<const AdjacencyLists> oneRings;
  double diagonal = 0;
  Laplacian cotangent;
  Laplacian meanCurvature;
  Points meanCurvatureNormals;
  Vector meanCurvatures;
  CurvatureStatistics statistics;
};

MeshAnalysis Analyse(const Points& V, const Triangles& triangles)
{
  MeshAnalysis mesh;
  mesh.topology =
    std::make_shared<MeshTopology>(BuildTopology(static_cast<Index>(V.rows()), triangles));
  mesh.oneRings = { mesh.topology, &mesh.topology->oneRings };
  mesh.diagonal = BoundingBoxDiagonal(V, *mesh.topology);
  const CornerValues cotangents = Cotangents(V, triangles);
  const auto edgeWeights = CotangentEdgeWeights(*mesh.topology, triangles, cotangents);
  mesh.cotangent = CotangentLaplacian(mesh.oneRings, edgeWeights);
  mesh.meanCurvature = MeanCurvatureLaplacian(
    mesh.oneRings, edgeWeights, MixedVoronoiAreas(V, triangles, *mesh.topology, cotangents));
  mesh.meanCurvatureNormals = MeanCurvatureNormals(mesh.meanCurvature, V, *mesh.topology);
  mesh.meanCurvatures = MeanCurvatures(mesh.meanCurvatureNormals, mesh.diagonal, *mesh.topology);
  mesh.statistics = ComputeStatistics(mesh.meanCurvatures, mesh.topology->isUsed);
  return mesh;
}

const char* const MissingArray = " Choose one, or another scheme.";

/// Sections 5 and 6: the diagonal of W_p before W_t.
Vector SchemePositionWeights(
  const MeshAnalysis& mesh, const OptimizerOptions& options, const VertexArrays& arrays)
{
  const double s = options.scaleFactor;
  const auto userArray = [&]() -> const Vector&
  {
    if (!arrays.positionWeights)
    {
      throw InputError(
        std::string("The position weighting needs a point array, and none is chosen.") +
        MissingArray);
    }
    return *arrays.positionWeights;
  };
  switch (options.positionWeighting)
  {
    case PositionWeighting::LINEAR:
      return s * LinearWeights(mesh.meanCurvatures, mesh.statistics);
    case PositionWeighting::CDF:
      return s * CumulativeWeights(mesh.meanCurvatures, mesh.statistics);
    case PositionWeighting::ANCHORS:
      return s * AnchorWeights(userArray());
    case PositionWeighting::ARRAY:
      return userArray();
    default:
      return Vector::Constant(mesh.topology->vertices, s);
  }
}

/// Sections 5.3 and 6: the diagonal of W_L.
Vector SchemeLaplacianWeights(
  const MeshAnalysis& mesh, const OptimizerOptions& options, const VertexArrays& arrays)
{
  switch (options.laplacianWeighting)
  {
    case LaplacianWeighting::LINEAR_COMPLEMENT:
      return ComplementWeights(LinearWeights(mesh.meanCurvatures, mesh.statistics));
    case LaplacianWeighting::CDF_COMPLEMENT:
      return ComplementWeights(CumulativeWeights(mesh.meanCurvatures, mesh.statistics));
    case LaplacianWeighting::GAUSSIAN:
      return GaussianWeights(
        mesh.meanCurvatures, options.gaussianWidth * mesh.statistics.threshold);
    case LaplacianWeighting::ARRAY:
      if (!arrays.laplacianWeights)
      {
        throw InputError(
          std::string("The Laplacian weighting needs a point array, and none is chosen.") +
          MissingArray);
      }
      return *arrays.laplacianWeights;
    default:
      return Vector::Ones(mesh.topology->vertices);
  }
}

Mask FixedVertices(
  const MeshTopology& topology, BoundaryCondition condition, const VertexArrays& arrays)
{
  Mask isFixed(topology.vertices);
  for (Index i = 0; i < topology.vertices; ++i)
  {
    isFixed[i] = !topology.isUsed[i] ||
                 (topology.isBoundary[i] && condition == BoundaryCondition::FIXED) ||
                 (arrays.fixedPoints && (*arrays.fixedPoints)[i] != 0);
  }
  return isFixed;
}

Vector PositionWeights(const MeshAnalysis& mesh, const Points& V, const Triangles& triangles,
  const OptimizerOptions& options, const VertexArrays& arrays)
{
  Vector weights = SchemePositionWeights(mesh, options, arrays);
  if (options.modulateByTriangleQuality)
  {
    weights.array() *=
      MinimumAtVertices(RadiusRatios(V, triangles), triangles, mesh.topology->vertices)
        .array()
        .cwiseMax(0);
  }
  HoldLooseComponents(ConnectedComponents(*mesh.oneRings),
    FixedVertices(*mesh.topology, options.boundaryCondition, arrays), options.scaleFactor, weights);
  return weights;
}

/// L of section 4, its rows as the boundary condition wants them.
Laplacian ChooseLaplacian(const MeshAnalysis& mesh, const OptimizerOptions& options)
{
  Laplacian L = UniformLaplacian(mesh.oneRings);
  if (options.mode != Mode::OPTIMIZE_TRIANGLES)
  {
    if (options.laplacianType == LaplacianType::COTANGENT)
    {
      L = mesh.cotangent;
    }
    else if (options.laplacianType == LaplacianType::MEAN_CURVATURE)
    {
      L = mesh.meanCurvature;
      L.rowScale *= SquaredLengthScale(L);
    }
  }
  if (options.boundaryCondition != BoundaryCondition::FREE)
  {
    for (Index i = 0; i < mesh.topology->vertices; ++i)
    {
      L.rowScale[i] = mesh.topology->isBoundary[i] ? 0 : L.rowScale[i];
    }
  }
  return L;
}

/// delta_c of Eqn. 10, no longer than the longest edge at the vertex: nearly degenerate triangles
/// make it explode.
Points DetailLaplacians(const MeshAnalysis& mesh, const Points& V)
{
  Points details = Apply(mesh.cotangent, V);
  ParallelFor(mesh.topology->vertices,
    [&](Index i)
    {
      double longest = 0;
      for (const Index* j = mesh.oneRings->Begin(i); j != mesh.oneRings->End(i); ++j)
      {
        longest = std::max(longest, (V.row(*j) - V.row(i)).squaredNorm());
      }
      const double length = details.row(i).squaredNorm();
      if (length > longest)
      {
        details.row(i) *= std::sqrt(longest / length);
      }
    });
  return details;
}

/// f of section 4.
Points ChooseTarget(const MeshAnalysis& mesh, const Points& V, const OptimizerOptions& options,
  const VertexArrays& arrays)
{
  switch (options.mode)
  {
    case Mode::OPTIMIZE_TRIANGLES:
      return DetailLaplacians(mesh, V);
    case Mode::PRESCRIBED_LAPLACIANS:
      if (!arrays.prescribedLaplacians)
      {
        throw InputError("The mode needs a point array of prescribed Laplacians with 3 components, "
                         "and none is chosen. Choose one, or another mode.");
      }
      return *arrays.prescribedLaplacians;
    default:
      return Points::Zero(V.rows(), 3);
  }
}

MotionConstraints ChooseMotion(const MeshAnalysis& mesh, const OptimizerOptions& options,
  const VertexArrays& arrays, const FeatureLines* boundary)
{
  MotionConstraints motion;
  motion.freedom = FixedVertices(*mesh.topology, options.boundaryCondition, arrays);
  for (std::size_t i = 0; i < motion.freedom.size(); ++i)
  {
    const bool isFixed =
      motion.freedom[i] || (boundary && boundary->pointClass[i] == FeatureLines::CORNER);
    const bool slides = boundary && boundary->pointClass[i] == FeatureLines::EDGE;
    motion.freedom[i] = isFixed  ? MotionConstraints::FIXED
                        : slides ? MotionConstraints::ALONG_LINE
                                 : MotionConstraints::FREE;
  }
  if (boundary)
  {
    motion.tangents = boundary->tangents;
  }
  return motion;
}

std::optional<FeatureLines> SlidingBoundary(
  const MeshAnalysis& mesh, const Points& V, const OptimizerOptions& options)
{
  if (options.boundaryCondition != BoundaryCondition::SLIDING ||
      mesh.topology->boundaryEdges.ids.empty())
  {
    return std::nullopt;
  }
  return ClassifyLines({ mesh.topology, &mesh.topology->boundaryEdges }, V);
}
}

OptimizerResult Optimize(const Points& V, const Triangles& triangles,
  const OptimizerOptions& options, const VertexArrays& arrays, Monitor& monitor)
{
  const MeshAnalysis mesh = Analyse(V, triangles);
  monitor.Report(0);
  const std::optional<FeatureLines> boundary = SlidingBoundary(mesh, V, options);

  LeastSquaresProblem problem;
  problem.V = V;
  problem.positionWeights = PositionWeights(mesh, V, triangles, options, arrays);
  problem.motion = ChooseMotion(mesh, options, arrays, boundary ? &*boundary : nullptr);
  const Vector laplacianWeights = SchemeLaplacianWeights(mesh, options, arrays);
  problem.terms.push_back(
    { ChooseLaplacian(mesh, options), laplacianWeights, ChooseTarget(mesh, V, options, arrays) });
  if (boundary)
  {
    const Laplacian L = LineLaplacian(*boundary);
    problem.terms.push_back({ L, laplacianWeights, AcrossLines(*boundary, L, V) });
  }
  if (options.tangentPlaneConstraints)
  {
    problem.tangentPlaneNormals = TangentPlaneNormals(mesh.meanCurvatureNormals,
      mesh.meanCurvatures, VertexNormals(V, triangles, *mesh.topology), *mesh.topology);
    problem.tangentPlaneWeight = options.tangentPlaneWeight;
  }

  const Solution solution =
    Solve(NormalEquations(problem), options.solverType, options.solver, monitor);
  OptimizerResult result;
  result.positions = V + solution.displacement;
  if (boundary)
  {
    ProjectOntoLines(*boundary, V, result.positions);
  }
  result.meanCurvatures = mesh.meanCurvatures;
  result.positionWeights = problem.positionWeights;
  result.laplacianWeights = laplacianWeights;
  result.topology = mesh.topology;
  result.iterations = solution.iterations;
  result.relativeResidual = solution.relativeResidual;
  return result;
}
}
