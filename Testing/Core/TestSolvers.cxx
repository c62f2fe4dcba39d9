// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "MeshMeasures.h"
#include "OperatorFixtures.h"

#include "Core/Base/ThreadPool.h"
#include "Core/Optimizer/ProblemSetup.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

using namespace lmo;

namespace
{
OptimizerOptions Iterative(OptimizerOptions options, double tolerance, Index iterations = 100000)
{
  options.solverType = SolverType::ITERATIVE;
  options.solver.tolerance = tolerance;
  options.solver.maximumIterations = iterations;
  return options;
}

/// Difference between the direct and the iterative solution.
double Disagreement(const TestMesh& mesh, const OptimizerOptions& options)
{
  return MaximumDistance(
    Run(mesh, options).positions, Run(mesh, Iterative(options, 1e-13)).positions);
}

/// Each operator and mode, with and without tangent planes, on a surface with this boundary.
void CheckAgreementAt(Checks& c, BoundaryCondition boundary, const std::string& name)
{
  const TestMesh mesh = Irregular(HalfSphere(3), 0.02);
  for (const bool tangentPlanes : { false, true })
  {
    const auto check = [&](const std::string& problem, OptimizerOptions options)
    {
      options.boundaryCondition = boundary;
      options.tangentPlaneConstraints = tangentPlanes;
      c.Error("direct and iterative solutions agree: " + problem + ", " + name +
                (tangentPlanes ? ", tangent planes" : ""),
        Disagreement(mesh, options), 1e-12);
    };
    check("triangles", Options(Mode::OPTIMIZE_TRIANGLES));
    check("smoothing with L_u", Options(Mode::SMOOTH, LaplacianType::UNIFORM));
    check("smoothing with L_c", Options(Mode::SMOOTH, LaplacianType::COTANGENT));
    check("smoothing with L_ck", Options(Mode::SMOOTH, LaplacianType::MEAN_CURVATURE));
  }
}

void CheckAgreement(Checks& c)
{
  CheckAgreementAt(c, BoundaryCondition::FIXED, "fixed boundary");
  CheckAgreementAt(c, BoundaryCondition::SLIDING, "sliding boundary");
  CheckAgreementAt(c, BoundaryCondition::FREE, "free boundary");
}

/// |b - A d| / |b| of smoothing a closed mesh with L_u, from dense matrices.
double TrueResidual(const TestMesh& mesh, const OptimizerResult& result)
{
  const Eigen::MatrixXd L = DenseMatrix(OperatorFixtures(mesh).uniform);
  const Eigen::MatrixXd LtL = L.transpose() * L;
  const Points d = result.positions - mesh.V;
  const Points b = -LtL * mesh.V;
  const Points Wp2d = result.positionWeights.array().square().matrix().asDiagonal() * d;
  return (b - LtL * d - Wp2d).norm() / b.norm();
}

/// How far a solution of smoothing with L_u is from that of the least-squares system without L^T L,
/// in terms of the largest displacement.
double ErrorOfSolution(const TestMesh& mesh, const OptimizerResult& result)
{
  const Eigen::MatrixXd L = DenseMatrix(OperatorFixtures(mesh).uniform);
  Eigen::MatrixXd system(2 * L.rows(), L.cols());
  system << L, Eigen::MatrixXd(result.positionWeights.asDiagonal());
  Eigen::MatrixXd target = Eigen::MatrixXd::Zero(system.rows(), 3);
  target.topRows(L.rows()) = -L * mesh.V;
  const Eigen::MatrixXd expected = system.householderQr().solve(target);
  return (result.positions - mesh.V - expected).cwiseAbs().maxCoeff() /
         expected.cwiseAbs().maxCoeff();
}

void CheckResiduals(Checks& c)
{
  const TestMesh mesh = Irregular(Icosphere(2), 0.05);
  OptimizerOptions smooth = Options(Mode::SMOOTH);
  for (const Index iterations : { 1, 3, 10 })
  {
    const OptimizerResult result = Run(mesh, Iterative(smooth, 1e-12, iterations));
    c.Error("the reported residual is the true one after iteration " + std::to_string(iterations),
      std::abs(result.relativeResidual / TrueResidual(mesh, result) - 1), 1e-9);
    c.Equal("the limit of iterations is kept", result.iterations, iterations);
  }
  for (const double tolerance : { 1e-2, 1e-6, 1e-12 })
  {
    const OptimizerResult result = Run(mesh, Iterative(smooth, tolerance));
    c.Error("the iterative solver reaches the tolerance", TrueResidual(mesh, result), tolerance);
    c.Error("the reported residual is within the tolerance", result.relativeResidual, tolerance);
  }
  const OptimizerResult direct = Run(mesh, smooth);
  c.Error("the direct solution has no residual", TrueResidual(mesh, direct), 1e-13);
  c.Equal("the direct solver does not iterate", direct.iterations, 0);
  OptimizerOptions strong = smooth;
  strong.scaleFactor = 1e-4;
  c.Error("the direct solution has the digits that the formation of L^T L costs",
    ErrorOfSolution(mesh, Run(mesh, strong)), 1e-12);

  OptimizerOptions automatic = Iterative(smooth, 1e-9, 1);
  automatic.solverType = SolverType::AUTOMATIC;
  c.Error("the automatic choice falls back to the direct solver",
    TrueResidual(mesh, Run(mesh, automatic)), 1e-9);
}

/// Remembers what is reported and stops after some reports.
class Recorder : public ProgressMonitor
{
public:
  explicit Recorder(std::size_t limit = SIZE_MAX)
    : Limit(limit)
  {
  }

