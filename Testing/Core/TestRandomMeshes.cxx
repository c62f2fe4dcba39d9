// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause

// Properties of the solution on thousands of small meshes made from seeds. A failing property names
// the seed, which alone repeats it:  lmoCoreTests TestRandomMeshes SEED
#include "Checks.h"
#include "MeshMeasures.h"
#include "OperatorFixtures.h"
#include "RandomMeshes.h"

#include "Core/Base/ThreadPool.h"
#include "Core/Optimizer/ProblemSetup.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace lmo;

namespace
{
Sample MakeSample(unsigned seed)
{
  Seeded seeded(seed);
  Sample sample;
  sample.mesh = MakeRandomMesh(seeded);
  const Eigen::Index n = sample.mesh.V.rows();
  sample.arrays.positionWeights = seeded.Vectors(n).col(0).cwiseAbs().array() + 0.01;
  sample.arrays.laplacianWeights = seeded.Vectors(n).col(0).cwiseAbs();
  sample.arrays.prescribedLaplacians = 0.05 * seeded.Vectors(n);
  if (seeded.Take(2))
  {
    sample.arrays.fixedPoints = (seeded.Vectors(n).col(0).array() > 0.7).cast<double>();
  }
  OptimizerOptions& options = sample.options;
  options.mode = static_cast<Mode>(seeded.Take(3));
  options.laplacianType = static_cast<LaplacianType>(seeded.Take(3));
  options.robustLaplacian = seeded.Take(2);
  options.positionWeighting = static_cast<PositionWeighting>(seeded.Take(5));
  options.laplacianWeighting = static_cast<LaplacianWeighting>(seeded.Take(5));
  options.boundaryCondition = static_cast<BoundaryCondition>(seeded.Take(3));
  options.modulateByTriangleQuality = seeded.Take(2);
  options.tangentPlaneConstraints = seeded.Take(2);
  options.scaleFactor = std::pow(10, seeded.Number(-2, 1));
  options.solver.tolerance = 1e-10;
  return sample;
}

LeastSquaresProblem ProblemOf(const Sample& sample)
{
  const MeshQuantities mesh(sample.mesh.V, sample.mesh.T);
  const CotangentQuantities quantities(mesh, sample.options.robustLaplacian);
  ProgressMonitor monitor;
  return MakePlan(quantities, sample.options, sample.arrays, monitor).problem;
}

double EnergyOf(const Sample& sample, const LeastSquaresProblem& problem, const Points& positions)
{
  return Energy(problem, positions - sample.mesh.V);
}

/// Compared by energy: where the minimum is flat the points may differ more than the solvers do.
void CompareSolvers(
  const Sample& sample, const LeastSquaresProblem& problem, double energy, Findings& findings)
{
  // Sliding points are projected on their curves afterwards.
  if (sample.options.boundaryCondition == BoundaryCondition::SLIDING)
  {
    return;
  }
  Sample direct = sample;
  direct.options.solverType = SolverType::DIRECT;
  try
  {
    const OptimizerResult result = Run(direct.mesh, direct.options, direct.arrays);
    const double other = EnergyOf(sample, problem, result.positions);
    findings.AddIf(std::abs(other - energy) > 1e-6 * Energy(problem, {}) + 1e-12,
      "the direct solver has the energy " + std::to_string(other) + ", the iterative one " +
        std::to_string(energy));
  }
  catch (const SolverError&)
  {
    // Weights of 0 leave points undetermined; the iterative solver keeps them where they are.
  }
}

void CheckSolution(const Sample& sample, const OptimizerResult& result, Findings& findings)
{
  const Mask isUsed = OperatorFixtures(sample.mesh).topology->isUsed;
  const double s = sample.options.scaleFactor;
  const double largest = std::max(s, 1.01);
  findings.AddIf(!result.positions.allFinite(), "points are not finite");
  findings.AddIf(result.positionWeights.minCoeff() < 0 ||
                   result.positionWeights.maxCoeff() > largest * (1 + 1e-15),
    "a position weight is not in [0, s]");
  findings.AddIf(
    result.laplacianWeights.minCoeff() < 0 || result.laplacianWeights.maxCoeff() > 1 + 1e-15,
    "a Laplacian weight is not in [0, 1]");
  for (Index i = 0; i < sample.mesh.V.rows(); ++i)
  {
    const bool isFixed =
      !isUsed[i] || (sample.arrays.fixedPoints && (*sample.arrays.fixedPoints)[i] != 0);
    findings.AddIf(
      isFixed && result.displacements.row(i).norm() > 0, "fixed point " + std::to_string(i));
  }
  const LeastSquaresProblem problem = ProblemOf(sample);
  const double energy = EnergyOf(sample, problem, result.positions);
  const bool isProjected = sample.options.boundaryCondition == BoundaryCondition::SLIDING;
  findings.AddIf(!isProjected && energy > Energy(problem, {}) * (1 + 1e-9),
    "the energy is worse than that of the input");
  const Points d = result.displacements;
  const double residual = Residual(problem, d).norm() / Residual(problem, {}).norm();
  findings.AddIf(!isProjected && result.relativeResidual > 0 &&
                   std::abs(residual - result.relativeResidual) > 1e-8,
    "the residual is not that of the definition but " + std::to_string(residual));
  CompareSolvers(sample, problem, energy, findings);
}

/// The result of a scaled, turned and moved mesh with renumbered triangles, mapped back.
Points RunImage(const Sample& sample)
{
  const Matrix3 R = Eigen::AngleAxisd(1, Eigen::Vector3d(1, 2, 3).normalized()).matrix();
  const Vector3 shift(3, -2, 1);
  const double scale = 8;
  Sample image = sample;
  image.mesh.V = (scale * sample.mesh.V * R.transpose()).rowwise() + shift;
  image.mesh.T = sample.mesh.T.colwise().reverse();
  // Mean curvature normals have the unit 1 / length, other Laplacians that of the mesh.
  const bool isCurvature = sample.options.laplacianType == LaplacianType::MEAN_CURVATURE;
  image.arrays.prescribedLaplacians =
    (isCurvature ? 1 / scale : scale) * *sample.arrays.prescribedLaplacians * R.transpose();
  const Points moved = Run(image.mesh, image.options, image.arrays).positions;
  return (moved.rowwise() - shift) * R / scale;
}

std::string FaultsOf(unsigned seed)
{
  const Sample sample = MakeSample(seed);
  Findings findings;
  const OptimizerResult result = Run(sample.mesh, sample.options, sample.arrays);
  CheckSolution(sample, result, findings);
  {
    const ThreadPool team(3);
    findings.AddIf(Run(sample.mesh, sample.options, sample.arrays).positions != result.positions,
      "three threads give another result");
  }
  if (result.relativeResidual <= sample.options.solver.tolerance)
  {
    const Points image = RunImage(sample);
    const double error = MaximumDistance(image, result.positions);
    const LeastSquaresProblem problem = ProblemOf(sample);
    const double difference =
      EnergyOf(sample, problem, image) - EnergyOf(sample, problem, result.positions);
    // Where the minimum is flat, points differ by more than the tolerance and the energy does not.
    findings.AddIf(!(error < 1e-5 || std::abs(difference) < 1e-12 * Energy(problem, {})),
      "equivariance error " + std::to_string(error));
  }
  return findings.Text;
}
}

int TestRandomMeshes(int argc, char* argv[])
{
  return CheckSeeds(argc, argv, 3000, FaultsOf);
}
