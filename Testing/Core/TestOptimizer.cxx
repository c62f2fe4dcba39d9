// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "MeshMeasures.h"
#include "OperatorFixtures.h"

#include "Core/Mesh/TriangleQuality.h"
#include "Core/Operators/Weights.h"

#include <cmath>

using namespace lmo;

namespace
{
const Mode AllModes[] = { Mode::OPTIMIZE_TRIANGLES, Mode::SMOOTH };

OptimizerOptions WithBoundary(Mode mode, BoundaryCondition condition)
{
  OptimizerOptions options = Options(mode);
  options.boundaryCondition = condition;
  return options;
}

/// Largest displacement of the vertices that are tagged.
double Displacement(const TestMesh& mesh, const Points& moved, const std::vector<bool>& isTagged)
{
  double displacement = 0;
  for (Eigen::Index i = 0; i < moved.rows(); ++i)
  {
    displacement = Larger(displacement, isTagged[i] ? (moved.row(i) - mesh.V.row(i)).norm() : 0);
  }
  return displacement;
}

double MeanQuality(const Points& V, const Triangles& triangles)
{
  return MeasureQuality(V, triangles).mean;
}

void CheckHeldVertices(Checks& c)
{
  const TestMesh mesh = Irregular(Icosphere(2), 0.05);
  std::vector<bool> isTagged(mesh.V.rows(), false);
  isTagged[3] = isTagged[77] = true;
  VertexArrays arrays;
  arrays.fixedPoints = Vector::Unit(mesh.V.rows(), 3) - Vector::Unit(mesh.V.rows(), 77);
  VertexArrays heavy;
  heavy.positionWeights = Vector::Constant(mesh.V.rows(), 1e7);
  const TestMesh isolated = WithIsolatedPoint(mesh);
  for (const Mode mode : AllModes)
  {
    OptimizerOptions options = Options(mode);
    c.Error("fixed points do not move",
      Displacement(mesh, Run(mesh, options, arrays).positions, isTagged), 0);
    c.Error("isolated points do not move",
      (Run(isolated, options).positions.row(0) - isolated.V.row(0)).norm(), 0);
    c.Error("isolated points do not count",
      MaximumDistance(
        Run(isolated, options).positions.bottomRows(mesh.V.rows()), Run(mesh, options).positions),
      1e-12);
    options.positionWeighting = PositionWeighting::ARRAY;
    c.Error("with great weights nothing moves",
      MaximumDistance(Run(mesh, options, heavy).positions, mesh.V), 1e-13);
  }
}

/// Sum of the squared lengths of the boundary edges: least if they are equal.
double BoundaryEnergy(const TestMesh& mesh, const Points& V)
{
  double energy = 0;
  for (const auto& [i, j] : BoundaryEdges(mesh))
  {
    energy += (V.row(i) - V.row(j)).squaredNorm();
  }
  return energy;
}

double OffBoundary(const TestMesh& mesh, const Points& moved)
{
  const std::vector<bool> isBoundary = BoundaryVertices(mesh);
  double distance = 0;
  for (Eigen::Index i = 0; i < moved.rows(); ++i)
  {
    distance = Larger(distance, isBoundary[i] ? DistanceToBoundary(moved.row(i), mesh) : 0);
  }
  return distance;
}

void CheckBoundaries(Checks& c)
{
  const TestMesh grid = Grid(8, 0.3);
  const TestMesh half = Irregular(HalfSphere(3), 0.02);
  const std::vector<bool> isBoundary = BoundaryVertices(grid);
  std::vector<bool> isCorner(grid.V.rows(), false);
  isCorner[0] = isCorner[8] = isCorner[72] = isCorner[80] = true;
  for (const Mode mode : AllModes)
  {
    OptimizerOptions options = WithBoundary(mode, BoundaryCondition::FIXED);
    c.Error("a fixed boundary does not move",
      Displacement(grid, Run(grid, options).positions, isBoundary), 0);

    options = WithBoundary(mode, BoundaryCondition::SLIDING);
    options.scaleFactor = 0.1;
    const Points slid = Run(grid, options).positions;
    c.Error("sliding vertices stay on a straight boundary", OffBoundary(grid, slid), 1e-15);
    c.Error("sliding vertices stay on a curved boundary",
      OffBoundary(half, Run(half, options).positions), 1e-15);
    c.Error("corners of a sliding boundary do not move", Displacement(grid, slid, isCorner), 0);
    c.Error("sliding vertices spread evenly, to edges of length 1",
      BoundaryEnergy(grid, slid) / 32 - 1, 0.1 * (BoundaryEnergy(grid, grid.V) / 32 - 1));

    options = WithBoundary(mode, BoundaryCondition::FREE);
    c.Greater(
      "a free boundary moves", Displacement(grid, Run(grid, options).positions, isCorner), 0.01);
  }
}

/// Displacement of a mesh whose own Laplacians are prescribed.
double DisplacementWithOwnLaplacians(const TestMesh& mesh, LaplacianType type)
{
  const OperatorFixtures operators(mesh);
  Laplacian L = operators.uniform;
  if (type == LaplacianType::COTANGENT)
  {
    L = operators.cotangent;
  }
  if (type == LaplacianType::MEAN_CURVATURE)
  {
    L = operators.meanCurvature;
  }
  VertexArrays arrays;
  arrays.prescribedLaplacians = Apply(L, mesh.V);
  return MaximumDistance(
    Run(mesh, Options(Mode::PRESCRIBED_LAPLACIANS, type), arrays).positions, mesh.V);
}

void CheckFixedPointsOfTheEquations(Checks& c)
{
  const TestMesh mesh = Irregular(Icosphere(2), 0.05);
  c.Error("the mesh's own L_u V keeps it",
    DisplacementWithOwnLaplacians(mesh, LaplacianType::UNIFORM), 1e-14);
  c.Error("the mesh's own L_c V keeps it",
    DisplacementWithOwnLaplacians(mesh, LaplacianType::COTANGENT), 1e-14);
  c.Error("the mesh's own L_ck V keeps it",
    DisplacementWithOwnLaplacians(mesh, LaplacianType::MEAN_CURVATURE), 1e-14);
  for (const double unit : { 1e-3, 100. })
  {
    c.Error("the mesh's own L_ck V keeps it in another unit",
      DisplacementWithOwnLaplacians(Transformed(mesh, unit), LaplacianType::MEAN_CURVATURE),
      1e-13 * unit);
  }

  const TestMesh grid = Grid(8, 0.3);
  for (const LaplacianType type : { LaplacianType::COTANGENT, LaplacianType::MEAN_CURVATURE })
  {
    c.Error("smoothing with L_c or L_ck keeps a plane",
      MaximumDistance(Run(grid, Options(Mode::SMOOTH, type)).positions, grid.V), 1e-12);
  }
  OptimizerOptions strong = Options(Mode::SMOOTH);
  strong.scaleFactor = 0.1;
  const Points smooth = Run(grid, strong).positions;
  c.Error("smoothing with L_u stays within a plane", LargestMagnitude(smooth.col(2)), 0);
  c.Greater("smoothing with L_u improves the triangles of a plane", MeanQuality(smooth, grid.T),
    MeanQuality(grid.V, grid.T) + 0.05);
}

/// Root mean square distance from the unit sphere.
double Noise(const Points& V)
{
  return std::sqrt((V.rowwise().norm().array() - 1).square().mean());
}

void CheckEffects(Checks& c)
{
  const TestMesh noisy = Irregular(Icosphere(3), 0.03);
  c.True("optimisation improves the triangles of a sphere",
    MeanQuality(Run(noisy, Options(Mode::OPTIMIZE_TRIANGLES)).positions, noisy.T) >
      MeanQuality(noisy.V, noisy.T) + 0.03);
  for (const LaplacianType type :
    { LaplacianType::UNIFORM, LaplacianType::COTANGENT, LaplacianType::MEAN_CURVATURE })
  {
    c.Less("smoothing removes noise from a sphere",
      Noise(Run(noisy, Options(Mode::SMOOTH, type)).positions), 0.7 * Noise(noisy.V));
  }

  OptimizerOptions planes = Options(Mode::SMOOTH);
  planes.tangentPlaneConstraints = true;
  planes.tangentPlaneWeight = 1e6;
  const Points d = Run(noisy, planes).positions - noisy.V;
  const Points n = Apply(OperatorFixtures(noisy).meanCurvature, noisy.V).rowwise().normalized();
  c.Greater(
    "tangent planes leave room for a displacement", MaximumDistance(d, Points::Zero(642, 3)), 0.01);
  c.Error("strong tangent planes stop a displacement along the normal",
    LargestMagnitude((d.array() * n.array()).rowwise().sum()), 1e-10);
}

void CheckPositionWeights(Checks& c)
{
  const TestMesh mesh = Irregular(Icosphere(2), 0.05);
  OptimizerOptions options = Options(Mode::SMOOTH);
  options.scaleFactor = 3;
  const auto check = [&](const std::string& name, PositionWeighting scheme, const auto& weights)
  {
    options.positionWeighting = scheme;
    const OptimizerResult result = Run(mesh, options);
    const CurvatureStatistics statistics = ComputeStatistics(result.meanCurvatures, Mask(162, 1));
    c.Error("W_p is s times the weights: " + name,
      LargestMagnitude(result.positionWeights - 3 * weights(result.meanCurvatures, statistics)),
      1e-15);
  };
  check("constant", PositionWeighting::CONSTANT,
    [](const Vector& kappa, const CurvatureStatistics&) { return Vector::Ones(kappa.size()); });
  check("linear", PositionWeighting::LINEAR, LinearWeights);
  check("cdf", PositionWeighting::CDF,
    [](const Vector& kappa, const CurvatureStatistics&)
    { return CumulativeWeights(kappa, Mask(162, 1)); });

  const Vector plain = Run(mesh, options).positionWeights;
  options.modulateByTriangleQuality = true;
  const Vector Wt = MinimumAtVertices(RadiusRatios(mesh.V, mesh.T), mesh.T, 162);
  c.Error("W_t multiplies W_p",
    LargestMagnitude(Run(mesh, options).positionWeights - plain.cwiseProduct(Wt)), 1e-15);

  VertexArrays arrays;
  arrays.positionWeights = Vector::Unit(46, 0);
  options = Options(Mode::SMOOTH);
  options.positionWeighting = PositionWeighting::ANCHORS;
  options.scaleFactor = 5;
  Vector expected = 5 * Vector::Unit(46, 0);
  expected.tail(4).setConstant(5);
  c.Error("a component without anchors is held by s",
    LargestMagnitude(Run(TwoComponents(), options, arrays).positionWeights - expected), 0);
}

void CheckLaplacianWeights(Checks& c)
{
  const TestMesh mesh = Irregular(Icosphere(2), 0.05);
  OptimizerOptions options = Options(Mode::SMOOTH);
  options.gaussianWidth = 0.3;
  const auto check = [&](const std::string& name, LaplacianWeighting scheme, const auto& weights)
  {
    options.laplacianWeighting = scheme;
    const OptimizerResult result = Run(mesh, options);
    const CurvatureStatistics statistics = ComputeStatistics(result.meanCurvatures, Mask(162, 1));
    c.Error("W_L is right: " + name,
      LargestMagnitude(result.laplacianWeights - weights(result.meanCurvatures, statistics)),
      1e-15);
  };
  check("constant", LaplacianWeighting::CONSTANT,
    [](const Vector& kappa, const CurvatureStatistics&) -> Vector
    { return Vector::Ones(kappa.size()); });
  check("linear complement", LaplacianWeighting::LINEAR_COMPLEMENT,
    [](const Vector& kappa, const CurvatureStatistics& statistics) -> Vector
    { return 1 - LinearWeights(kappa, statistics).array(); });
  check("cdf complement", LaplacianWeighting::CDF_COMPLEMENT,
    [](const Vector& kappa, const CurvatureStatistics&) -> Vector
    { return 1 - CumulativeWeights(kappa, Mask(162, 1)).array(); });
  check("Gaussian", LaplacianWeighting::GAUSSIAN,
    [](const Vector& kappa, const CurvatureStatistics& statistics)
    { return GaussianWeights(kappa, 0.3 * statistics.threshold); });
}

void CheckMissingArrays(Checks& c)
{
  const auto isRefused = [&](const std::string& what, const OptimizerOptions& options)
  {
    c.Throws<InputError>(what + " without their array are an error", [&] { Run(Cube(), options); });
  };
  OptimizerOptions options = Options(Mode::SMOOTH);
  options.positionWeighting = PositionWeighting::ANCHORS;
  isRefused("anchors", options);
  options.positionWeighting = PositionWeighting::ARRAY;
  isRefused("the user's position weights", options);
  options = Options(Mode::SMOOTH);
  options.laplacianWeighting = LaplacianWeighting::ARRAY;
  isRefused("the user's Laplacian weights", options);
  isRefused("prescribed Laplacians", Options(Mode::PRESCRIBED_LAPLACIANS));
}
}

