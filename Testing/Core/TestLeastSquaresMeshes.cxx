// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "MeshMeasures.h"
#include "OperatorFixtures.h"

#include <cmath>

using namespace lmo;

namespace
{
/// Eqn. 11 with L_u as an energy, written down as in the paper. Eqns. 8 and 10 are special cases.
struct Energy
{
  TestMesh mesh;
  Points f;
  Vector positionWeights;
  Vector laplacianWeights;
  std::vector<std::vector<Index>> rings = Neighbours(mesh);

  double operator()(const Points& moved) const
  {
    double energy = 0;
    for (Eigen::Index i = 0; i < moved.rows(); ++i)
    {
      const Vector3 delta =
        moved(this->rings[i], Eigen::indexing::all).colwise().mean() - moved.row(i);
      energy += std::pow(this->laplacianWeights[i], 2) * (delta - this->f.row(i)).squaredNorm();
      energy +=
        std::pow(this->positionWeights[i], 2) * (moved.row(i) - this->mesh.V.row(i)).squaredNorm();
    }
    return energy;
  }
};

/// Largest gain in energy by a random perturbation of the solution, relative to the energy.
/// \param isFree 1 for the vertices that may move, else 0
double EnergyGain(const Energy& energy, const Points& solution, const Vector& isFree)
{
  const double minimum = energy(solution);
  Random random;
  double gain = 0;
  for (int k = 0; k < 100; ++k)
  {
    const Points perturbation = isFree.asDiagonal() * random.Displacements(solution.rows());
    for (const double size : { 1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6 })
    {
      gain = Larger(gain, minimum - energy(solution + size * perturbation));
    }
  }
  return gain / minimum;
}

/// 1 at every tenth vertex, else 0.
Vector EveryTenth(Eigen::Index vertices)
{
  Vector tags = Vector::Zero(vertices);
  for (Eigen::Index i = 0; i < vertices; i += 10)
  {
    tags[i] = 1;
  }
  return tags;
}

OptimizerOptions Anchored(Mode mode, double s)
{
  OptimizerOptions options = Options(mode);
  options.positionWeighting = PositionWeighting::ANCHORS;
  options.scaleFactor = s;
  return options;
}

void CheckMinimum(Checks& c)
{
  const TestMesh mesh = Irregular(Icosphere(2), 0.05);
  const Eigen::Index n = mesh.V.rows();
  const Vector ones = Vector::Ones(n);
  VertexArrays arrays;
  arrays.positionWeights = EveryTenth(n);
  const Vector Wp = 2 * EveryTenth(n);
  c.Error("a least-squares mesh minimises Eqn. 8",
    EnergyGain({ mesh, Points::Zero(n, 3), Wp, ones },
      Run(mesh, Anchored(Mode::SMOOTH, 2), arrays).positions, ones),
    1e-14);
  c.Error("detail-preserving optimisation minimises Eqn. 10",
    EnergyGain({ mesh, Apply(OperatorFixtures(mesh).cotangent, mesh.V), Wp, ones },
      Run(mesh, Anchored(Mode::OPTIMIZE_TRIANGLES, 2), arrays).positions, ones),
    1e-14);
}

/// All of Eqn. 11 from the user's arrays, on a surface with a fixed boundary.
void CheckGeneralMinimum(Checks& c)
{
  const TestMesh mesh = Irregular(HalfSphere(3), 0.02);
  const Eigen::Index n = mesh.V.rows();
  Random random;
  VertexArrays arrays;
  arrays.prescribedLaplacians = 0.1 * random.Displacements(n);
  arrays.positionWeights = random.Displacements(n).col(0).cwiseAbs();
  arrays.laplacianWeights = random.Displacements(n).col(0).cwiseAbs();
  OptimizerOptions options = Options(Mode::PRESCRIBED_LAPLACIANS);
  options.positionWeighting = PositionWeighting::ARRAY;
  options.laplacianWeighting = LaplacianWeighting::ARRAY;
  Vector isFree = Vector::Ones(n);
  for (const auto& [i, j] : BoundaryEdges(mesh))
  {
    isFree[i] = isFree[j] = 0;
  }
  // Boundary vertices have no Laplacian row.
  const Vector WL = arrays.laplacianWeights->cwiseProduct(isFree);
  c.Error("the user's f, W_p and W_L minimise Eqn. 11",
    EnergyGain({ mesh, *arrays.prescribedLaplacians, *arrays.positionWeights, WL },
      Run(mesh, options, arrays).positions, isFree),
    1e-14);
}

/// Distance of the anchors from where they were.
double AnchorError(const TestMesh& mesh, Mode mode, double s)
{
  VertexArrays arrays;
  arrays.positionWeights = EveryTenth(mesh.V.rows());
  const Points moved = Run(mesh, Anchored(mode, s), arrays).positions - mesh.V;
  return LargestMagnitude((arrays.positionWeights->asDiagonal() * moved).rowwise().norm());
}

/// Distance of the inner vertices from the centroids of their one-rings.
double InnerFairnessError(const TestMesh& mesh, const Points& moved)
{
  const auto rings = Neighbours(mesh);
  const std::vector<bool> isBoundary = BoundaryVertices(mesh);
  double error = 0;
  for (std::size_t i = 0; i < rings.size(); ++i)
  {
    const Vector3 delta = moved(rings[i], Eigen::indexing::all).colwise().mean() - moved.row(i);
    error = Larger(error, isBoundary[i] ? 0 : delta.norm());
  }
  return error;
}

void CheckInterpolation(Checks& c)
{
  const TestMesh mesh = Irregular(Icosphere(2), 0.05);
  for (const Mode mode : { Mode::SMOOTH, Mode::OPTIMIZE_TRIANGLES })
  {
    c.Error("anchors of great weight are interpolated", AnchorError(mesh, mode, 1e4), 1e-7);
    c.Error("the distance to the anchors falls with the square of the weight",
      std::abs(AnchorError(mesh, mode, 100) / AnchorError(mesh, mode, 1000) - 100), 1);
  }
  // Without inner anchors every equation of Eqn. 9 can be met.
  const TestMesh grid = Grid(8, 0.3);
  VertexArrays arrays;
  arrays.positionWeights = Vector::Zero(grid.V.rows());
  c.Error("without anchors inside each vertex is at its ring's centroid",
    InnerFairnessError(grid, Run(grid, Anchored(Mode::SMOOTH, 1), arrays).positions), 1e-13);
}
}

int TestLeastSquaresMeshes(int argc, char* argv[])
{
  Groups groups(argc, argv);
  groups.Run("Minimum", CheckMinimum);
  groups.Run("GeneralMinimum", CheckGeneralMinimum);
  groups.Run("Interpolation", CheckInterpolation);
  return groups.Result();
}
