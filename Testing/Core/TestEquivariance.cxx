// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "MeshMeasures.h"
#include "OperatorFixtures.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <numeric>

using namespace lmo;

namespace
{
/// A mesh with an array of each kind.
struct Model
{
  TestMesh mesh;
  VertexArrays arrays;
};

Model MakeModel(const TestMesh& mesh)
{
  const Eigen::Index n = mesh.V.rows();
  Random random;
  Model model{ mesh, {} };
  model.arrays.positionWeights = (random.Displacements(n).col(0).array() > 0).cast<double>();
  model.arrays.laplacianWeights = random.Displacements(n).col(0).cwiseAbs();
  model.arrays.prescribedLaplacians = 0.05 * random.Displacements(n);
  model.arrays.fixedPoints = Vector::Unit(n, n / 2);
  return model;
}

/// x -> scale R x + shift
struct Similarity
{
  double scale = 1;
  Matrix3 R = Matrix3::Identity();
  Vector3 shift = Vector3::Zero();

  Points Map(const Points& V) const
  {
    return (this->scale * V * this->R.transpose()).rowwise() + this->shift;
  }

  Points MapVectors(const Points& vectors) const
  {
    return this->scale * vectors * this->R.transpose();
  }
};

/// Difference between the optimised image and the image of the optimised mesh, in the mesh's unit.
double EquivarianceError(const Model& model, const OptimizerOptions& options, const Similarity& map)
{
  Model image = model;
  image.mesh.V = map.Map(model.mesh.V);
  // Mean curvature normals have the unit 1 / length, other Laplacians that of the mesh.
  const bool isCurvature = options.laplacianType == LaplacianType::MEAN_CURVATURE;
  image.arrays.prescribedLaplacians =
    map.MapVectors(*model.arrays.prescribedLaplacians) / (isCurvature ? map.scale * map.scale : 1);
  return MaximumDistance(Run(image.mesh, options, image.arrays).positions,
           map.Map(Run(model.mesh, options, model.arrays).positions)) /
         map.scale;
}

/// The same numbers in every run, in another order.
std::vector<Index> Shuffled(Eigen::Index count)
{
  std::vector<Index> order(count);
  std::iota(order.begin(), order.end(), 0);
  const Points keys = Random().Displacements(count);
  std::sort(order.begin(), order.end(), [&](Index i, Index j) { return keys(i, 0) < keys(j, 0); });
  return order;
}

/// Difference after the vertices and triangles were put in another order.
double RenumberingError(const Model& model, const OptimizerOptions& options)
{
  const std::vector<Index> order = Shuffled(model.mesh.V.rows());
  std::vector<Index> place(order.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    place[order[i]] = static_cast<Index>(i);
  }
  Model image = model;
  image.mesh.V = model.mesh.V(order, Eigen::indexing::all);
  image.mesh.T = model.mesh.T(Shuffled(model.mesh.T.rows()), Eigen::indexing::all)
                   .unaryExpr([&](Index i) { return place[i]; });
  image.arrays.positionWeights = (*model.arrays.positionWeights)(order);
  image.arrays.laplacianWeights = (*model.arrays.laplacianWeights)(order);
  image.arrays.prescribedLaplacians =
    (*model.arrays.prescribedLaplacians)(order, Eigen::indexing::all);
  image.arrays.fixedPoints = (*model.arrays.fixedPoints)(order);
  const Points expected = Run(model.mesh, options, model.arrays).positions;
  return MaximumDistance(
    Run(image.mesh, options, image.arrays).positions, expected(order, Eigen::indexing::all));
}

/// Every combination of the enumerations, with its name.
std::vector<std::pair<std::string, OptimizerOptions>> AllOptions()
{
  std::vector<std::pair<std::string, OptimizerOptions>> all;
  for (int k = 0; k < 3 * 3 * 5 * 5 * 3; ++k)
  {
    const int mode = k % 3, L = k / 3 % 3, Wp = k / 9 % 5, WL = k / 45 % 5, boundary = k / 225;
    OptimizerOptions options = Options(static_cast<Mode>(mode), static_cast<LaplacianType>(L));
    options.positionWeighting = static_cast<PositionWeighting>(Wp);
    options.laplacianWeighting = static_cast<LaplacianWeighting>(WL);
    options.boundaryCondition = static_cast<BoundaryCondition>(boundary);
    // Half of the combinations each have the switches on.
    options.modulateByTriangleQuality = (mode + L + Wp + WL + boundary) % 2;
    options.robustLaplacian = (mode + L + Wp) / 2 % 2;
    options.tangentPlaneConstraints = (mode + L + Wp + WL + boundary) / 2 % 2;
    all.emplace_back("mode " + std::to_string(mode) + ", L " + std::to_string(L) + ", W_p " +
                       std::to_string(Wp) + ", W_L " + std::to_string(WL) + ", boundary " +
                       std::to_string(boundary),
      options);
  }
  return all;
}

/// Largest error over all options, with the options that have it.
template <typename ErrorOf>
void CheckAll(Checks& c, const std::string& property, double bound, const ErrorOf& errorOf)
{
  double worst = -1;
  std::string where;
  for (const auto& [name, options] : AllOptions())
  {
    const double error = errorOf(options);
    if (Larger(worst, error) != worst)
    {
      worst = error;
      where = name;
    }
  }
  c.Error(property + "; worst: " + where, worst, bound);
}
const Model& IrregularHalfSphere()
{
  static const Model model = MakeModel(Irregular(HalfSphere(2), 0.05));
  return model;
}

void CheckSimilarity(Checks& c, const std::string& property, double bound, const Similarity& map)
{
  CheckAll(c, property, bound,
    [&](const OptimizerOptions& options)
    { return EquivarianceError(IrregularHalfSphere(), options, map); });
}

void CheckUnits(Checks& c)
{
  CheckSimilarity(c, "the result follows a small unit", 1e-12, { 1e8 });
  CheckSimilarity(c, "the result follows a large unit", 1e-12, { 1e-8 });
}

void CheckRigidMotions(Checks& c)
{
  const Matrix3 rotation = Eigen::AngleAxisd(1, Eigen::Vector3d(1, 2, 3).normalized()).matrix();
  CheckSimilarity(c, "the result follows a rotation", 1e-12, { 1, rotation });
  // 1e-8 is the distance of neighbouring numbers at 1e8.
  CheckSimilarity(c, "the result follows a translation", 3e-8,
    { 1, Matrix3::Identity(), Vector3(1e8, -1e8, 1e8) });
}

void CheckRenumbering(Checks& c)
{
  CheckAll(c, "the result follows a renumbering", 1e-12,
    [&](const OptimizerOptions& options)
    { return RenumberingError(IrregularHalfSphere(), options); });
}
}

int TestEquivariance(int argc, char* argv[])
{
  Groups groups(argc, argv);
  groups.Run("Units", CheckUnits);
  groups.Run("RigidMotions", CheckRigidMotions);
  groups.Run("Renumbering", CheckRenumbering);
  return groups.Result();
}
