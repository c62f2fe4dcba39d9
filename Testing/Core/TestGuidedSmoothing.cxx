// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause

// SMOOTH_GUIDED against the same method with dense matrices and pairs of triangles found by trial,
// as theory.md describes it.
#include "Checks.h"
#include "MeshMeasures.h"
#include "OperatorFixtures.h"

#include "Core/Operators/NormalFilter.h"

#include <Eigen/Dense>

#include <cmath>

using namespace lmo;

namespace
{
Vector3 Corner(const TestMesh& mesh, Eigen::Index t, int k)
{
  return mesh.V.row(mesh.T(t, k));
}

Vector3 Centroid(const TestMesh& mesh, Eigen::Index t)
{
  return (Corner(mesh, t, 0) + Corner(mesh, t, 1) + Corner(mesh, t, 2)) / 3;
}

/// Twice the area of triangle t times its unit normal.
Vector3 AreaVector(const TestMesh& mesh, Eigen::Index t)
{
  return (Corner(mesh, t, 1) - Corner(mesh, t, 0)).cross(Corner(mesh, t, 2) - Corner(mesh, t, 0));
}

bool ShareVertex(const TestMesh& mesh, Eigen::Index s, Eigen::Index t)
{
  bool isShared = false;
  for (int k = 0; k < 9; ++k)
  {
    isShared = isShared || mesh.T(s, k / 3) == mesh.T(t, k % 3);
  }
  return isShared;
}

/// Mean distance of the centroids of triangles that share a vertex.
double MeanDistance(const TestMesh& mesh)
{
  double sum = 0;
  int count = 0;
  for (Eigen::Index t = 0; t < mesh.T.rows(); ++t)
  {
    for (Eigen::Index s = 0; s < t; ++s)
    {
      if (ShareVertex(mesh, s, t))
      {
        sum += (Centroid(mesh, s) - Centroid(mesh, t)).norm();
        ++count;
      }
    }
  }
  return sum / count;
}

double Gaussian(double x, double width)
{
  return std::exp(-x * x / (2 * width * width));
}

/// Bilateral filter of the unit normals (Zheng et al. 2011).
Points FilteredNormals(const TestMesh& mesh, int iterations, double width)
{
  const double distance = MeanDistance(mesh);
  Points normals(mesh.T.rows(), 3);
  for (Eigen::Index t = 0; t < mesh.T.rows(); ++t)
  {
    normals.row(t) = AreaVector(mesh, t).normalized();
  }
  for (int iteration = 0; iteration < iterations; ++iteration)
  {
    const Points old = normals;
    for (Eigen::Index t = 0; t < mesh.T.rows(); ++t)
    {
      Vector3 sum = Vector3::Zero();
      for (Eigen::Index s = 0; s < mesh.T.rows(); ++s)
      {
        const double nearness = Gaussian((Centroid(mesh, s) - Centroid(mesh, t)).norm(), distance);
        const double likeness = Gaussian((old.row(s) - old.row(t)).norm(), width);
        sum += ShareVertex(mesh, s, t)
                 ? Vector3(AreaVector(mesh, s).norm() * nearness * likeness * old.row(s))
                 : Vector3(Vector3::Zero());
      }
      normals.row(t) = sum.normalized();
    }
  }
  return normals;
}

/// T_i for the normals of the triangles: the projection on the directions that they leave free.
Matrix3 FreeDirections(const TestMesh& mesh, const Points& normals, Index i)
{
  Matrix3 sum = Matrix3::Zero();
  int count = 0;
  for (Eigen::Index t = 0; t < mesh.T.rows(); ++t)
  {
    if ((mesh.T.row(t).array() == i).any())
    {
      sum += normals.row(t).transpose() * normals.row(t);
      ++count;
    }
  }
  const Eigen::SelfAdjointEigenSolver<Matrix3> eigen(sum / count);
  const Eigen::Vector3d isFree = (eigen.eigenvalues().array() < 0.05).cast<double>();
  return eigen.eigenvectors() * isFree.asDiagonal() * eigen.eigenvectors().transpose();
}

/// L_u as a matrix.
Eigen::MatrixXd UniformMatrix(const TestMesh& mesh)
{
  Eigen::MatrixXd L = -Eigen::MatrixXd::Identity(mesh.V.rows(), mesh.V.rows());
  const auto rings = Neighbours(mesh);
  for (std::size_t i = 0; i < rings.size(); ++i)
  {
    for (const Index j : rings[i])
    {
      L(i, j) += 1.0 / double(rings[i].size());
    }
  }
  return L;
}

/// Solution of smoothing with W_p = s I.
Points Smoothed(const TestMesh& mesh, double s)
{
  const Eigen::MatrixXd L = UniformMatrix(mesh);
  const Eigen::MatrixXd A =
    L.transpose() * L + s * s * Eigen::MatrixXd::Identity(L.rows(), L.cols());
  return A.ldlt().solve(Eigen::MatrixXd(s * s * mesh.V));
}

/// Minimum of the energy of theory.md, whose unknowns are x, y and z of each vertex in turn.
Points Followed(const TestMesh& mesh, const Points& normals, double detailWeight)
{
  const Eigen::Index n = mesh.V.rows();
  const Eigen::MatrixXd L = UniformMatrix(mesh);
  Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(3 * mesh.T.rows() + 3 * n, 3 * n);
  for (Eigen::Index t = 0; t < mesh.T.rows(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      for (int l = 0; l < 3; ++l)
      {
        rows.block<1, 3>(3 * t + k, 3 * mesh.T(t, l)) = ((k == l) - 1.0 / 3) * normals.row(t);
      }
    }
  }
  for (Index i = 0; i < n; ++i)
  {
    const Matrix3 T = FreeDirections(mesh, normals, i);
    for (Index j = 0; j < n; ++j)
    {
      rows.block<3, 3>(3 * mesh.T.rows() + 3 * i, 3 * j) = L(i, j) * T;
    }
  }
  const double squared = detailWeight * detailWeight;
  const Eigen::MatrixXd A =
    rows.transpose() * rows + squared * Eigen::MatrixXd::Identity(3 * n, 3 * n);
  const Eigen::Map<const Vector> V(mesh.V.data(), 3 * n);
  const Vector solution = A.ldlt().solve(Vector(squared * V));
  return Eigen::Map<const Points>(solution.data(), n, 3);
}

/// Three rounds, the first with the whole width, the others with 0.4 of it.
Points Guided(const TestMesh& mesh, const GuideOptions& guide)
{
  TestMesh moved{ Smoothed(mesh, 0.75), mesh.T };
  for (const double share : { 1.0, 0.4, 0.4 })
  {
    const Points normals =
      FilteredNormals(moved, (guide.normalIterations + 1) / 2, share * guide.normalWidth);
    moved.V = Followed(mesh, normals, guide.detailWeight);
  }
  return moved.V;
}

/// A sphere that is not smooth and a pyramid with flat faces, edges and corners.
std::vector<std::pair<std::string, TestMesh>> NoisyMeshes()
{
  return { { "sphere", Irregular(Icosphere(1), 0.1) },
    { "double pyramid", Irregular(DoublePyramid(2), 0.03) } };
}

void CheckFilter(Checks& c)
{
  for (const auto& [name, mesh] : NoisyMeshes())
  {
    const MeshTopology topology = BuildTopology(static_cast<Index>(mesh.V.rows()), mesh.T);
    ProgressMonitor monitor;
    c.Error("normals are filtered as in the dense reference: " + name,
      MaximumDistance(
        FilterNormals(mesh.V, mesh.T, topology, 3, 0.4, monitor), FilteredNormals(mesh, 3, 0.4)),
      1e-12);
  }
}

void CheckRounds(Checks& c)
{
  for (const auto& [name, mesh] : NoisyMeshes())
  {
    OptimizerOptions options;
    options.mode = Mode::SMOOTH_GUIDED;
    options.guide.normalIterations = 5;
    options.guide.normalWidth = 0.4;
    options.solver.tolerance = 1e-12;
    const Points expected = Guided(mesh, options.guide);
    // The solutions before the last one have a tolerance of 1e-3.
    c.Error("guided smoothing is that of the dense reference: " + name,
      MaximumDistance(Run(mesh, options).positions, expected),
      0.01 * MaximumDistance(mesh.V, expected));
  }
}

/// The lateral surface of a cone with height 1 and radius 0.5, in rings of points.
TestMesh Cone(int around, int rings)
{
  TestMesh mesh;
  mesh.V.resize(1 + around * rings, 3);
  mesh.V.row(0) << 0, 0, 1;
  mesh.T.resize(around * (2 * rings - 1), 3);
  Eigen::Index t = 0;
  for (int ring = 1; ring <= rings; ++ring)
  {
    const auto point = [&](int of, int k)
    { return of == 0 ? 0 : 1 + (of - 1) * around + k % around; };
    for (int k = 0; k < around; ++k)
    {
      const double height = double(ring) / rings;
      const double angle = 2 * Pi * k / around;
      mesh.V.row(point(ring, k)) << 0.5 * height * std::cos(angle), 0.5 * height * std::sin(angle),
        1 - height;
      mesh.T.row(t++) << point(ring - 1, k), point(ring, k), point(ring, k + 1);
      if (ring > 1)
      {
        mesh.T.row(t++) << point(ring - 1, k), point(ring, k + 1), point(ring - 1, k + 1);
      }
    }
  }
  return mesh;
}

OptimizerOptions Guide()
{
  OptimizerOptions options;
  options.mode = Mode::SMOOTH_GUIDED;
  return options;
}

void CheckShapes(Checks& c)
{
  const OptimizerResult cube = Run(Cube(), Guide());
  c.Error(
    "a cube of twelve triangles keeps its volume", cube.comparison.relativeVolumeChange, 1e-3);
  c.Equal("none of its triangles turns over", cube.comparison.flippedTriangles, 0);

  TestMesh coarse = UvSphere(8, 6);
  coarse.T = coarse.T.rowwise().reverse().eval(); // faces inwards
  const OptimizerResult sphere = Run(coarse, Guide());
  c.Error(
    "a sphere that would shrink does not move", MaximumDistance(sphere.positions, coarse.V), 0);
  c.Equal("and is counted", sphere.unmovedComponents, 1);

  const OptimizerResult cone = Run(Cone(96, 4), Guide());
  c.AtLeast("of the thin triangles of a cone one in a hundred at most turns over",
    double(cone.comparison.triangles) / 100, double(cone.comparison.flippedTriangles));
}

void CheckComponents(Checks& c)
{
  const TestMesh noisy = Irregular(Icosphere(3), 0.03);
  const TestMesh both = Joined(noisy, Transformed(UvSphere(8, 6), 1, { 3, 0, 0 }));
  const Points alone = Run(noisy, Guide()).positions;
  const OptimizerResult result = Run(both, Guide());
  c.Error("a component that would shrink does not move",
    MaximumDistance(result.positions.bottomRows(both.V.rows() - noisy.V.rows()),
      both.V.bottomRows(both.V.rows() - noisy.V.rows())),
    0);
  c.Greater("another component is smoothed",
    MaximumDistance(noisy.V, result.positions.topRows(noisy.V.rows())),
    0.5 * MaximumDistance(noisy.V, alone));
}
}

int TestGuidedSmoothing(int argc, char* argv[])
{
  Groups groups(argc, argv);
  groups.Run("Filter", CheckFilter);
  groups.Run("Rounds", CheckRounds);
  groups.Run("Shapes", CheckShapes);
  groups.Run("Components", CheckComponents);
  return groups.Result();
}
