// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CurvedSurfaces.h"

#include "Core/Mesh/TriangleGeometry.h"

#include <Eigen/Eigenvalues>

#include <cmath>

using namespace lmo;

namespace
{
/// The vertices of a grid moved at random by up to 0.35 of its edges and mapped to a surface.
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
ImplicitSurface ImplicitTorus()
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
}

NormalCurvatures CurvaturesAt(const ImplicitSurface& surface, const Vector3& x)
{
  const Vector3 gradient = surface.gradient(x);
  const Vector3 normal = gradient.normalized();
  const Matrix3 plane = Matrix3::Identity() - normal.transpose() * normal;
  const Matrix3 shape = plane * surface.hessian(x) * plane / gradient.norm();
  // The normal gets an eigenvalue that is larger than all curvatures.
  const double beyond = 1 + 10 * shape.norm();
  const Eigen::SelfAdjointEigenSolver<Matrix3> solver(shape + beyond * normal.transpose() * normal);
  return { solver.eigenvalues()[1], solver.eigenvalues()[0],
    solver.eigenvectors().col(1).transpose(), solver.eigenvectors().col(0).transpose() };
}

TestMesh Torus(int around, int along, double jitter)
{
  TestMesh mesh{ Points(around * along, 3), Triangles(2 * around * along, 3) };
  Random random;
  for (int k = 0; k < around * along; ++k)
  {
    const int i = k / along, j = k % along;
    const int next = (i + 1) % around * along;
    const int right = next + j, up = i * along + (j + 1) % along, across = next + (j + 1) % along;
    const double azimuth = 2 * Pi * (i + jitter * random()) / around;
    const double turn = 2 * Pi * (j + jitter * random()) / along;
    const double rho = 1 + 0.4 * std::cos(turn);
    mesh.V.row(k) << rho * std::cos(azimuth), rho * std::sin(azimuth), 0.4 * std::sin(turn);
    const bool isRising = jitter == 0 || random() > 0;
    mesh.T.row(2 * k) << k, right, isRising ? across : up;
    mesh.T.row(2 * k + 1) << (isRising ? k : right), across, up;
  }
  return mesh;
}

SampledSurface SampledTorus(int around, int along)
{
  return { "torus", Torus(around, along, 0.35), ImplicitTorus() };
}

std::vector<SampledSurface> SampledSurfaces()
{
  const Vector3 axes(1.5, 1, 0.8);
  TestMesh ellipsoid = Irregular(Icosphere(5), 0.012);
  ellipsoid.V = ellipsoid.V.rowwise().normalized() * axes.asDiagonal();
  const TestMesh cylinder = Mapped(
    100, [](double u, double v) { return Vector3(std::cos(3 * u), std::sin(3 * u), 3 * v); });
  const TestMesh saddle = Mapped(100, [](double u, double v)
    { return Vector3(2 * u - 1, 2 * v - 1, 0.8 * (2 * u - 1) * (2 * v - 1)); });
  return { SampledTorus(150, 67), { "cylinder", cylinder, Quadric({ 1, 1, 0 }) },
    { "saddle", saddle, Saddle(0.8) },
    { "ellipsoid", ellipsoid, Quadric(axes.cwiseAbs2().cwiseInverse()) } };
}
