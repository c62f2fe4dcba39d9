// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause

// Every term of the energy, alone and with all others: its forms agree with the definition.
#include "Checks.h"
#include "MeshMeasures.h"
#include "OperatorFixtures.h"

#include "Core/LeastSquares/NormalOperator.h"
#include "Core/Solvers/DirectSolver.h"
#include "Core/Solvers/LinearSolver.h"

#include <cmath>
#include <functional>

using namespace lmo;

namespace
{
/// A problem and its energy at given positions, from the definition.
struct Case
{
  std::string name;
  LeastSquaresProblem problem;
  std::function<double(const Points&)> energyAt;
};

/// A sphere and a triangle that names a vertex twice.
TestMesh MakeMesh()
{
  return WithTriangle(Irregular(Icosphere(1), 0.1), 0, 5, 5);
}

Points UnitRows(Random& random, Eigen::Index rows)
{
  Points x = random.Displacements(rows);
  x.rowwise().normalize();
  return x;
}

/// Different weights above 0.
Vector Weights(Random& random, Eigen::Index size)
{
  return random.Displacements(size).col(0).cwiseAbs().array() + 0.1;
}

Case Positions(const TestMesh& mesh, Random& random)
{
  const Eigen::Index n = mesh.V.rows();
  LeastSquaresProblem problem;
  problem.position.weights = Weights(random, n);
  problem.laplacian.L = OperatorFixtures(mesh).uniform;
  problem.laplacian.weights = Vector::Zero(n);
  problem.laplacian.target = std::make_shared<const Points>(Points::Zero(n, 3));
  problem.constraints.freedom.assign(n, DisplacementConstraints::FREE);
  const Vector weights = problem.position.weights;
  return { "positions", problem,
    [=](const Points& x) { return (weights.asDiagonal() * (x - mesh.V)).squaredNorm(); } };
}

/// |W_L T (L V' - f)|^2
std::function<double(const Points&)> AddLaplacians(
  const TestMesh& mesh, Random& random, const std::vector<Matrix3>& projectors, Case& all)
{
  LaplacianTerm& term = all.problem.laplacian;
  const Eigen::Index n = mesh.V.rows();
  const Points f = random.Displacements(n);
  term.L = OperatorFixtures(mesh).cotangent;
  term.weights = Weights(random, n);
  term.target = std::make_shared<const Points>(f - Apply(term.L, mesh.V));
  term.projectors = projectors;
  const Eigen::MatrixXd L = DenseMatrix(term.L);
  const Vector weights = term.weights;
  return [=](const Points& x)
  {
    Points rows = weights.asDiagonal() * (L * x - f);
    for (std::size_t i = 0; i < projectors.size(); ++i)
    {
      rows.row(i) = Vector3(rows.row(i) * projectors[i]);
    }
    return rows.squaredNorm();
  };
}

/// Planes, lines and points.
std::vector<Matrix3> Projectors(Random& random, Eigen::Index size)
{
  std::vector<Matrix3> projectors;
  for (Eigen::Index i = 0; i < size; ++i)
  {
    const Vector3 axis = UnitRows(random, 1).row(0);
    const Matrix3 line = axis.transpose() * axis;
    const Matrix3 choices[] = { line, Matrix3::Identity() - line, Matrix3::Zero() };
    projectors.push_back(choices[i % 3]);
  }
  return projectors;
}

std::function<double(const Points&)> AddTangentPlanes(
  const TestMesh& mesh, Random& random, Case& all)
{
  const Points normals = UnitRows(random, mesh.V.rows());
  all.problem.tangentPlanes = { normals, 1.5 };
  return [=](const Points& x)
  { return std::pow(1.5, 2) * (x - mesh.V).cwiseProduct(normals).rowwise().sum().squaredNorm(); };
}

/// Lines that meet in vertices 1, 2 and 6.
std::function<double(const Points&)> AddPolylines(const TestMesh& mesh, Random& random, Case& all)
{
  std::vector<PolylineRow> rows;
  const Index lines[][3] = { { 0, 1, 2 }, { 1, 3, 2 }, { 4, 6, 2 }, { 6, 1, 7 } };
  for (const auto& [previous, vertex, next] : lines)
  {
    const double weight = Weights(random, 1)[0];
    rows.push_back({ vertex, previous, next, weight, random.Displacements(1).row(0) });
  }
  all.problem.polylines = PolylineTerm(rows, static_cast<Index>(mesh.V.rows()));
  return [=](const Points& x)
  {
    const Points d = x - mesh.V;
    double energy = 0;
    for (const PolylineRow& row : rows)
    {
      const Vector3 laplacian = (d.row(row.previous) + d.row(row.next)) / 2 - d.row(row.vertex);
      energy += std::pow(row.weight, 2) * (laplacian - row.target).squaredNorm();
    }
    return energy;
  };
}

std::function<double(const Points&)> AddNormalAlignment(
  const TestMesh& mesh, Random& random, Case& all)
{
  const Points normals = UnitRows(random, mesh.T.rows());
  all.problem.normalAlignment =
    NormalAlignmentTerm(mesh.V, mesh.T, OperatorFixtures(mesh).topology->cornersAt, normals);
  return [=](const Points& x)
  {
    double energy = 0;
    for (Index t = 0; t + 1 < mesh.T.rows(); ++t) // the last one has no normal
    {
      const Vector3 centroid =
        (x.row(mesh.T(t, 0)) + x.row(mesh.T(t, 1)) + x.row(mesh.T(t, 2))) / 3;
      for (int k = 0; k < 3; ++k)
      {
        energy += std::pow(normals.row(t).dot(x.row(mesh.T(t, k)) - centroid), 2);
      }
    }
    return energy;
  };
}

using AddTerm = std::function<std::function<double(const Points&)>(Case&)>;

Case With(Case all, const std::string& name, const AddTerm& add)
{
  const auto others = all.energyAt;
  const auto term = add(all);
  all.name = name;
  all.energyAt = [=](const Points& x) { return others(x) + term(x); };
  return all;
}

/// Some vertices fixed, on lines and in planes.
void Constrain(Random& random, DisplacementConstraints& constraints)
{
  constraints.axes = UnitRows(random, static_cast<Eigen::Index>(constraints.freedom.size()));
  for (std::size_t i = 0; i < constraints.freedom.size(); ++i)
  {
    constraints.freedom[i] = static_cast<unsigned char>(i % 5 < 3 ? i % 5 : 3);
  }
}

std::vector<Case> AllCases(const TestMesh& mesh)
{
  Random random;
  const Eigen::Index n = mesh.V.rows();
  const std::vector<Matrix3> projectors = Projectors(random, n);
  const AddTerm laplacians = [&](Case& all) { return AddLaplacians(mesh, random, {}, all); };
  const AddTerm projected = [&](Case& all) { return AddLaplacians(mesh, random, projectors, all); };
  const AddTerm planes = [&](Case& all) { return AddTangentPlanes(mesh, random, all); };
  const AddTerm polylines = [&](Case& all) { return AddPolylines(mesh, random, all); };
  const AddTerm alignment = [&](Case& all) { return AddNormalAlignment(mesh, random, all); };
  const Case positions = Positions(mesh, random);
  std::vector<Case> cases{ positions, With(positions, "Laplacians", laplacians),
    With(positions, "projected Laplacians", projected), With(positions, "tangent planes", planes),
    With(positions, "polylines", polylines), With(positions, "normal alignment", alignment) };
  Case all = positions;
  for (const AddTerm& add : { projected, planes, polylines, alignment })
  {
    all = With(all, "all terms", add);
  }
  cases.push_back(all);
  for (const std::size_t k : { 1, 4, 6 })
  {
    cases.push_back(cases[k]);
    cases.back().name += " with constraints";
    Constrain(random, cases.back().problem.constraints);
  }
  return cases;
}

/// Random displacements within those allowed.
Points Allowed(const LeastSquaresProblem& problem, Points d)
{
  for (Index i = 0; i < problem.Size(); ++i)
  {
    d.row(i) = problem.constraints.Project(i, d.row(i));
  }
  return d;
}

double EnergyError(const TestMesh& mesh, const Case& all, const Points& d)
{
  const double reference = all.energyAt(mesh.V + d);
  return std::abs(Energy(all.problem, d) - reference) / reference;
}

/// Of the residual to -1/2 of the gradient; central differences of a square are exact.
double GradientError(const TestMesh& mesh, const Case& all, const Points& d)
{
  constexpr double step = 0.5;
  Points gradient(d.rows(), 3);
  for (Eigen::Index k = 0; k < d.size(); ++k)
  {
    Points x = mesh.V + d;
    x.data()[k] += step;
    const double after = all.energyAt(x);
    x.data()[k] -= 2 * step;
    gradient.data()[k] = (after - all.energyAt(x)) / (2 * step);
  }
  const Points expected = Allowed(all.problem, -0.5 * gradient);
  return MaximumDistance(Residual(all.problem, d), expected) / LargestMagnitude(expected);
}

/// A d from residuals.
Points Product(const LeastSquaresProblem& problem, const Points& d)
{
  return Residual(problem, {}) - Residual(problem, d);
}

template <typename Scalar>
double ProductError(const LeastSquaresProblem& problem, const Points& d)
{
  PackedPoints<Scalar> x = PackedPoints<Scalar>::Zero(4, d.rows());
  PackedPoints<Scalar> product(4, d.rows());
  x.template topRows<3>() = d.transpose().array().template cast<Scalar>();
  NormalOperator<Scalar>(problem).Multiply(x, product);
  const Points expected = Product(problem, d);
  const Points actual = product.template topRows<3>().matrix().transpose().template cast<double>();
  return MaximumDistance(actual, expected) / LargestMagnitude(expected);
}

double MatrixError(const LeastSquaresProblem& problem, const Points& d)
{
  const SparseMatrix A = NormalMatrix(problem);
  Points actual(d.rows(), 3);
  if (problem.IsCoupled())
  {
    Eigen::Map<Vector>(actual.data(), actual.size()) =
      A * Eigen::Map<const Vector>(d.data(), d.size());
  }
  else
  {
    actual = A * d;
  }
  const Points expected = Product(problem, d);
  return MaximumDistance(actual, expected) / LargestMagnitude(expected);
}

/// Of diagonal blocks to the products with displacements of single vertices.
double DiagonalError(const LeastSquaresProblem& problem)
{
  double error = 0;
  for (Index i = 0; i < problem.Size(); ++i)
  {
    const DiagonalBlock block = DiagonalAt(problem, i);
    for (int c = 0; c < 3; ++c)
    {
      Points d = Points::Zero(problem.Size(), 3);
      d.row(i) = problem.constraints.Project(i, Vector3::Unit(c));
      const Vector3 expected = Product(problem, d).row(i);
      const Vector3 row = block.isotropic * d.row(i) + d.row(i) * block.coupled;
      error = Larger((problem.constraints.Project(i, row) - expected).norm(), error);
    }
  }
  return error;
}

void CheckSolutions(Checks& c, const Case& all)
{
  ProgressMonitor monitor;
  SolverOptions options;
  options.tolerance = 1e-13;
  const Points direct = SolveDirectly(all.problem, monitor);
  const Solution iterative = SolveByDiagonal(all.problem, options, monitor);
  c.Error("conjugate gradients find the direct solution: " + all.name,
    MaximumDistance(iterative.displacement, direct), 1e-11);
  options.tolerance = 1e-9;
  c.Equal("the solution as a guess needs no iteration: " + all.name,
    SolveByDiagonal(all.problem, options, monitor, direct).iterations, 0);
}
}

int TestEnergyTerms(int, char*[])
{
  Checks c;
  const TestMesh mesh = MakeMesh();
  for (const Case& all : AllCases(mesh))
  {
    Random random;
    const LeastSquaresProblem& problem = all.problem;
    const Points d = Allowed(problem, random.Displacements(mesh.V.rows()));
    c.Error("the energy is that of the definition: " + all.name, EnergyError(mesh, all, d), 1e-13);
    c.Error(
      "the residual is -1/2 of the gradient: " + all.name, GradientError(mesh, all, d), 1e-12);
    c.Error("the product is what the residual loses: " + all.name, ProductError<double>(problem, d),
      1e-13);
    c.Error("in single precision, too: " + all.name, ProductError<float>(problem, d), 1e-6);
    c.Error("the formed matrix gives the product: " + all.name, MatrixError(problem, d), 1e-13);
    c.Error("the diagonal is that of the matrix: " + all.name, DiagonalError(problem), 1e-12);
    CheckSolutions(c, all);
  }
  return c.Result();
}
