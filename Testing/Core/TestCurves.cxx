// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "MeshFixtures.h"
#include "MeshMeasures.h"

#include "Core/Optimizer/Optimizer.h"

#include <Eigen/Eigenvalues>

#include <cmath>

using namespace lmo;

namespace
{
/// Smoothing with constant weights.
OptimizerOptions Smoothing()
{
  OptimizerOptions options;
  options.mode = Mode::SMOOTH;
  options.positionWeighting = PositionWeighting::CONSTANT;
  options.scaleFactor = 0.1;
  return options;
}

OptimizerOptions SmoothingOfBoundary()
{
  OptimizerOptions options = Smoothing();
  options.boundaryCondition = BoundaryCondition::CURVE;
  return options;
}

Points Optimized(
  const TestMesh& mesh, const OptimizerOptions& options, const VertexArrays& arrays = {})
{
  ProgressMonitor monitor;
  return Optimize(mesh.V, mesh.T, options, arrays, monitor).positions;
}

/// A half sphere whose rim has noise in its plane.
TestMesh HalfSphereWithRimNoise()
{
  TestMesh mesh = HalfSphere(4);
  const std::vector<bool> isBoundary = BoundaryVertices(mesh);
  const Points noise = Random().Displacements(mesh.V.rows());
  for (Index i = 0; i < mesh.V.rows(); ++i)
  {
    if (isBoundary[i])
    {
      mesh.V.row(i) += 0.018 * Vector3(noise(i, 0), noise(i, 1), 0);
      mesh.V(i, 2) = 0;
    }
  }
  return mesh;
}

/// Root mean square of the distances of the rim from the unit circle, a mean change of the radius
/// left out.
double RimNoise(const TestMesh& mesh, const Points& V)
{
  const std::vector<bool> isBoundary = BoundaryVertices(mesh);
  std::vector<double> radii;
  for (Index i = 0; i < V.rows(); ++i)
  {
    if (isBoundary[i])
    {
      radii.push_back(V.row(i).head<2>().norm());
    }
  }
  const Eigen::Map<const Vector> values(radii.data(), static_cast<Eigen::Index>(radii.size()));
  return std::sqrt((values.array() - values.mean()).square().mean());
}

double LargestRimHeight(const TestMesh& mesh, const Points& V)
{
  const std::vector<bool> isBoundary = BoundaryVertices(mesh);
  double height = 0;
  for (Index i = 0; i < V.rows(); ++i)
  {
    height = isBoundary[i] ? Larger(height, std::abs(V(i, 2))) : height;
  }
  return height;
}

/// Three half planes that meet in stairs along the y axis: each step goes one cell along y and,
/// every \a run cells, one along x; the line that is meant leads from end to end.
struct Junction
{
  static constexpr int Length = 48;
  static constexpr int Width = 6;
  TestMesh mesh;
  std::vector<Index> line;   ///< its vertices in order
  std::vector<double> sheet; ///< of each triangle

  explicit Junction(int run)
  {
    std::vector<Vector3> points;
    Vector3 x = Vector3::Zero();
    for (int step = 0; step < Length; ++step)
    {
      points.push_back(x);
      x += step % (run + 1) == run ? Vector3(1, 0, 0) : Vector3(0, 1, 0);
    }
    const Vector3 across = Vector3(run, -1, 0).normalized();
    const Vector3 up(0, 0, 1);
    const Vector3 directions[3] = { up, 0.6 * across - 0.5 * up, -0.6 * across - 0.5 * up };
    this->mesh.V.resize(Length * (1 + 3 * Width), 3);
    std::vector<Eigen::Matrix<Index, 1, 3>> triangles;
    for (int i = 0; i < Length; ++i)
    {
      this->line.push_back(i);
      this->mesh.V.row(i) = points[i];
    }
    for (int k = 0; k < 3; ++k)
    {
      const auto id = [&](int i, int ring)
      { return static_cast<Index>(ring == 0 ? i : Length * (1 + k * Width + ring - 1) + i); };
      for (int i = 0; i < Length; ++i)
      {
        for (int ring = 1; ring <= Width; ++ring)
        {
          this->mesh.V.row(id(i, ring)) = points[i] + ring * directions[k];
        }
        for (int ring = 0; ring < Width && i + 1 < Length; ++ring)
        {
          triangles.push_back({ id(i, ring), id(i + 1, ring), id(i + 1, ring + 1) });
          triangles.push_back({ id(i, ring), id(i + 1, ring + 1), id(i, ring + 1) });
          this->sheet.insert(this->sheet.end(), 2, k);
        }
      }
    }
    this->mesh.T.resize(static_cast<Eigen::Index>(triangles.size()), 3);
    for (std::size_t t = 0; t < triangles.size(); ++t)
    {
      this->mesh.T.row(static_cast<Eigen::Index>(t)) = triangles[t];
    }
  }

  /// Root mean square of the distances of the line, without a fifth at each end, from the straight
  /// line that fits it best.
  double Deviation(const Points& V) const
  {
    const Index margin = Length / 5;
    const std::vector<Index> inner(this->line.begin() + margin, this->line.end() - margin);
    const Points points = V(inner, Eigen::indexing::all);
    const Points centred = points.rowwise() - points.colwise().mean();
    const Eigen::SelfAdjointEigenSolver<Matrix3> eigen(centred.transpose() * centred);
    const Vector3 direction = eigen.eigenvectors().col(2).transpose();
    const Points across = centred - (centred * direction.transpose()) * direction;
    return std::sqrt(across.rowwise().squaredNorm().mean());
  }

