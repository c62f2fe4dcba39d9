// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause

// Properties of the modes with several steps on small meshes made from seeds. A failing property
// names the seed, which alone repeats it:  lmoCoreTests TestRandomSteps SEED
#include "Checks.h"
#include "MeshMeasures.h"
#include "OperatorFixtures.h"
#include "RandomMeshes.h"

#include "Core/Base/ThreadPool.h"

#include <algorithm>
#include <cmath>

using namespace lmo;

namespace
{
Sample MakeSample(unsigned seed)
{
  Seeded seeded(seed);
  Sample sample;
  sample.mesh = MakeRandomMesh(seeded);
  sample.mesh.V = (sample.mesh.V.array() * 4096).round() / 4096; // exact in single precision, too
  sample.arrays.fixedPoints =
    (seeded.Vectors(sample.mesh.V.rows()).col(0).array() > 0.7).cast<double>();
  OptimizerOptions& options = sample.options;
  options.mode = seeded.Take(3) ? Mode::OPTIMIZE_WITHIN_DEVIATION : Mode::SMOOTH_GUIDED;
  options.boundaryCondition = static_cast<BoundaryCondition>(seeded.Take(3));
  options.deviation.maximum = std::pow(10, seeded.Number(-4, -0.5));
  options.deviation.improveWorstTriangles = seeded.Take(2);
  options.detectFeatures = seeded.Take(2);
  options.roundToFloat = seeded.Take(2);
  options.guide.normalIterations = seeded.Take(20);
  options.guide.detailWeight = std::pow(10, seeded.Number(-1, 1));
  return sample;
}

/// \param hint triangle to begin with
bool IsClose(const Vector3& x, const TestMesh& mesh, Eigen::Index hint, double distance)
{
  for (Eigen::Index t = 0; t < mesh.T.rows(); ++t)
  {
    if (DistanceToTriangle(x, mesh, (hint + t) % mesh.T.rows()) <= distance)
    {
      return true;
    }
  }
  return false;
}

/// Tries points of a grid on each triangle, one by one.
bool IsWithin(const TestMesh& mesh, const TestMesh& other, double distance)
{
  for (Eigen::Index t = 0; t < mesh.T.rows(); ++t)
  {
    const Points grid = GridOn(mesh, t);
    for (const auto& x : grid.rowwise())
    {
      if (!IsClose(x, other, t, distance))
      {
        return false;
      }
    }
  }
  return true;
}

/// Triangles that name a vertex twice are no part of the surface.
TestMesh WithoutDegenerate(const TestMesh& mesh)
{
  std::vector<Eigen::Index> kept;
  for (Eigen::Index t = 0; t < mesh.T.rows(); ++t)
  {
    if (!IsDegenerate(mesh.T, static_cast<Index>(t)))
    {
      kept.push_back(t);
    }
  }
  return { mesh.V, Triangles(mesh.T(kept, Eigen::indexing::all)) };
}

void CheckDeviation(const Sample& sample, const OptimizerResult& result, Findings& findings)
{
  const double bound = result.deviation.relativeBound;
  findings.AddIf(!(bound <= sample.options.deviation.maximum), "the deviation is too large");
  const TestMesh before = WithoutDegenerate(sample.mesh);
  const TestMesh after{ result.positions, before.T };
  const MeshQuantities mesh(sample.mesh.V, sample.mesh.T);
  const double distance = (bound + 1e-12) * mesh.GetDiagonal();
  findings.AddIf(!IsWithin(after, before, distance), "the result is farther than the bound");
  findings.AddIf(!IsWithin(before, after, distance), "the input is farther than the bound");
  findings.AddIf(result.comparison.after.minimum < result.comparison.before->minimum,
    "the worst triangle is worse");
  findings.AddIf(result.comparison.flippedTriangles > 0, "a triangle turns over");
  findings.AddIf(
    bound > result.comparison.relativeMaximumDisplacement, "the bound is above the displacement");
}

std::string FaultsOf(unsigned seed)
{
  const Sample sample = MakeSample(seed);
  const OptimizerResult result = Run(sample.mesh, sample.options, sample.arrays);
  Findings findings;
  findings.AddIf(!result.positions.allFinite(), "points are not finite");
  for (Index i = 0; i < sample.mesh.V.rows(); ++i)
  {
    findings.AddIf(
      (*sample.arrays.fixedPoints)[i] != 0 && result.positions.row(i) != sample.mesh.V.row(i),
      "fixed point " + std::to_string(i));
  }
  if (sample.options.mode == Mode::OPTIMIZE_WITHIN_DEVIATION)
  {
    CheckDeviation(sample, result, findings);
  }
  else
  {
    findings.AddIf(!result.isConverged, "the solver has not converged");
  }
  const ThreadPool team(3);
  findings.AddIf(Run(sample.mesh, sample.options, sample.arrays).positions != result.positions,
    "three threads give another result");
  return findings.Text;
}
}

int TestRandomSteps(int argc, char* argv[])
{
  return CheckSeeds(argc, argv, 300, FaultsOf);
}