  std::vector<double> Fractions;

protected:
  void ShowProgress(double fraction) override { this->Fractions.push_back(fraction); }
  bool IsCancelled() override { return this->Fractions.size() >= this->Limit; }

private:
  std::size_t Limit;
};

void CheckMonitor(Checks& c)
{
  const TestMesh mesh = Irregular(Icosphere(3), 0.02);
  OptimizerOptions options = Iterative(Options(Mode::SMOOTH), 1e-10);
  options.scaleFactor = 0.01;
  Recorder patient;
  const OptimizerResult result = Optimize(mesh.V, mesh.T, options, {}, patient);
  const std::vector<double>& fractions = patient.Fractions;
  c.True("every iteration is reported",
    fractions.size() >= static_cast<std::size_t>(result.iterations) && result.iterations > 20);
  c.True("progress is between 0 and 1",
    std::all_of(fractions.begin(), fractions.end(), [](double x) { return x >= 0 && x <= 1; }));
  c.True("progress never falls", std::is_sorted(fractions.begin(), fractions.end()));

  for (const std::size_t limit : { 1, 2, 7 })
  {
    Recorder impatient(limit);
    c.Throws<Cancelled>(
      "the monitor stops the iteration", [&] { Optimize(mesh.V, mesh.T, options, {}, impatient); });
    c.Equal("the iteration stops at once", impatient.Fractions.size(), limit);
  }
  options.solverType = SolverType::DIRECT;
  // The second question comes before the factorisation.
  Recorder impatient(2);
  c.Throws<Cancelled>("the monitor stops the direct solver",
    [&] { Optimize(mesh.V, mesh.T, options, {}, impatient); });
}

/// One Laplacian row and one position for all vertices.
void CheckSingularSystem(Checks& c)
{
  const TestMesh mesh = DoublePyramid(0);
  VertexArrays arrays;
  arrays.laplacianWeights = Vector::Unit(6, 4);
  arrays.positionWeights = Vector::Unit(6, 5);
  OptimizerOptions options = Options(Mode::SMOOTH);
  options.laplacianWeighting = LaplacianWeighting::ARRAY;
  options.positionWeighting = PositionWeighting::ARRAY;
  c.Throws<SolverError>(
    "a singular system is an error of the direct solver", [&] { Run(mesh, options, arrays); });
  c.True("the iterative solver finds a solution of a singular system",
    Run(mesh, Iterative(options, 1e-10), arrays).positions.allFinite());
}

/// The energy that the options give the positions.
double EnergyOf(const TestMesh& mesh, const OptimizerOptions& options, const VertexArrays& arrays,
  const Points& V)
{
  const MeshQuantities quantities(mesh.V, mesh.T);
  ProgressMonitor monitor;
  const LeastSquaresProblem problem =
    MakePlan(CotangentQuantities(quantities, false), options, arrays, monitor).problem;
  return Energy(problem, V - mesh.V);
}

/// A triangle held by weights whose squares vanish beside those of the Laplacians.
void CheckNearlySingularSystem(Checks& c)
{
  const TestMesh mesh = EquilateralTriangle();
  VertexArrays arrays;
  arrays.prescribedLaplacians = Random().Displacements(3);
  OptimizerOptions options = Options(Mode::PRESCRIBED_LAPLACIANS, LaplacianType::COTANGENT);
  options.boundaryCondition = BoundaryCondition::FREE;
  options.positionWeighting = PositionWeighting::CONSTANT;
  options.scaleFactor = 1e-12;
  const double before = EnergyOf(mesh, options, arrays, mesh.V);
  c.Throws<SolverError>("a direct solution that is worse than the input is an error",
    [&] { Run(mesh, options, arrays); });
  for (const SolverType solver : { SolverType::AUTOMATIC, SolverType::ITERATIVE })
  {
    options.solverType = solver;
    c.Less("the other solvers find a better one",
      EnergyOf(mesh, options, arrays, Run(mesh, options, arrays).positions), before);
  }
}

/// The centre of a fan: its row squared has more entries than memory.
void CheckDenseSystem(Checks& c)
{
  const Index valence = 5000;
  TestMesh fan{ Points::Zero(valence + 1, 3), Triangles(valence, 3) };
  for (Index k = 0; k < valence; ++k)
  {
    const double angle = 2 * std::acos(-1.0) * k / valence;
    fan.V.row(k) << std::cos(angle), std::sin(angle), 0.1 * std::sin(5 * angle);
    fan.T.row(k) << k, (k + 1) % valence, valence;
  }
  OptimizerOptions options = Options(Mode::SMOOTH);
  options.boundaryCondition = BoundaryCondition::FREE;
  c.Throws<SolverError>(
    "a vertex of valence 5000 is an error of the direct solver", [&] { Run(fan, options); });
  c.Error(
    "the iterative solver solves it", Run(fan, Iterative(options, 1e-6)).relativeResidual, 1e-6);
}

Points SolveOnThreads(
  const TestMesh& mesh, const OptimizerOptions& options, const char* backend, int threads)
{
  Points positions;
  vtkSMPTools::LocalScope(vtkSMPTools::Config(threads, backend, false),
    [&]
    {
      const ThreadPool team(threads);
      positions = Run(mesh, Iterative(options, 1e-6)).positions;
    });
  return positions;
}

void CheckThreadsOf(
  Checks& c, const std::string& name, const TestMesh& mesh, const OptimizerOptions& options)
{
  const Points sequential = SolveOnThreads(mesh, options, "Sequential", 1);
  for (const int threads : { 2, 3 })
  {
    c.Error("the solution does not depend on the number of threads: " + name,
      MaximumDistance(SolveOnThreads(mesh, options, "STDThread", threads), sequential), 0);
  }
}

void CheckThreads(Checks& c)
{
  const TestMesh mesh = Irregular(Icosphere(5), 0.005);
  const TestMesh thin = WithThinTriangles(Icosphere(5));
  OptimizerOptions options = Options(Mode::SMOOTH);
  CheckThreadsOf(c, "the diagonal", mesh, options);
  options.scaleFactor = 0.003;
  CheckThreadsOf(c, "multigrid", mesh, options);
  options.laplacianType = LaplacianType::MEAN_CURVATURE;
  CheckThreadsOf(c, "multigrid after an elimination", thin, options);
  options.laplacianType = LaplacianType::COTANGENT;
  CheckThreadsOf(c, "the factorised K + R", thin, options);
}

/// Triangles so thin that diagonals say little about the matrix.
void CheckHardSystem(Checks& c)
{
  const TestMesh mesh = WithThinTriangles(Icosphere(5));
  OptimizerOptions options = Options(Mode::SMOOTH, LaplacianType::MEAN_CURVATURE);
  options.scaleFactor = 0.01;
  const OptimizerResult result = Run(mesh, Iterative(options, 1e-8, 2000));
  c.Error("thin triangles do not keep the iterative solver from the tolerance",
    result.relativeResidual, 1e-8);
  c.Error("thin triangles: direct and iterative solutions agree",
    MaximumDistance(result.positions, Run(mesh, options).positions), 1e-4);
  options.laplacianType = LaplacianType::COTANGENT;
  options.scaleFactor = 0.003;
  const OptimizerResult factorised = Run(mesh, Iterative(options, 1e-6));
  c.True("what multigrid cannot cope with takes a factorisation few iterations",
    factorised.isConverged && factorised.iterations <= 100);
}
}

int TestSolvers(int argc, char* argv[])
{
  Groups groups(argc, argv);
  groups.Run("Agreement", CheckAgreement);
  groups.Run("Residuals", CheckResiduals);
  groups.Run("Monitor", CheckMonitor);
  groups.Run("SingularSystem", CheckSingularSystem);
  groups.Run("NearlySingularSystem", CheckNearlySingularSystem);
  groups.Run("DenseSystem", CheckDenseSystem);
  groups.Run("Threads", CheckThreads);
  groups.Run("HardSystem", CheckHardSystem);
  return groups.Result();
}
