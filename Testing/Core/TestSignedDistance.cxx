// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CadFixtures.h"
#include "Checks.h"
#include "CurvedSurfaces.h"
#include "MeshMeasures.h"

#include "Core/Deviation/SignedDistance.h"
#include "Core/Deviation/SurfaceDistance.h"
#include "Core/Mesh/TriangleGeometry.h"

#include <cmath>

using namespace lmo;

namespace
{
/// Nothing if the reference has no inside.
std::optional<Vector> Measure(const Points& points, const TestMesh& reference)
{
  ProgressMonitor monitor;
  const TestMesh surface{ points, EquilateralTriangle().T };
  const SurfaceDistance distance =
    MeasureSurfaceDistance(surface.V, surface.T, reference.V, reference.T, 1, monitor);
  return SignedDistances(
    points, distance.atVertices, distance.closestTriangles, reference.V, reference.T, monitor);
}

/// Random points in a box that is larger than the body by half.
Points PointsAround(const TestMesh& body, Index count)
{
  const Vector3 low = body.V.colwise().minCoeff(), high = body.V.colwise().maxCoeff();
  Points points = Random().Displacements(count) * (0.75 * (high - low)).asDiagonal();
  points.rowwise() += (low + high) / 2;
  return points;
}

/// Random points close to the vertices and the middles of the edges, to which these are often the
/// closest points of the body.
Points PointsAtEdges(const TestMesh& body, double distance)
{
  Points points(6 * body.T.rows(), 3);
  for (Eigen::Index t = 0; t < body.T.rows(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Vector3 from = body.V.row(body.T(t, k)), to = body.V.row(body.T(t, (k + 1) % 3));
      points.row(6 * t + 2 * k) = from;
      points.row(6 * t + 2 * k + 1) = (from + to) / 2;
    }
  }
  return points + distance * Random().Displacements(points.rows());
}

/// Solid angle of the surface seen from x, over 4 pi: 1 inside and 0 outside (van Oosterom and
/// Strackee 1983).
double WindingNumber(const Vector3& x, const TestMesh& body)
{
  double angle = 0;
  for (const auto& T : body.T.rowwise())
  {
    const Vector3 a = body.V.row(T[0]) - x, b = body.V.row(T[1]) - x, c = body.V.row(T[2]) - x;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    angle += 2 * std::atan2(
                   a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return angle / (4 * Pi);
}

/// Sphere, torus and box by their distance functions.
double ToSphere(const Vector3& x)
{
  return x.norm() - 1;
}

double ToTorus(const Vector3& x)
{
  return std::hypot(std::hypot(x[0], x[1]) - 1, x[2]) - 0.4;
}

double ToBox(const Vector3& x)
{
  const Vector3 beyond = (x.array() - 0.5).abs() - 0.5;
  return beyond.cwiseMax(0).norm() + std::min(beyond.maxCoeff(), 0.0);
}

void CheckAnalytic(Checks& c, const std::string& name, const TestMesh& body,
  double (*exact)(const Vector3&), double bound)
{
  for (const Points& points : { PointsAround(body, 3000), PointsAtEdges(body, 0.3) })
  {
    const auto found = Measure(points, body);
    double error = found ? 0 : 1;
    for (Eigen::Index i = 0; found && i < points.rows(); ++i)
    {
      error = Larger(error, std::abs((*found)[i] - exact(points.row(i))));
    }
    c.Error("the signed distance is that of a " + name, error, bound);
  }
}

void CheckAnalyticBodies(Checks& c)
{
  CheckAnalytic(c, "sphere", Icosphere(5), ToSphere, 1e-3);
  CheckAnalytic(c, "torus", Torus(150, 60, 0), ToTorus, 2e-3);
  CheckAnalytic(c, "box", Cube(), ToBox, 1e-14);
  CheckAnalytic(c, "box of small triangles", Cube(3), ToBox, 1e-14);
}

std::vector<std::pair<std::string, TestMesh>> Bodies()
{
  TestMesh splinter = Tetrahedron();
  splinter.V.col(2) *= 0.05;
  TestMesh hollow = Cube();
  const TestMesh ball = Transformed(Icosphere(2), 0.3, { 0.5, 0.5, 0.5 });
  hollow.V.conservativeResize(8 + ball.V.rows(), 3);
  hollow.V.bottomRows(ball.V.rows()) = ball.V;
  hollow.T.conservativeResize(12 + ball.T.rows(), 3);
  hollow.T.bottomRows(ball.T.rows()) = ball.T.rowwise().reverse().array() + 8;
  return { { "L", ExtrudedProfile(
                    { { -1, -1 }, { 2, -1 }, { 2, 1 }, { 1, 1 }, { 1, 2 }, { -1, 2 } }, 1) },
    { "star", ExtrudedProfile({ { 3, 0 }, { 0.4, 0.4 }, { 0, 3 }, { -0.4, 0.4 }, { -3, 0 },
                                { -0.4, -0.4 }, { 0, -3 }, { 0.4, -0.4 } },
                0.2) },
    { "tetrahedron", Tetrahedron() }, { "splinter", splinter },
    { "double pyramid", DoublePyramid(0) }, { "rough sphere", Irregular(Icosphere(2), 0.1) },
    { "box with a hollow", hollow }, { "plate with holes", PlateWithHoles(2, 1, 12, 0.8, 0.5) } };
}

void CheckAgainstWindingNumber(Checks& c)
{
  for (const auto& [name, body] : Bodies())
  {
    for (const Points& points :
      { PointsAround(body, 2000), PointsAtEdges(body, 0.3), PointsAtEdges(body, 1e-6) })
    {
      const auto found = Measure(points, body);
      double error = found ? 0 : 1;
      int wrong = 0;
      for (Eigen::Index i = 0; found && i < points.rows(); ++i)
      {
        wrong += ((*found)[i] < 0) != (WindingNumber(points.row(i), body) > 0.5);
        error =
          Larger(error, std::abs(std::abs((*found)[i]) - DistanceToSurface(points.row(i), body)));
      }
      c.Equal("points where the surface winds around once are inside: " + name, wrong, 0);
      c.Error("the magnitude is the distance: " + name, error, 1e-14);
    }
  }
}

void CheckOrientation(Checks& c)
{
  const Points points = PointsAround(Cube(), 100);
  TestMesh reversed = Cube();
  reversed.T.col(0).swap(reversed.T.col(1));
  c.Error("the inside of a body inside out is the same",
    LargestMagnitude(*Measure(points, Cube()) - *Measure(points, reversed)), 1e-15);
  TestMesh turned = Cube();
  std::swap(turned.T(0, 0), turned.T(0, 1));
  c.True("one triangle that is turned over: no inside", !Measure(points, turned));
  c.True("an open surface: no inside", !Measure(points, HalfSphere(2)));
  TestMesh doubled = Cube();
  doubled.T.conservativeResize(24, 3);
  doubled.T.bottomRows(12) = doubled.T.topRows(12).eval();
  c.True("edges of four triangles: no inside", !Measure(points, doubled));
  c.True("a triangle that names a vertex twice does not count",
    Measure(points, WithTriangle(Cube(), 1, 1, 2)).has_value());
  const double onSurface = LargestMagnitude(*Measure(Cube(2).V, Cube()));
  c.Error("the surface itself has no distance", onSurface, 1e-15);
}
}

int TestSignedDistance(int argc, char* argv[])
{
  Groups groups(argc, argv);
  groups.Run("AnalyticBodies", CheckAnalyticBodies);
  groups.Run("AgainstWindingNumber", CheckAgainstWindingNumber);
  groups.Run("Orientation", CheckOrientation);
  return groups.Result();
}
