// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "MeshMeasures.h"
#include "OperatorFixtures.h"

#include "Core/Multigrid/BasisEnergies.h"
#include "Core/Multigrid/BasisFunctions.h"
#include "Core/Optimizer/DeviationProblem.h"
#include "Core/Optimizer/ProblemSetup.h"
#include "Core/Solvers/DirectSolver.h"
#include "Core/Solvers/LinearSolver.h"
#include "Core/Solvers/MultilevelPreconditioner.h"

#include <algorithm>
#include <cmath>

using namespace lmo;

namespace
{
/// The first pass of OPTIMIZE_WITHIN_DEVIATION.
LeastSquaresProblem FirstPass(const TestMesh& mesh)
{
  const MeshQuantities quantities(mesh.V, mesh.T);
  ProgressMonitor monitor;
  RunPlan plan = MakePlan(CotangentQuantities(quantities, false),
    Options(Mode::OPTIMIZE_WITHIN_DEVIATION, LaplacianType::UNIFORM), {}, monitor);
  LeastSquaresProblem problem = std::move(plan.problem);
  SetTargets(quantities, *plan.lines, mesh.V, problem);
  const Vector cumulative = problem.position.weights;
  SetPositionWeights(quantities, cumulative, quantities.GetQuality()->triangles,
    Vector::Ones(cumulative.size()), problem);
  return problem;
}

/// The functions of the second scale on the vertices.
SparseRows SecondScale(const LeastSquaresProblem& problem)
{
  ProgressMonitor monitor;
  const std::vector<SparseRows> scales = BasisFunctions(*problem.laplacian.L.rings, monitor);
  return scales[0] * scales[1];
}

/// Half the sum over x, y and z of the energy, without its targets, of a function as a displacement
/// within the constraints.
double EnergyOf(LeastSquaresProblem problem, const Eigen::VectorXf& function)
{
  problem.laplacian.target = std::make_shared<Points>(Points::Zero(problem.Size(), 3));
  for (PolylineRow& row : problem.polylines.rows)
  {
    row.target.setZero();
  }
  double sum = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    Points d(problem.Size(), 3);
    for (Index i = 0; i < problem.Size(); ++i)
    {
      d.row(i) = problem.constraints.Project(i, double(function[i]) * Vector3::Unit(axis));
    }
    sum += Energy(problem, d);
  }
  return sum / 2;
}

/// Largest error of BasisEnergies(), relative to the energy.
double EnergyError(const LeastSquaresProblem& problem, const SparseRows& functions)
{
  const Eigen::ArrayXf energies = BasisEnergies(problem, functions);
  double error = 0;
  for (Index k = 0; k < static_cast<Index>(functions.cols()); k += 7)
  {
    const double energy = EnergyOf(problem, functions.col(k));
    error = Larger(error, std::abs(energies[k] / energy - 1));
  }
  return error;
}

/// Largest difference of a row's sum from 1.
double SumError(const SparseRows& functions)
{
  const Eigen::VectorXf sums = functions * Eigen::VectorXf::Ones(functions.cols());
  return (sums.array() - 1).abs().maxCoeff();
}

void CheckFunctions(Checks& c)
{
  const TestMesh mesh = Irregular(Icosphere(5), 0.01);
  const MeshTopology topology = BuildTopology(static_cast<Index>(mesh.V.rows()), mesh.T);
  ProgressMonitor monitor;
  const std::vector<SparseRows> scales = BasisFunctions(topology.oneRings, monitor);
  c.Greater("there are several scales", scales.size(), 2);
  for (const SparseRows& functions : scales)
  {
    c.Error("the functions sum to 1", SumError(functions), 1e-6);
    c.AtMost("the next scale has at most a quarter as many functions", 4 * functions.cols(),
      functions.rows());
    for (Index i = 0; i < static_cast<Index>(functions.rows()); ++i)
    {
      c.AtMost("at most four functions overlap", functions.row(i).nonZeros(), 4);
    }
  }
  c.AtMost("a few functions are left on the last scale", scales.back().cols(), 8);
}

void CheckEnergies(Checks& c)
{
  const LeastSquaresProblem sphere = FirstPass(Irregular(Icosphere(4), 0.01));
  c.Error("energies in tangent planes are those of the definition",
    EnergyError(sphere, SecondScale(sphere)), 1e-3);
  const LeastSquaresProblem cube = FirstPass(Irregular(Cube(4), 0.01));
  c.Greater("a cube has feature lines", cube.polylines.rows.size(), 10);
  c.Error("energies with feature lines are those of the definition",
    EnergyError(cube, SecondScale(cube)), 1e-3);
}