namespace
{
/// What depends on the mesh alone is computed once.
void CheckReuse(Checks& c)
{
  const TestMesh mesh = Irregular(Icosphere(3), 0.02);
  Optimizer optimizer(mesh.V, mesh.T);
  ProgressMonitor monitor;
  OptimizerOptions options = Options(Mode::OPTIMIZE_TRIANGLES);
  options.positionWeighting = PositionWeighting::CDF;
  optimizer.Run(options, {}, monitor);
  const int parts = optimizer.GetNumberOfParts();
  options.scaleFactor = 0.5;
  options.solverType = SolverType::AUTOMATIC;
  options.solver.tolerance = 1e-12;
  const OptimizerResult second = optimizer.Run(options, {}, monitor);
  c.Equal("another scale factor and solver need no new parts", optimizer.GetNumberOfParts(), parts);
  c.Error("kept parts give the same result",
    MaximumDistance(second.positions, Run(mesh, options).positions), 0);
  options.positionWeighting = PositionWeighting::LINEAR;
  optimizer.Run(options, {}, monitor);
  c.Equal("linear weights need the statistics and components and nothing else",
    optimizer.GetNumberOfParts(), parts + 2);
}

/// Multigrid hierarchies, factorisations and orders of the unknowns made so far.
std::vector<int> Counts(const Optimizer& optimizer)
{
  const PreconditionerCache& inverses = optimizer.GetInverses();
  return { inverses.GetNumberOfHierarchies(), inverses.GetNumberOfFactorisations(),
    inverses.GetNumberOfOrders() };
}

void CheckReuseOfInverses(Checks& c)
{
  OptimizerOptions options = Options(Mode::SMOOTH);
  options.scaleFactor = 0.003;
  options.solverType = SolverType::ITERATIVE;
  ProgressMonitor monitor;
  const TestMesh sphere = Irregular(Icosphere(5), 0.005);
  Optimizer smooth(sphere.V, sphere.T);
  smooth.Run(options, {}, monitor);
  options.solver.tolerance = 1e-9;
  const OptimizerResult again = smooth.Run(options, {}, monitor);
  c.Equal("another tolerance needs no new hierarchy", Counts(smooth), std::vector<int>{ 1, 0, 0 });
  c.Error("a kept hierarchy gives the same result",
    MaximumDistance(again.positions, Run(sphere, options).positions), 0);
  options.scaleFactor = 0.002;
  smooth.Run(options, {}, monitor);
  c.Equal("another scale factor needs a new hierarchy", Counts(smooth)[0], 2);

  options.laplacianType = LaplacianType::COTANGENT;
  const TestMesh thin = WithThinTriangles(Icosphere(5));
  Optimizer hard(thin.V, thin.T);
  hard.Run(options, {}, monitor);
  options.solver.tolerance = 1e-6;
  hard.Run(options, {}, monitor);
  c.Equal(
    "another tolerance needs no new factorisation", Counts(hard), std::vector<int>{ 1, 1, 1 });
  options.scaleFactor = 0.003;
  const OptimizerResult changed = hard.Run(options, {}, monitor);
  c.Equal("another scale factor needs a new factorisation in the kept order", Counts(hard),
    std::vector<int>{ 2, 2, 1 });
  c.Error("a kept order gives the same result",
    MaximumDistance(changed.positions, Run(thin, options).positions), 0);
}
}

int TestOptimizer(int argc, char* argv[])
{
  Groups groups(argc, argv);
  groups.Run("HeldVertices", CheckHeldVertices);
  groups.Run("Boundaries", CheckBoundaries);
  groups.Run("FixedPointsOfTheEquations", CheckFixedPointsOfTheEquations);
  groups.Run("Effects", CheckEffects);
  groups.Run("PositionWeights", CheckPositionWeights);
  groups.Run("LaplacianWeights", CheckLaplacianWeights);
  groups.Run("MissingArrays", CheckMissingArrays);
  groups.Run("ReuseOfInverses", CheckReuseOfInverses);
  groups.Run("Reuse", CheckReuse);
  return groups.Result();
}
