// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Optimizer/ProblemSetup.h"

#include "Core/Base/Threading.h"
#include "Core/Mesh/FeatureDetection.h"
#include "Core/Mesh/TriangleGeometry.h"
#include "Core/Operators/Curvature.h"
#include "Core/Optimizer/ChosenWeights.h"
#include "Core/Optimizer/CurveSmoothing.h"
#include "Core/Optimizer/DeviationProblem.h"
#include "Core/Optimizer/GuidedSchedule.h"

namespace lmo
{
namespace
{
/// L of section 4, without rows at vertices on lines and at a boundary that is not free.
Laplacian ChooseLaplacian(const CotangentQuantities& quantities, LaplacianType type,
  BoundaryCondition boundaryCondition, const std::optional<FeatureLines>& lines)
{
  const MeshQuantities& mesh = quantities.GetMesh();
  Laplacian L = quantities.MakeLaplacian(type);
  if (type == LaplacianType::MEAN_CURVATURE)
  {
    L.rowScale *= SquaredLengthScale(L, mesh.GetSubdomain());
  }
  const MeshTopology& topology = mesh.GetTopology();
  const bool hasBoundary =
    boundaryCondition != BoundaryCondition::FREE && !topology.boundaryEdges.ids.empty();
  if (hasBoundary || lines)
  {
    for (Index i = 0; i < topology.vertices; ++i)
    {
      const bool isOnLine = lines && lines->pointClass[i] != FeatureLines::SMOOTH;
      const bool isEmpty = isOnLine || (hasBoundary && topology.isBoundary[i]);
      L.rowScale[i] = isEmpty ? 0 : L.rowScale[i];
    }
  }
  return L;
}

/// Where features are detected: an earlier result has those of the surface that it was made from.
const MeshQuantities& FeatureSurface(const MeshQuantities& mesh, const VertexArrays& arrays)
{
  return arrays.reference && HaveSameTriangles(*arrays.reference, mesh) ? *arrays.reference : mesh;
}

/// Between labels, between tagged vertices, or detected.
AdjacencyLists FeatureEdges(
  const MeshQuantities& mesh, const OptimizerOptions& options, const VertexArrays& arrays)
{
  const MeshTopology& topology = mesh.GetTopology();
  if (arrays.labels)
  {
    return EdgesBetweenLabels(*arrays.labels, mesh.GetTriangles(), topology);
  }
  if (arrays.featurePoints)
  {
    return EdgesBetweenTagged(*arrays.featurePoints, topology);
  }
  if (options.detectFeatures)
  {
    const MeshQuantities& surface = FeatureSurface(mesh, arrays);
    const Vector quality = surface.GetPolygons().IsEmpty()
                             ? surface.GetQuality()->triangles
                             : RadiusRatios(surface.GetPoints(), surface.GetTriangles());
    return DetectFeatureEdges(surface.GetPoints(), mesh.GetTriangles(), topology, quality,
      options.featureAngle, mesh.GetSubdomain());
  }
  AdjacencyLists none;
  none.offsets.assign(topology.vertices + 1, 0);
  return none;
}

/// c = l^2 (f - kappa n) for mean curvature normals f (Eqn. 7) in the unit 1 / length, where l^2 is
/// the factor of L. Boundary vertices are compared to the kappa n of their inner neighbours, as
/// MeanCurvatureNormals() gives it, so that the mesh's own normals move nothing.
Points CurvatureNormalTarget(const CotangentQuantities& quantities, const Points& prescribed)
{
  const double squaredLength = SquaredLengthScale(
    quantities.MakeLaplacian(LaplacianType::MEAN_CURVATURE), quantities.GetMesh().GetSubdomain());
  return squaredLength * (prescribed - quantities.ComputeMeanCurvatureNormals());
}

/// c = f - L V, with f of section 4.
std::shared_ptr<const Points> ChooseTarget(const CotangentQuantities& quantities,
  const Laplacian& L, const OptimizerOptions& options, const VertexArrays& arrays)
{
  const MeshQuantities& mesh = quantities.GetMesh();
  if (options.mode == Mode::OPTIMIZE_TRIANGLES)
  {
    return quantities.GetDetailTarget();
  }
  if (options.mode != Mode::PRESCRIBED_LAPLACIANS)
  {
    return std::make_shared<const Points>(-Apply(L, mesh.GetPoints()));
  }
  const Points& prescribed = Require(mesh, arrays.prescribedLaplacians,
    "The mode needs a point array of prescribed Laplacians with 3 components, as the filter Mesh "
    "Laplacian makes");
  return std::make_shared<const Points>(options.laplacianType == LaplacianType::MEAN_CURVATURE
                                          ? CurvatureNormalTarget(quantities, prescribed)
                                          : prescribed - Apply(L, mesh.GetPoints()));
}

/// Rows that spread the vertices evenly along their line and leave its shape alone: the prescribed
/// Laplacian of the line is its own part across it.
std::vector<PolylineRow> SlidingRows(
  const FeatureLines& lines, const Points& V, const Vector& laplacianWeights)
{
  std::vector<PolylineRow> rows;
  ForEachLineVertex(lines,
    [&](Index i, Index previous, Index next)
    {
      const Vector3 laplacian = 0.5 * (V.row(previous) + V.row(next)) - V.row(i);
      const Vector3 tangent = lines.tangents.row(i);
      rows.push_back({ i, previous, next, laplacianWeights[i], -laplacian.dot(tangent) * tangent });
    });
  return rows;
}

/// The type of L.
LaplacianType UsedLaplacian(const OptimizerOptions& options)
{
  const bool isChosen = options.mode == Mode::SMOOTH || options.mode == Mode::PRESCRIBED_LAPLACIANS;
  return isChosen ? options.laplacianType : LaplacianType::UNIFORM;
}

/// True if the options ask for volumes that stay.
bool PreservesVolume(const OptimizerOptions& options)
{
  return options.preserveVolume &&
         (options.mode == Mode::SMOOTH || options.mode == Mode::SMOOTH_GUIDED);
}

/// True if the options ask for features.
bool HasFeatures(const OptimizerOptions& options)
{
  return options.mode == Mode::OPTIMIZE_WITHIN_DEVIATION ||
         (options.featureConstraints && options.mode <= Mode::SMOOTH) ||
         (options.featureSmoothing && options.mode == Mode::SMOOTH);
}

/// The lines along which vertices slide: the boundary and features, as far as the options ask for
/// them.
std::optional<FeatureLines> SlidingLines(const MeshQuantities& mesh,
  const OptimizerOptions& options, const VertexArrays& arrays, bool hasFeatures)
{
  const bool hasBoundary = (options.boundaryCondition == BoundaryCondition::SLIDING ||
                             options.boundaryCondition == BoundaryCondition::CURVE) &&
                           mesh.HasBoundary();
  if (!hasFeatures && !hasBoundary)
  {
    return std::nullopt;
  }
  const MeshTopology& topology = mesh.GetTopology();
  AdjacencyLists edges;
  edges.offsets.assign(topology.vertices + 1, 0);
  if (hasFeatures)
  {
    edges = FeatureEdges(mesh, options, arrays);
  }
  if (hasBoundary)
  {
    edges = MergeEdges(edges, topology.boundaryEdges);
  }
  FeatureLines lines = ClassifyLines(
    std::make_shared<AdjacencyLists>(std::move(edges)), FeatureSurface(mesh, arrays).GetPoints());
  SmoothStairs(mesh.GetPoints(), VerticesOnCurves(topology, options, lines), lines);
  return lines;
}

Vector ClassesOf(const FeatureLines& lines)
{
  using Classes = Eigen::Matrix<unsigned char, Eigen::Dynamic, 1>;
  return Eigen::Map<const Classes>(
    lines.pointClass.data(), static_cast<Eigen::Index>(lines.pointClass.size()))
    .cast<double>();
}

/// What each vertex may do.
DisplacementConstraints ChooseConstraints(const MeshTopology& topology,
  const OptimizerOptions& options, const VertexArrays& arrays,
  const std::optional<FeatureLines>& lines)
{
  DisplacementConstraints constraints;
  constraints.freedom = FixedVertices(topology, options.boundaryCondition, arrays);
  ParallelFor(topology.vertices,
    [&](Index i)
    {
      const bool isFixed =
        constraints.freedom[i] || (lines && lines->pointClass[i] == FeatureLines::CORNER);
      const bool slides = lines && lines->pointClass[i] == FeatureLines::EDGE;
      constraints.freedom[i] = isFixed  ? DisplacementConstraints::FIXED
                               : slides ? DisplacementConstraints::ALONG_LINE
                                        : DisplacementConstraints::FREE;
    });
  constraints.freeAxes = options.freeAxes;
  if (lines)
  {
    constraints.axes = lines->tangents;
    constraints.RestrictAxes();
  }
  return constraints;
}

/// Eqn. 11 for the options.
LeastSquaresProblem SetUpProblem(const CotangentQuantities& quantities, LaplacianType type,
  const OptimizerOptions& options, const VertexArrays& arrays,
  const std::optional<FeatureLines>& lines)
{
  const MeshQuantities& mesh = quantities.GetMesh();
  LeastSquaresProblem problem;
  problem.laplacian.L = ChooseLaplacian(quantities, type, options.boundaryCondition, lines);
  if (type == LaplacianType::COTANGENT)
  {
    problem.laplacian.clampedEdgeWeights = quantities.GetWeights()->GetClampedEdgeWeights();
  }
  problem.laplacian.weights = LaplacianWeights(quantities, options, arrays);
  problem.laplacian.target = ChooseTarget(quantities, problem.laplacian.L, options, arrays);
  problem.position.weights = PositionWeights(quantities, options, arrays);
  problem.constraints = ChooseConstraints(mesh.GetTopology(), options, arrays, lines);
  if (lines)
  {
    problem.polylines = PolylineTerm(
      SlidingRows(*lines, mesh.GetPoints(), problem.laplacian.weights), problem.Size());
  }
  if (options.tangentPlaneConstraints)
  {
    problem.tangentPlanes.normals = TangentPlaneNormals(quantities.ComputeMeanCurvatureNormals(),
      quantities.GetMeanCurvatures(),
      VertexNormals(mesh.GetPoints(), mesh.GetTriangles(), mesh.GetTopology()), mesh.GetTopology());
    problem.tangentPlanes.weight = options.tangentPlaneWeight;
  }
  return problem;
}
}

RunPlan MakePlan(const CotangentQuantities& quantities, const OptimizerOptions& options,
  const VertexArrays& arrays, ProgressMonitor& monitor)
{
  const MeshQuantities& mesh = quantities.GetMesh();
  const bool isGuided = options.mode == Mode::SMOOTH_GUIDED;
  const OptimizerOptions problemOptions = isGuided ? FirstSmoothing(options) : options;
  const LaplacianType type = UsedLaplacian(options);
  RunPlan plan;
  plan.options = options;
  plan.weights = quantities.Prepare(type, options.mode == Mode::OPTIMIZE_TRIANGLES, monitor);
  const bool hasFeatures = HasFeatures(options);
  plan.lines = SlidingLines(mesh, problemOptions, arrays, hasFeatures);
  if (hasFeatures)
  {
    plan.featureClass = ClassesOf(*plan.lines);
  }
  if (options.mode == Mode::OPTIMIZE_WITHIN_DEVIATION)
  {
    plan.problem = SetUpTangentialProblem(
      mesh, ChooseConstraints(mesh.GetTopology(), options, arrays, plan.lines));
    plan.problem.position.weights = quantities.GetCumulativeWeights();
    const bool isMesh = arrays.reference && HaveSameTriangles(*arrays.reference, mesh) &&
                        arrays.reference->GetPoints() == mesh.GetPoints();
    plan.reference = isMesh ? nullptr : arrays.reference;
    plan.earlier = arrays.earlier;
  }
  else
  {
    plan.problem = SetUpProblem(quantities, type, problemOptions, arrays, plan.lines);
  }
  if (PreservesVolume(options))
  {
    plan.regions = FindEnclosedRegions(
      mesh.GetTriangles(), mesh.GetComponents(), arrays.labels.value_or(TriangleLabels()));
  }
  plan.freedom = CountFreedom(mesh, plan.problem.constraints, options, arrays);
  return plan;
}
}