  Points Smoothed(bool featureSmoothing) const
  {
    OptimizerOptions options = Smoothing();
    options.featureConstraints = true;
    options.featureSmoothing = featureSmoothing;
    VertexArrays arrays;
    arrays.labels =
      Eigen::Map<const Vector>(this->sheet.data(), static_cast<Eigen::Index>(this->sheet.size()));
    return Optimized(this->mesh, options, arrays);
  }

  /// The largest displacement of the line's ends.
  double EndError() const
  {
    const Points V = this->Smoothed(true);
    return Larger((V.row(this->line.front()) - this->mesh.V.row(this->line.front())).norm(),
      (V.row(this->line.back()) - this->mesh.V.row(this->line.back())).norm());
  }
};

/// Largest displacement of the corners of a square.
double CornerError(int cells, const Points& V)
{
  double error = 0;
  for (const Vector3& corner :
    { Vector3(0, 0, 0), Vector3(cells, 0, 0), Vector3(0, cells, 0), Vector3(cells, cells, 0) })
  {
    error = Larger(error, (V.rowwise() - corner).rowwise().norm().minCoeff());
  }
  return error;
}

void CheckBoundary(Checks& c)
{
  const TestMesh mesh = HalfSphereWithRimNoise();
  const Points smoothed = Optimized(mesh, SmoothingOfBoundary());
  c.Error(
    "CURVE removes the noise of a rim", RimNoise(mesh, smoothed), 0.4 * RimNoise(mesh, mesh.V));
  c.Error("a rim in a plane stays in it", LargestRimHeight(mesh, smoothed), 1e-12);
  OptimizerOptions guided = SmoothingOfBoundary();
  guided.mode = Mode::SMOOTH_GUIDED;
  c.Error("a rim in a plane stays in it when the triangles follow normals",
    LargestRimHeight(mesh, Optimized(mesh, guided)), 1e-12);
  c.Error("the corners of a square stay",
    CornerError(12, Optimized(Grid(12, 0.3), SmoothingOfBoundary())), 0);

  OptimizerOptions sliding = SmoothingOfBoundary();
  sliding.mode = Mode::OPTIMIZE_TRIANGLES;
  OptimizerOptions same = sliding;
  same.boundaryCondition = BoundaryCondition::SLIDING;
  c.Error("CURVE is SLIDING where the mode does not smooth",
    LargestMagnitude(Optimized(mesh, sliding) - Optimized(mesh, same)), 0);
}

void CheckJunctions(Checks& c)
{
  for (const int run : { 1, 2, 3 })
  {
    const Junction junction(run);
    const std::string stairs = "stairs with a step in " + std::to_string(run + 1) + " edges";
    c.Error("a junction of " + stairs + " becomes straight",
      junction.Deviation(junction.Smoothed(true)), 0.1);
    c.Error("the ends of a junction of " + stairs + " stay", junction.EndError(), 0);
  }
  const Junction junction(2);
  c.Error("without FeatureSmoothing the junction keeps its shape",
    std::abs(
      junction.Deviation(junction.Smoothed(false)) / junction.Deviation(junction.mesh.V) - 1),
    0.1);
}

/// Largest change of a coordinate.
double LargestChange(const TestMesh& mesh, const Points& V, int coordinate)
{
  return LargestMagnitude(V.col(coordinate) - mesh.V.col(coordinate));
}

void CheckFreeAxes(Checks& c)
{
  const TestMesh mesh = Irregular(HalfSphere(3), 0.03);
  OptimizerOptions options = Smoothing();
  options.boundaryCondition = BoundaryCondition::FREE;
  options.freeAxes = { 0, 0, 1 };
  for (const bool hasPlanes : { false, true })
  {
    options.tangentPlaneConstraints = hasPlanes;
    const std::string with = hasPlanes ? ", with tangent planes" : "";
    const Points V = Optimized(mesh, options);
    c.Error("x does not change if z alone is free" + with, LargestChange(mesh, V, 0), 0);
    c.Error("y does not change if z alone is free" + with, LargestChange(mesh, V, 1), 0);
    c.Error("z changes if it is free" + with, -LargestChange(mesh, V, 2), -0.01);
  }
  options.freeAxes = { 1, 1, 0 };
  for (const Mode mode : { Mode::OPTIMIZE_TRIANGLES, Mode::SMOOTH, Mode::OPTIMIZE_WITHIN_DEVIATION,
         Mode::SMOOTH_GUIDED })
  {
    options.mode = mode;
    const std::string inMode = " in mode " + std::to_string(static_cast<int>(mode));
    c.Error("z does not change if x and y alone are free" + inMode,
      LargestChange(mesh, Optimized(mesh, options), 2), 0);
    c.Error(
      "x changes if it is free" + inMode, -LargestChange(mesh, Optimized(mesh, options), 0), -1e-4);
  }
}
}

int TestCurves(int argc, char* argv[])
{
  Groups groups(argc, argv);
  groups.Run("Boundary", CheckBoundary);
  groups.Run("Junctions", CheckJunctions);
  groups.Run("FreeAxes", CheckFreeAxes);
  return groups.Result();
}
