// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "MeshMeasures.h"
#include "OperatorFixtures.h"

#include "Core/Multigrid/ErrorAmplification.h"
#include "Core/Multigrid/SchurElimination.h"
#include "Core/Optimizer/ProblemSetup.h"
#include "Core/Solvers/BilaplacianPreconditioner.h"
#include "Core/Solvers/ConjugateGradient.h"
#include "Core/Solvers/DirectSolver.h"
#include "Core/Solvers/PreconditionerCache.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

using namespace lmo;

namespace
{
/// A smoothing problem with what its preconditioners are made of.
struct System
{
  LeastSquaresProblem problem;
  std::unique_ptr<NormalOperator<float>> A;
  std::shared_ptr<const ShiftedStiffness> matrix;

  System(const TestMesh& mesh, const OptimizerOptions& options)
  {
    const MeshQuantities quantities(mesh.V, mesh.T);
    ProgressMonitor monitor;
    this->problem = MakePlan(CotangentQuantities(quantities, false), options, {}, monitor).problem;
    this->A = std::make_unique<NormalOperator<float>>(this->problem);
    this->matrix = std::make_shared<const ShiftedStiffness>(
      this->problem, this->A->GetStiffness(), this->problem.laplacian.clampedEdgeWeights);
  }
};

OptimizerOptions Smoothing(LaplacianType type, double scaleFactor)
{
  OptimizerOptions options = Options(Mode::SMOOTH, type);
  options.scaleFactor = scaleFactor;
  return options;
}

/// Random values, 0 at vertices left out.
PackedPoints<float> RandomVector(const ShiftedStiffness& matrix, Random& random)
{
  PackedPoints<float> x = PackedPoints<float>::Zero(4, matrix.Size());
  for (Index i = 0; i < matrix.Size(); ++i)
  {
    for (int c = 0; c < 3 && !matrix.isLeftOut[i]; ++c)
    {
      x(c, i) = static_cast<float>(random());
    }
  }
  return x;
}

/// (K + R) x, entry by entry.
PackedPoints<float> Multiply(const ShiftedStiffness& matrix, const PackedPoints<float>& x)
{
  PackedPoints<float> product = PackedPoints<float>::Zero(4, matrix.Size());
  for (Index i = 0; i < matrix.Size(); ++i)
  {
    matrix.ForEachEntry(
      i, [&](Index j, double value) { product.col(i) += static_cast<float>(value) * x.col(j); });
  }
  return product;
}

template <typename Inverse>
std::shared_ptr<Inverse> MakeInverse(const System& system)
{
  PreconditionerCache inverses;
  ProgressMonitor monitor;
  if constexpr (std::is_same_v<Inverse, Multigrid>)
  {
    return inverses.GetMultigrid(system.matrix, monitor);
  }
  else
  {
    return inverses.GetFactorisation(system.matrix, monitor);
  }
}

/// |x - M (K + R) x| / |x| in the energy norm, M the approximate inverse.
template <typename Inverse>
double InverseError(const System& system)
{
  const ShiftedStiffness& matrix = *system.matrix;
  Random random;
  const PackedPoints<float> x = RandomVector(matrix, random);
  PackedPoints<float> result(4, matrix.Size());
  ProgressMonitor monitor;
  MakeInverse<Inverse>(system)->Apply(Multiply(matrix, x), result, monitor);
  const auto energy = [&](const PackedPoints<float>& y)
  { return std::sqrt((y * Multiply(matrix, y)).cast<double>().sum()); };
  return energy(x - result) / energy(x);
}

/// |x M y - y M^T x| / (|x| |M y|)
template <typename Inverse>
double Asymmetry(const System& system)
{
  const ShiftedStiffness& matrix = *system.matrix;
  Random random;
  const PackedPoints<float> x = RandomVector(matrix, random);
  const PackedPoints<float> y = RandomVector(matrix, random);
  PackedPoints<float> transposedMx(4, matrix.Size());
  PackedPoints<float> My(4, matrix.Size());
  const std::shared_ptr<Inverse> inverse = MakeInverse<Inverse>(system);
  ProgressMonitor monitor;
  inverse->ApplyTransposed(x, transposedMx, monitor);
  inverse->Apply(y, My, monitor);
  const double difference = ((x * My).cast<double>() - (y * transposedMx).cast<double>()).sum();
  return std::abs(difference) / (x.matrix().norm() * My.matrix().norm());
}

template <typename Preconditioner>
Solution Iterate(System& system, Preconditioner&& M, const SolverOptions& options)
{
  Solution solution;
  solution.rightHandSideNorm =
    ComputeResidual(system.problem, solution.displacement, [](Index, const Vector3&) {});
  ProgressMonitor monitor;
  ConjugateGradient<float, Preconditioner>(system.problem, *system.A, M, Subdomain())
    .Run(options, options.maximumIterations, monitor, solution);
  return solution;
}

template <typename Inverse>
Solution IterateSquared(System& system, const SolverOptions& options)
{
  return Iterate(system,
    BilaplacianPreconditioner<Inverse>(system.problem, system.matrix, MakeInverse<Inverse>(system)),
    options);
}

void CheckInverses(
  Checks& c, const std::string& name, const TestMesh& mesh, const OptimizerOptions& smoothing)
{
  const System system(mesh, smoothing);
  c.Error("the factorisation inverts K + R: " + name, InverseError<ShiftedCholesky>(system), 1e-3);
  c.Error("the factorisation is symmetric: " + name, Asymmetry<ShiftedCholesky>(system), 1e-5);
  c.Error("a multigrid cycle halves the error: " + name, InverseError<Multigrid>(system), 0.5);
  c.Error(
    "the transposed multigrid cycle is the transpose: " + name, Asymmetry<Multigrid>(system), 1e-5);
  c.Greater(
    "there are several levels: " + name, MakeInverse<Multigrid>(system)->GetNumberOfLevels(), 1);
}

/// Conjugate gradients with the squared preconditioners find the direct solution in few steps.
void CheckSolutions(Checks& c, const std::string& name, const OptimizerOptions& smoothing)
{
  const TestMesh mesh = Irregular(HalfSphere(4), 0.005);
  System system(mesh, smoothing);
  ProgressMonitor monitor;
  const Points direct = SolveDirectly(system.problem, monitor);
  SolverOptions options;
  options.tolerance = 1e-9;
  options.maximumIterations = 5000;
  const Solution multigrid = IterateSquared<Multigrid>(system, options);
  const Solution factorised = IterateSquared<ShiftedCholesky>(system, options);
  const Solution jacobi = Iterate(system, JacobiPreconditioner<float>(system.problem), options);
  c.Error("multigrid finds the direct solution: " + name,
    MaximumDistance(multigrid.displacement, direct), 1e-6);
  c.Error("the factorised K + R finds the direct solution: " + name,
    MaximumDistance(factorised.displacement, direct), 1e-6);
  // What is left to the diagonal, a boundary that slides, needs many iterations of its own.
  const bool isDiagonalSlow = smoothing.boundaryCondition == BoundaryCondition::SLIDING;
  const Index gain = isDiagonalSlow ? 2 : 10;
  c.AtMost("multigrid takes a fraction of Jacobi's iterations: " + name,
    gain * multigrid.iterations, jacobi.iterations);
  if (!isDiagonalSlow)
  {
    c.AtMost("the factorised K + R takes no more iterations than multigrid: " + name,
      factorised.iterations, multigrid.iterations);
  }
}

void CheckNeedles(Checks& c)
{
  System system(WithThinTriangles(Irregular(HalfSphere(5), 0.002), 100, 0.9999),
    Smoothing(LaplacianType::COTANGENT, 0.003));
  SolverOptions options;
  options.tolerance = 1e-9;
  options.maximumIterations = 1000;
  const Solution clamped = IterateSquared<Multigrid>(system, options);
  ProgressMonitor monitor;
  c.Error("clamped weights do not change the solution",
    MaximumDistance(clamped.displacement, SolveDirectly(system.problem, monitor)), 1e-6);
  const Solution clampedFactorised = IterateSquared<ShiftedCholesky>(system, options);
  system.matrix =
    std::make_shared<const ShiftedStiffness>(system.problem, system.A->GetStiffness());
  const Solution exact = IterateSquared<Multigrid>(system, options);
  const Solution factorised = IterateSquared<ShiftedCholesky>(system, options);
  c.AtMost("clamped weights save multigrid a third of the iterations", 3 * clamped.iterations,
    2 * exact.iterations);
  c.AtMost("exact weights save a factorisation a third of the iterations",
    3 * factorised.iterations, 2 * clampedFactorised.iterations);
}

/// Poles with 1100 neighbours.
void CheckHighValence(Checks& c)
{
  System system(Irregular(UvSphere(1100, 40), 1e-4), Smoothing(LaplacianType::UNIFORM, 0.01));
  const Mask& isLeftOut = system.matrix->isLeftOut;
  c.True("poles, and nothing else, are left out of K + R",
    isLeftOut.back() && std::count(isLeftOut.begin(), isLeftOut.end(), true) == 2);
  const Solution solution = IterateSquared<Multigrid>(system, SolverOptions());
  c.Error("multigrid reaches the tolerance in spite of poles", solution.relativeResidual, 1e-6);
  c.AtMost("poles cost few iterations", solution.iterations, 40);
}

TestMesh SphereWithThinTriangles()
{
  return WithThinTriangles(Irregular(Icosphere(5), 0.002), 40, 0.99);
}

/// |S y - P^T (K + R) P y| / |S y| for a random y.
double SchurComplementError(const ShiftedStiffness& matrix, const SchurElimination& elimination)
{
  const SparseRows S = elimination.SchurComplement(matrix);
  Random random;
  PackedPoints<float> y(4, S.rows());
  PackedPoints<float> restricted(4, S.rows());
  PackedPoints<float> x(4, matrix.Size());
  y = y.unaryExpr([&](float) { return static_cast<float>(random()); });
  elimination.Prolong(y, PackedPoints<float>::Zero(4, matrix.Size()), x);
  elimination.Restrict(Multiply(matrix, x), restricted);
  const Eigen::MatrixXf Sy = S * y.matrix().transpose();
  return (Sy - restricted.matrix().transpose()).norm() / Sy.norm();
}

void CheckElimination(Checks& c)
{
  const System areas(SphereWithThinTriangles(), Smoothing(LaplacianType::MEAN_CURVATURE, 0.01));
  const std::vector<Index> unknowns = AmplifyingUnknowns(*areas.matrix);
  c.True("areas that differ make some unknowns be eliminated", !unknowns.empty());
  c.Error("S is P^T (K + R) P",
    SchurComplementError(*areas.matrix, SchurElimination(*areas.matrix, unknowns)), 1e-4);
  for (const LaplacianType type : { LaplacianType::UNIFORM, LaplacianType::COTANGENT })
  {
    const System system(SphereWithThinTriangles(), Smoothing(type, 0.01));
    c.True("nothing is eliminated where rows have a sum of 1: L " +
             std::to_string(static_cast<int>(type)),
      AmplifyingUnknowns(*system.matrix).empty());
  }
}

/// Areas, and with them rows of L, differ by orders of magnitude.
void CheckThinTriangles(Checks& c)
{
  System system(SphereWithThinTriangles(), Smoothing(LaplacianType::MEAN_CURVATURE, 0.01));
  SolverOptions options;
  options.maximumIterations = 1000;
  const Solution multigrid = IterateSquared<Multigrid>(system, options);
  const Solution factorised = IterateSquared<ShiftedCholesky>(system, options);
  c.AtMost("multigrid and factorisation take few iterations on thin triangles",
    std::max(multigrid.iterations, factorised.iterations), 20);
  c.Error("multigrid reaches the tolerance", multigrid.relativeResidual, options.tolerance);
}

void CheckPrediction(Checks& c)
{
  c.Error("a steady fall is extrapolated", std::abs(PredictIterations({ 1, 0.1, 0.01 }, 1e-6) - 4),
    1e-12);
  c.Error("the second half counts",
    std::abs(PredictIterations({ 1, 1e-3, 1e-3, 1e-4, 1e-5 }, 1e-7) - 2), 1e-12);
  c.True("no fall never arrives", std::isinf(PredictIterations({ 1, 0.5, 0.5 }, 1e-6)));
  c.Equal("nothing is left at the tolerance", PredictIterations({ 1, 1e-7 }, 1e-6), 0);
}

void CheckInversesOfAll(Checks& c)
{
  CheckInverses(
    c, "L_u, closed", Irregular(Icosphere(4), 0.01), Smoothing(LaplacianType::UNIFORM, 0.01));
  CheckInverses(
    c, "L_u, large s", Irregular(Icosphere(5), 0.01), Smoothing(LaplacianType::UNIFORM, 0.3));
  CheckInverses(c, "L_u, fixed boundary", Irregular(HalfSphere(4), 0.01),
    Smoothing(LaplacianType::UNIFORM, 0.01));
  CheckInverses(
    c, "L_c, closed", Irregular(Icosphere(4), 0.01), Smoothing(LaplacianType::COTANGENT, 0.01));
  CheckInverses(c, "L_ck, thin triangles", SphereWithThinTriangles(),
    Smoothing(LaplacianType::MEAN_CURVATURE, 0.01));
}

void CheckOneLevel(Checks& c)
{
  OptimizerOptions stiff = Smoothing(LaplacianType::UNIFORM, 10);
  stiff.positionWeighting = PositionWeighting::CONSTANT;
  const System nearlyDiagonal(Irregular(Icosphere(4), 0.01), stiff);
  c.Equal("one level is enough for a matrix that is nearly diagonal",
    MakeInverse<Multigrid>(nearlyDiagonal)->GetNumberOfLevels(), 1);
  c.Error("that level halves the error", InverseError<Multigrid>(nearlyDiagonal), 0.5);
}

void CheckSolutionsOf(Checks& c, LaplacianType type)
{
  const std::string name = "L " + std::to_string(static_cast<int>(type));
  OptimizerOptions options = Smoothing(type, 0.003);
  CheckSolutions(c, name + ", fixed boundary", options);
  options.boundaryCondition = BoundaryCondition::FREE;
  CheckSolutions(c, name + ", free boundary", options);
  options.boundaryCondition = BoundaryCondition::SLIDING;
  CheckSolutions(c, name + ", sliding boundary", options);
  options.tangentPlaneConstraints = true;
  options.tangentPlaneWeight = 0.003;
  CheckSolutions(c, name + ", sliding boundary, tangent planes", options);
}

void CheckUniformSolutions(Checks& c)
{
  CheckSolutionsOf(c, LaplacianType::UNIFORM);
}

void CheckCotangentSolutions(Checks& c)
{
  CheckSolutionsOf(c, LaplacianType::COTANGENT);
}

void CheckMeanCurvatureSolutions(Checks& c)
{
  CheckSolutionsOf(c, LaplacianType::MEAN_CURVATURE);
}
}

int TestPreconditioners(int argc, char* argv[])
{
  Groups groups(argc, argv);
  groups.Run("Inverses", CheckInversesOfAll);
  groups.Run("OneLevel", CheckOneLevel);
  groups.Run("UniformSolutions", CheckUniformSolutions);
  groups.Run("CotangentSolutions", CheckCotangentSolutions);
  groups.Run("MeanCurvatureSolutions", CheckMeanCurvatureSolutions);
  groups.Run("Needles", CheckNeedles);
  groups.Run("HighValence", CheckHighValence);
  groups.Run("Elimination", CheckElimination);
  groups.Run("ThinTriangles", CheckThinTriangles);
  groups.Run("Prediction", CheckPrediction);
  return groups.Result();
}
