// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Optimizer.h"

#include "Parallel.h"
#include "ProblemSetup.h"
#include "TriangleGeometry.h"

namespace lmo
{
namespace
{
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

/// Sets V' and V' - V.
void Move(const Points& V, const Points& d, const OptimizerOptions& options,
  const std::optional<FeatureLines>& boundary, const Subdomain& subdomain, OptimizerResult& result)
{
  result.positions.resize(V.rows(), 3);
  const auto size = static_cast<Index>(V.rows());
  ParallelFor(size, [&](Index i) { result.positions.row(i) = V.row(i) + d.row(i); });
  if (boundary)
  {
    subdomain.ProjectOntoLines(*boundary, V, result.positions);
    subdomain.UpdateCopies(result.positions);
  }
  result.displacements.resize(V.rows(), 3);
  ParallelFor(size,
    [&](Index i)
    {
      Vector3 position = result.positions.row(i);
      if (options.roundToFloat)
      {
        position = position.cast<float>().cast<double>();
        result.positions.row(i) = position;
      }
      result.displacements.row(i) = position - V.row(i);
    });
}
}

Optimizer::Optimizer(Points V, Triangles triangles)
  : Solver([this](const LeastSquaresProblem& problem, SolverType type, const SolverOptions& options,
             Monitor& monitor) { return Solve(problem, type, options, monitor, this->Inverses); })
{
  if (IsScattered(triangles))
  {
    this->Order = BreadthFirstOrder(static_cast<Index>(V.rows()), triangles);
    V = ToNewOrder(this->Order.vertices, std::move(V));
    triangles = Renumber(this->Order, triangles);
  }
  this->Mesh = std::make_unique<MeshAnalysis>(std::move(V), std::move(triangles));
}

Optimizer::Optimizer(
  Points V, Triangles triangles, std::shared_ptr<const Subdomain> subdomain, ProblemSolver solver)
  : Mesh(std::make_unique<MeshAnalysis>(std::move(V), std::move(triangles), std::move(subdomain)))
  , Solver(std::move(solver))
{
}

OptimizerResult Optimizer::Run(
  const OptimizerOptions& options, const VertexArrays& arrays, Monitor& monitor)
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
  OptimizerResult result = this->RunInOrder(options, reordered, monitor);
  Restore(this->Order.vertices, result.positions);
  Restore(this->Order.vertices, result.displacements);
  Restore(this->Order.vertices, result.meanCurvatures);
  Restore(this->Order.vertices, result.positionWeights);
  Restore(this->Order.vertices, result.laplacianWeights);
  Restore(this->Order.vertices, result.normals);
  MeshQuality before = *result.comparison.before;
  for (MeshQuality* quality : { &before, &result.comparison.after })
  {
    Restore(this->Order.vertices, quality->vertices);
    Restore(this->Order.triangles, quality->triangles);
  }
  result.comparison.before = std::make_shared<const MeshQuality>(std::move(before));
  return result;
}

OptimizerResult Optimizer::RunInOrder(
  const OptimizerOptions& options, const VertexArrays& arrays, Monitor& monitor)
{
  monitor.Begin("Setting up the equations");
  MeshAnalysis& mesh = *this->Mesh;
  mesh.SetRobustLaplacian(options.robustLaplacian);
  const Points& V = mesh.GetPoints();
  const std::optional<FeatureLines> boundary = SlidingBoundary(mesh, options.boundaryCondition);
  LeastSquaresProblem problem = SetUpProblem(mesh, options, arrays, boundary);
  monitor.Begin("Solving");
  const Solution solution = this->Solver(problem, options.solverType, options.solver, monitor);

  monitor.Begin("Comparing the surfaces");
  OptimizerResult result;
  Move(V, solution.displacement, options, boundary, mesh.GetSubdomain(), result);
  result.meanCurvatures = mesh.GetMeanCurvatures();
  result.positionWeights = std::move(problem.positionWeights);
  result.laplacianWeights = std::move(problem.laplacianWeights);
  result.iterations = solution.iterations;
  result.relativeResidual = solution.relativeResidual;
  const Triangles& T = mesh.GetTriangles();
  if (options.computeNormals)
  {
    result.normals = VertexNormals(result.positions, T, mesh.GetTopology());
  }
  result.comparison = CompareSurfaces(
    V, result.positions, T, mesh.GetQuality(), mesh.GetBox(), mesh.IsClosed(), mesh.GetSubdomain());
  return result;
}
}