/// The passes' solution is that of a factorisation, in fewer iterations than with the diagonal.
void CheckSolution(Checks& c, const std::string& name, const TestMesh& mesh, Index gain)
{
  const LeastSquaresProblem problem = FirstPass(mesh);
  ProgressMonitor monitor;
  SolverOptions options;
  MultilevelBasis basis(problem, monitor);
  const Solution solution = SolveByLevels(problem, basis, options, monitor);
  const Points direct = SolveDirectly(problem, monitor);
  c.Error(
    "the residual is below the tolerance: " + name, solution.relativeResidual, options.tolerance);
  c.Error("the basis leads to the direct solution: " + name,
    MaximumDistance(solution.displacement, direct) / direct.cwiseAbs().maxCoeff(), 1e-3);
  c.AtMost("the basis saves iterations: " + name, gain * solution.iterations,
    SolveByDiagonal(problem, options, monitor).iterations);
}

void CheckSolutions(Checks& c)
{
  CheckSolution(c, "closed", Irregular(Icosphere(4), 0.01), 2);
  CheckSolution(c, "boundary", Irregular(HalfSphere(4), 0.005), 2);
  CheckSolution(c, "feature lines", Irregular(Cube(4), 0.005), 2);
  CheckSolution(c, "isolated point", WithIsolatedPoint(Irregular(Icosphere(4), 0.01)), 2);
}

/// M^-1 r at each vertex.
PackedPoints<float> Apply(
  const LeastSquaresProblem& problem, MultilevelPreconditioner& M, const PackedPoints<float>& r)
{
  ProgressMonitor monitor;
  M.Prepare(r, monitor);
  PackedPoints<float> result(4, problem.Size());
  for (Index i = 0; i < problem.Size(); ++i)
  {
    result.col(i) = M.GetRows()(i, r.col(i));
  }
  return result;
}

void CheckIsolatedPoints(Checks& c)
{
  LeastSquaresProblem problem;
  problem.laplacian.L = UniformLaplacian(
    std::make_shared<const AdjacencyLists>(AdjacencyLists{ std::vector<Index>(4, 0), {} }));
  problem.laplacian.weights = Vector::Zero(3);
  problem.position.weights = Vector::Constant(3, 2);
  problem.constraints.freedom.assign(3, DisplacementConstraints::IN_PLANE);
  problem.constraints.axes = Points::Zero(3, 3);
  problem.constraints.axes.col(2).setOnes();
  ProgressMonitor monitor;
  MultilevelBasis basis(problem, monitor);
  MultilevelPreconditioner M(problem, basis);
  PackedPoints<float> r = PackedPoints<float>::Zero(4, 3);
  r.row(0).setOnes();
  c.Error("without functions the diagonal is left",
    (Apply(problem, M, r) - 0.25f * r).abs().maxCoeff(), 1e-7);
}

/// Conjugate gradients need a symmetric positive preconditioner.
void CheckSymmetry(Checks& c)
{
  const LeastSquaresProblem problem = FirstPass(Irregular(HalfSphere(4), 0.01));
  ProgressMonitor monitor;
  MultilevelBasis basis(problem, monitor);
  MultilevelPreconditioner M(problem, basis);
  Random random;
  const auto allowed = [&]
  {
    PackedPoints<float> x(4, problem.Size());
    for (Index i = 0; i < problem.Size(); ++i)
    {
      const Vector3 any(random(), random(), random());
      x.col(i) = Pack<float>(problem.constraints.Project(i, any));
    }
    return x;
  };
  const PackedPoints<float> x = allowed();
  const PackedPoints<float> y = allowed();
  const PackedPoints<float> Mx = Apply(problem, M, x);
  const PackedPoints<float> My = Apply(problem, M, y);
  const double asymmetry = ((x * My).cast<double>() - (y * Mx).cast<double>()).sum();
  c.Error("the preconditioner is symmetric",
    std::abs(asymmetry) / (x.matrix().norm() * My.matrix().norm()), 1e-5);
  c.Greater("the preconditioner is positive", (x * Mx).cast<double>().sum(), 0);
}
}

int TestMultilevelBasis(int argc, char* argv[])
{
  Groups groups(argc, argv);
  groups.Run("Functions", CheckFunctions);
  groups.Run("Energies", CheckEnergies);
  groups.Run("Solutions", CheckSolutions);
  groups.Run("Symmetry", CheckSymmetry);
  groups.Run("IsolatedPoints", CheckIsolatedPoints);
  return groups.Result();
}
