// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Optimizer/Optimizer.h"

#include "Core/Base/Rounding.h"
#include "Core/Base/Threading.h"
#include "Core/Mesh/TriangleGeometry.h"
#include "Core/Optimizer/CurveSmoothing.h"
#include "Core/Optimizer/DeviationOptimizer.h"
#include "Core/Optimizer/GuidedSchedule.h"
#include "Core/Optimizer/ProblemSetup.h"
#include "Core/Optimizer/SingleSolve.h"
#include "Core/Solvers/LinearSolver.h"

namespace lmo
{
namespace
{
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

/// Adds to a mode's result what all modes return.
OptimizerResult Complete(const CotangentQuantities& quantities, const RunPlan& plan,
  ModeResult modeResult, ProgressMonitor& monitor)
{
  const MeshQuantities& mesh = quantities.GetMesh();
  const Points& V = mesh.GetPoints();
  const Triangles& T = mesh.GetTriangles();
  OptimizerResult result;
  static_cast<ModeResult&>(result) = std::move(modeResult);
  SetDisplacements(V, plan.options, result);
  result.meanCurvatures = quantities.GetMeanCurvatures();
  result.featureClass = plan.featureClass;
  if (plan.options.computeNormals)
  {
    result.normals = VertexNormals(result.positions, T, mesh.GetTopology());
  }
  result.comparison = CompareSurfaces(V, result.positions, T, mesh.GetTopology(), mesh.GetQuality(),
    mesh.GetBox(), mesh.IsClosed(), mesh.GetSubdomain());
  result.freedom = plan.freedom;
  if (plan.options.mode == Mode::SMOOTH || plan.options.mode == Mode::SMOOTH_GUIDED)
  {
    result.volumeLoss = MeasureVolumeLoss(mesh, result.positions);
  }
  if (plan.options.checkSelfIntersections && !result.intersections.isKnown)
  {
    result.intersections =
      CompareIntersections(V, result.positions, T, mesh.GetTopology(), monitor);
  }
  return result;
}
}

Optimizer::Optimizer(Points V, Triangles triangles, Polygons polygons)
  : Mesh(std::move(V), std::move(triangles), std::move(polygons))
  , Solver([this](const LeastSquaresProblem& problem, SolverType type, const SolverOptions& options,
             ProgressMonitor& monitor)
      { return Solve(problem, type, options, monitor, this->Inverses); })
{
}

Optimizer::Optimizer(
  Points V, Triangles triangles, std::shared_ptr<const Subdomain> subdomain, ProblemSolver solver)
  : Mesh(std::move(V), std::move(triangles), Polygons(), std::move(subdomain))
  , Solver(std::move(solver))
{
}

int Optimizer::GetNumberOfParts() const
{
  return this->Mesh.GetNumberOfParts() +
         (this->Quantities ? this->Quantities->GetNumberOfParts() : 0);
}

const CotangentQuantities& Optimizer::ChooseQuantities(bool isRobust)
{
  if (!this->Quantities || this->Quantities->IsRobust() != isRobust)
  {
    this->Weights.reset();
    this->Quantities = std::make_unique<CotangentQuantities>(this->Mesh, isRobust);
  }
  return *this->Quantities;
}

ModeResult Optimizer::OptimizeWithin(RunPlan& plan, ProgressMonitor& monitor)
{
  return OptimizeWithinDeviation(this->Mesh, plan, monitor);
}

OptimizerResult Optimizer::Run(
  const OptimizerOptions& options, const VertexArrays& arrays, ProgressMonitor& monitor)
{
  monitor.Begin("Setting up the equations");
  const CotangentQuantities& quantities = this->ChooseQuantities(options.robustLaplacian);
  RunPlan plan = MakePlan(quantities, options, arrays, monitor);
  this->Weights = plan.weights;
  plan.solve = this->Solver;
  SmoothCurves(this->Mesh, plan, monitor);
  ModeResult result;
  switch (options.mode)
  {
    case Mode::OPTIMIZE_WITHIN_DEVIATION:
      result = this->OptimizeWithin(plan, monitor);
      break;
    case Mode::SMOOTH_GUIDED:
      result = SmoothGuided(this->Mesh, plan, monitor);
      break;
    default:
      result = SolveOnce(this->Mesh, plan, monitor);
  }
  if (!result.isCancelled)
  {
    monitor.Begin("Comparing the surfaces");
  }
  return Complete(quantities, plan, std::move(result), monitor);
}
}
