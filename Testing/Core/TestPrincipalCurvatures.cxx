// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "MeshMeasures.h"

#include "Core/Mesh/TriangleGeometry.h"
#include "Core/Operators/PrincipalCurvatures.h"

#include <Eigen/Eigenvalues>

#include <cmath>

using namespace lmo;

namespace
{
/// A surface F(x) = 0 with F > 0 outside, by the derivatives of F.
struct ImplicitSurface
{
  std::function<Vector3(const Vector3&)> gradient;
  std::function<Matrix3(const Vector3&)> hessian;
};

/// A surface and its sampling.
struct Sample
{
  std::string name;
  TestMesh mesh;
  ImplicitSurface exact;
};

PrincipalCurvatures Measure(const TestMesh& mesh)
{
  const MeshTopology topology = BuildTopology(static_cast<Index>(mesh.V.rows()), mesh.T);
  ProgressMonitor monitor;
  return ComputePrincipalCurvatures(mesh.V, VertexNormals(mesh.V, mesh.T, topology), topology,
    BoundingBoxDiagonal(mesh.V, topology), monitor);
}

/// The vertices of a grid moved at random by up to 0.35 of its edges and mapped to a surface; the
/// triangles as they are, or across the seams of a torus.
template <typename Map>
TestMesh Mapped(int cells, const Map& map)
{
  TestMesh mesh = Grid(cells, 0.35);
  for (auto v : mesh.V.rowwise())
  {
    v = map(v[0] / cells, v[1] / cells);
  }
  return mesh;
}

ImplicitSurface Quadric(const Vector3& squares)
{
  const Vector3 diagonal = 2 * squares;
  return { [=](const Vector3& x) { return Vector3(diagonal.cwiseProduct(x)); },
    [=](const Vector3&) { return Matrix3(diagonal.transpose().asDiagonal()); } };
}

/// z = a x y.
ImplicitSurface Saddle(double a)
{
  return { [=](const Vector3& x) { return Vector3(-a * x[1], -a * x[0], 1); },
    [=](const Vector3&)
    {
      Matrix3 hessian = Matrix3::Zero();
      hessian(0, 1) = hessian(1, 0) = -a;
      return hessian;
    } };
}

/// F = (sqrt(x^2 + y^2) - 1)^2 + z^2 - r^2.
ImplicitSurface Torus()
{
  return { [](const Vector3& x)
    {
      const double rho = std::hypot(x[0], x[1]);
      const double share = 2 * (rho - 1) / rho;
      return Vector3(share * x[0], share * x[1], 2 * x[2]);
    },
    [](const Vector3& x)
    {
      const double rho = std::hypot(x[0], x[1]);
      const double share = 2 * (rho - 1) / rho;
      const Eigen::Vector2d flat(x[0], x[1]);
      Matrix3 hessian = 2 * Matrix3::Identity();
      hessian.topLeftCorner<2, 2>() =
        share * Eigen::Matrix2d::Identity() + 2 / (rho * rho * rho) * flat * flat.transpose();
      return hessian;
    } };
}

Sample MakeTorus(int around, int along, double radius)
{
  TestMesh mesh{ Points(around * along, 3), Triangles(2 * around * along, 3) };
  Random random;
  for (int k = 0; k < around * along; ++k)
  {
    const int i = k / along, j = k % along;
    const int right = (i + 1) % around * along + j, up = i * along + (j + 1) % along;
    const int across = (i + 1) % around * along + (j + 1) % along;
    const double azimuth = 2 * Pi * (i + 0.35 * random()) / around;
    const double turn = 2 * Pi * (j + 0.35 * random()) / along;
    const double rho = 1 + radius * std::cos(turn);
    mesh.V.row(k) << rho * std::cos(azimuth), rho * std::sin(azimuth), radius * std::sin(turn);
    const bool isRising = random() > 0;
    mesh.T.row(2 * k) << k, right, isRising ? across : up;
    mesh.T.row(2 * k + 1) << (isRising ? k : right), across, up;
  }
  return { "torus", mesh, Torus() };
}

std::vector<Sample> Samples()
{
  TestMesh ellipsoid = Irregular(Icosphere(5), 0.012);
  ellipsoid.V = ellipsoid.V.rowwise().normalized() * Vector3(1.5, 1, 0.8).asDiagonal();
  return { MakeTorus(150, 67, 0.4),
    { "cylinder",
      Mapped(
        100, [](double u, double v) { return Vector3(std::cos(3 * u), std::sin(3 * u), 3 * v); }),
      Quadric({ 1, 1, 0 }) },
    { "saddle",
      Mapped(100, [](double u, double v)
        { return Vector3(2 * u - 1, 2 * v - 1, 0.8 * (2 * u - 1) * (2 * v - 1)); }),
      Saddle(0.8) },
    { "ellipsoid", ellipsoid, Quadric(Vector3(1.5, 1, 0.8).cwiseAbs2().cwiseInverse()) } };
}

/// Errors of one vertex.
struct Errors
{
  double curvature = 0; ///< over the larger principal curvature
  double direction = 0; ///< degrees, where the curvatures differ by a tenth of the larger
};

double DegreesBetween(const Vector3& a, const Vector3& b)
{
  return std::atan2(a.cross(b).norm(), std::abs(a.dot(b))) * 180 / Pi;
}

Errors ErrorsAt(
  const Vector3& x, const ImplicitSurface& exact, const PrincipalCurvatures& found, Index i)
{
  const Vector3 gradient = exact.gradient(x);
  const Vector3 normal = gradient.normalized();
  const Matrix3 plane = Matrix3::Identity() - normal.transpose() * normal;
  // The normal gets an eigenvalue that is larger than all curvatures.
  const Matrix3 shape = plane * exact.hessian(x) * plane / gradient.norm();
  const double beyond = 1 + 10 * shape.norm();
  const Eigen::SelfAdjointEigenSolver<Matrix3> solver(shape + beyond * normal.transpose() * normal);
  const double k1 = solver.eigenvalues()[1], k2 = solver.eigenvalues()[0];
  const double largest = std::max(std::abs(k1), std::abs(k2));
  Errors errors;
  errors.curvature =
    Larger(std::abs(found.first[i] - k1), std::abs(found.second[i] - k2)) / largest;
  if (k1 - k2 > 0.1 * largest)
  {
    errors.direction =
      Larger(DegreesBetween(found.firstDirections.row(i), solver.eigenvectors().col(1).transpose()),
        DegreesBetween(found.secondDirections.row(i), solver.eigenvectors().col(0).transpose()));
  }
  return errors;
}

Errors Add(const Errors& a, const Errors& b)
{
  return { Larger(a.curvature, b.curvature), Larger(a.direction, b.direction) };
}

void CheckAnalyticSurfaces(Checks& c)
{
  for (const Sample& sample : Samples())
  {
    const PrincipalCurvatures found = Measure(sample.mesh);
    const std::vector<bool> isBoundary = BoundaryVertices(sample.mesh);
    Errors inside, boundary;
    for (Index i = 0; i < found.first.size(); ++i)
    {
      Errors& errors = isBoundary[i] ? boundary : inside;
      errors = Add(errors, ErrorsAt(sample.mesh.V.row(i), sample.exact, found, i));
    }
    const std::string where = ": " + sample.name;
    c.Error("principal curvatures are exact to 1 %" + where, inside.curvature, 0.01);
    c.Error("principal directions are exact to 2 degrees" + where, inside.direction, 2);
    c.Error(
      "principal curvatures at the boundary are exact to 5 %" + where, boundary.curvature, 0.05);
    c.Error(
      "principal directions at the boundary are exact to 5 degrees" + where, boundary.direction, 5);
  }
}
}

int TestPrincipalCurvatures(int argc, char* argv[])
{
  Groups groups(argc, argv);
  groups.Run("AnalyticSurfaces", CheckAnalyticSurfaces);
  return groups.Result();
}
