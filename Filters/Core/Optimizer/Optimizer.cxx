// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Optimizer/Optimizer.h"

#include "Core/Base/Rounding.h"
#include "Core/Base/Threading.h"
#include "Core/Mesh/NormalFilter.h"
#include "Core/Mesh/TriangleGeometry.h"
#include "Core/Optimizer/GuidedSmoothing.h"
#include "Core/Optimizer/ProblemSetup.h"
#include "Core/Optimizer/VolumePreservation.h"
#include "Core/Solvers/LinearSolver.h"

#include <algorithm>

namespace lmo
{
namespace
{
/// Mode::SMOOTH_GUIDED: the scale factor of the smoothing that the first normals come from, how
/// often normals are filtered and followed, and the factor of the filter's width after the first
/// time, when little noise is left.
constexpr double FirstScaleFactor = 0.75;
constexpr int GuidedRounds = 3;
constexpr double LaterWidth = 0.4;

/// Tolerance of the solutions that only lead to the next normals.
constexpr double RoughTolerance = 1e-3;

/// The smoothing that comes before the first filter of normals.
OptimizerOptions FirstSmoothing(const OptimizerOptions& options)
{
  OptimizerOptions smoothing;
  smoothing.mode = Mode::SMOOTH;
  smoothing.positionWeighting = PositionWeighting::CONSTANT;
  smoothing.scaleFactor = FirstScaleFactor;
  smoothing.boundaryCondition = options.boundaryCondition;
  smoothing.solver = options.solver;
  return smoothing;
}

template <typename Values>
void Reorder(const MeshOrder& order, std::optional<Values>& array)
{
  if (array)
  {
    array = ToNewOrder(order.vertices, std::move(*array));
  }
}

template <typename Values>
void Restore(const std::vector<Index>& oldNumbers, Values& values)
{
  if (values.rows() > 0)
  {
    values = ToOldOrder(oldNumbers, std::move(values));
  }
}

/// Moves vertices on lines to the closest points of these.
void Project(
  const std::optional<FeatureLines>& lines, const MeshQuantities& mesh, Points& positions)
{
  if (lines)
  {
    mesh.GetSubdomain().ProjectOntoLines(*lines, mesh.GetPoints(), positions);
    mesh.GetSubdomain().UpdateCopies(positions);
  }
}

/// Sets V' - V.
void SetDisplacements(const Points& V, const OptimizerOptions& options, OptimizerResult& result)
{
  result.displacements.resize(V.rows(), 3);
  ParallelFor(static_cast<Index>(V.rows()),
    [&](Index i)
    {
      Vector3 position = result.positions.row(i);
      if (options.roundToFloat)
      {
        position = RoundToFloat(position);
        result.positions.row(i) = position;
      }
      result.displacements.row(i) = position - V.row(i);
    });
}

/// S (2 I - S) V instead of the solution S V of smoothing with f = 0, where d = S V - V: the same
/// system on what was smoothed away.
void SmoothTwice(LeastSquaresProblem& problem, const Points& d)
{
  problem.laplacian.target = std::make_shared<const Points>(Apply(problem.laplacian.L, d));
  for (PolylineRow& row : problem.polylines.rows)
  {
    const Vector3 tangent = problem.motion.axes.row(row.vertex);
    const Vector3 laplacian = 0.5 * (d.row(row.previous) + d.row(row.next)) - d.row(row.vertex);
    row.target = laplacian.dot(tangent) * tangent;
  }
}

void Report(const Solution& solution, const SolverOptions& options, OptimizerResult& result)
{
  result.iterations += solution.iterations;
  result.relativeResidual = std::max(result.relativeResidual, solution.relativeResidual);
  result.isConverged = result.relativeResidual <= options.tolerance;
}

/// Sets what warnings are about.
void Review(const MeshQuantities& mesh, const OptimizerOptions& options, const VertexArrays& arrays,
  const std::optional<FeatureLines>& lines, OptimizerResult& result)
{
  result.freedom =
    CountFreedom(mesh, ChooseMotion(mesh.GetTopology(), options, arrays, lines), options, arrays);
  if (options.mode == Mode::SMOOTH || options.mode == Mode::SMOOTH_GUIDED)
  {
    result.volumeLoss = MeasureVolumeLoss(mesh, result.positions);
  }
}
}

Optimizer::Optimizer(Points V, Triangles triangles)
  : Solver([this](const LeastSquaresProblem& problem, SolverType type, const SolverOptions& options,
             ProgressMonitor& monitor)
      { return Solve(problem, type, options, monitor, this->Inverses); })
{
  if (IsScattered(triangles))
  {
    this->Order = BreadthFirstOrder(static_cast<Index>(V.rows()), triangles);
    V = ToNewOrder(this->Order.vertices, std::move(V));
    triangles = Renumber(this->Order, triangles);
  }
  this->Mesh = std::make_unique<MeshQuantities>(std::move(V), std::move(triangles));
}

Optimizer::Optimizer(
  Points V, Triangles triangles, std::shared_ptr<const Subdomain> subdomain, ProblemSolver solver)
  : Mesh(std::make_unique<MeshQuantities>(std::move(V), std::move(triangles), std::move(subdomain)))
  , Solver(std::move(solver))
{
}

OptimizerResult Optimizer::Run(
  const OptimizerOptions& options, const VertexArrays& arrays, ProgressMonitor& monitor)
{
  if (this->Order.IsEmpty())
  {
    return this->RunInOrder(options, arrays, monitor);
  }
  VertexArrays reordered = arrays;
  Reorder(this->Order, reordered.positionWeights);
  Reorder(this->Order, reordered.laplacianWeights);
  Reorder(this->Order, reordered.prescribedLaplacians);
  Reorder(this->Order, reordered.fixedPoints);
  Reorder(this->Order, reordered.featurePoints);
  if (reordered.regions)
  {
    reordered.regions = ToNewOrder(this->Order.triangles, std::move(*reordered.regions));
  }
  OptimizerResult result = this->RunInOrder(options, reordered, monitor);
  Restore(this->Order.vertices, result.positions);
  Restore(this->Order.vertices, result.displacements);
  Restore(this->Order.vertices, result.meanCurvatures);
  Restore(this->Order.vertices, result.positionWeights);
  Restore(this->Order.vertices, result.laplacianWeights);
  Restore(this->Order.vertices, result.normals);
  Restore(this->Order.vertices, result.featureClass);
  MeshQuality before = *result.comparison.before;
  for (MeshQuality* quality : { &before, &result.comparison.after })
  {
    Restore(this->Order.vertices, quality->vertices);
    Restore(this->Order.triangles, quality->triangles);
  }
  result.comparison.before = std::make_shared<const MeshQuality>(std::move(before));
  return result;
}

void Optimizer::SolveOnce(const OptimizerOptions& options, const VertexArrays& arrays,
  const std::optional<FeatureLines>& lines, ProgressMonitor& monitor, OptimizerResult& result)
{
  const MeshQuantities& mesh = *this->Mesh;
  LeastSquaresProblem problem = SetUpProblem(*this->Quantities, options, arrays, lines);
  monitor.Begin("Solving");
  Solution solution = this->Solver(problem, options.solverType, options.solver, monitor);
  Report(solution, options.solver, result);
  if (options.twicing && options.mode == Mode::SMOOTH)
  {
    SmoothTwice(problem, solution.displacement);
    solution = this->Solver(problem, options.solverType, options.solver, monitor);
    Report(solution, options.solver, result);
  }
  const Points& V = mesh.GetPoints();
  result.positions.resize(V.rows(), 3);
  ParallelFor(static_cast<Index>(V.rows()),
    [&](Index i) { result.positions.row(i) = V.row(i) + solution.displacement.row(i); });
  Project(lines, mesh, result.positions);
  if (options.preserveVolume && options.mode == Mode::SMOOTH)
  {
    RestoreVolumes(V, mesh.GetTriangles(), mesh.GetTopology(), mesh.GetComponents(), problem.motion,
      result.positions);
  }
  result.positionWeights = std::move(problem.position.weights);
  result.laplacianWeights = std::move(problem.laplacian.weights);
}

void Optimizer::FollowFilteredNormals(const OptimizerOptions& options, const VertexArrays& arrays,
  const std::optional<FeatureLines>& lines, ProgressMonitor& monitor, OptimizerResult& result)
{
  const MeshQuantities& mesh = *this->Mesh;
  const OptimizerOptions smoothing = FirstSmoothing(options);
  const double share = 1.0 / (GuidedRounds + 1); // of the time
  PartialMonitor first(monitor, 0, share);
  this->SolveOnce(smoothing, arrays, lines, first, result);

  const Points& V = mesh.GetPoints();
  const Triangles& T = mesh.GetTriangles();
  const MeshTopology& topology = mesh.GetTopology();
  const LeastSquaresProblem problem = SetUpProblem(*this->Quantities, smoothing, arrays, lines);
  const int iterations = options.guide.normalIterations / 2 + options.guide.normalIterations % 2;
  double width = options.guide.normalWidth;
  SolverOptions solver = options.solver;
  for (int round = 1; round <= GuidedRounds; ++round)
  {
    solver.tolerance = round < GuidedRounds ? std::max(RoughTolerance, options.solver.tolerance)
                                            : options.solver.tolerance;
    PartialMonitor filtering(monitor, round * share, (round + 0.3) * share);
    filtering.Begin("Filtering normals");
    const Points normals =
      FilterNormals(result.positions, T, topology, iterations, width, filtering);
    PartialMonitor following(monitor, (round + 0.3) * share, (round + 1) * share);
    following.Begin("Following normals");
    const Solution solution = FollowNormals(V, T, topology, normals, problem.laplacian.L,
      problem.motion, options.guide.detailWeight, result.positions - V, solver, following);
    result.relativeResidual = 0; // the last one counts
    Report(solution, solver, result);
    result.positions = V + solution.displacement;
    width = LaterWidth * options.guide.normalWidth;
  }
  Project(lines, mesh, result.positions);
  if (options.preserveVolume)
  {
    RestoreVolumes(V, T, topology, mesh.GetComponents(), problem.motion, result.positions);
  }
}

void Optimizer::StayWithinDeviation(const OptimizerOptions& options, const VertexArrays& arrays,
  const FeatureLines& lines, ProgressMonitor& monitor, OptimizerResult& result)
{
  const DisplacementConstraints motion =
    ChooseMotion(this->Mesh->GetTopology(), options, arrays, lines);
  monitor.Report(0);
  DeviationResult deviation =
    OptimizeWithinDeviation(*this->Quantities, options, lines, motion, monitor);
  result.positions = std::move(deviation.positions);
  result.positionWeights = std::move(deviation.positionWeights);
  result.laplacianWeights = std::move(deviation.laplacianWeights);
  result.iterations = deviation.iterations;
  result.relativeResidual = deviation.relativeResidual;
  result.deviation = deviation.report;
  result.isCancelled = deviation.isCancelled;
}

int Optimizer::GetNumberOfParts() const
{
  return this->Mesh->GetNumberOfParts() +
         (this->Quantities ? this->Quantities->GetNumberOfParts() : 0);
}

OptimizerResult Optimizer::RunInOrder(
  const OptimizerOptions& options, const VertexArrays& arrays, ProgressMonitor& monitor)
{
  monitor.Begin("Setting up the equations");
  const MeshQuantities& mesh = *this->Mesh;
  if (!this->Quantities || this->Quantities->IsRobust() != options.robustLaplacian)
  {
    this->Weights.reset();
    this->Quantities = std::make_unique<CotangentQuantities>(mesh, options.robustLaplacian);
  }
  this->Weights = this->Quantities->Prepare(
    UsedLaplacian(options), options.mode == Mode::OPTIMIZE_TRIANGLES, monitor);
  const std::optional<FeatureLines> lines = SlidingLines(mesh, options, arrays);
  OptimizerResult result;
  switch (options.mode)
  {
    case Mode::OPTIMIZE_WITHIN_DEVIATION:
      this->StayWithinDeviation(options, arrays, *lines, monitor, result);
      break;
    case Mode::SMOOTH_GUIDED:
      this->FollowFilteredNormals(options, arrays, lines, monitor, result);
      break;
    default:
      this->SolveOnce(options, arrays, lines, monitor, result);
  }
  if (!result.isCancelled)
  {
    monitor.Begin("Comparing the surfaces");
  }
  const Points& V = mesh.GetPoints();
  const Triangles& T = mesh.GetTriangles();
  SetDisplacements(V, options, result);
  result.meanCurvatures = this->Quantities->GetMeanCurvatures();
  if (lines && HasFeatures(options))
  {
    result.featureClass = Eigen::Map<const Eigen::Matrix<unsigned char, Eigen::Dynamic, 1>>(
      lines->pointClass.data(), static_cast<Eigen::Index>(lines->pointClass.size()))
                            .cast<double>();
  }
  if (options.computeNormals)
  {
    result.normals = VertexNormals(result.positions, T, mesh.GetTopology());
  }
  result.comparison = CompareSurfaces(
    V, result.positions, T, mesh.GetQuality(), mesh.GetBox(), mesh.IsClosed(), mesh.GetSubdomain());
  Review(mesh, options, arrays, lines, result);
  return result;
}
}
