// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "MeshMeasures.h"

#include "Core/Mesh/TriangleQuality.h"

#include <cmath>

using namespace lmo;

namespace
{
struct Corners
{
  Vector3 a;
  Vector3 b;
  Vector3 c;
};

double RatioError(const Corners& corners, double scale, double expected)
{
  return std::abs(RadiusRatio(scale * corners.a, scale * corners.b, scale * corners.c) - expected);
}

void CheckKnownValues(Checks& c)
{
  const Points V = EquilateralTriangle().V;
  const Corners equilateral{ V.row(0), V.row(1), V.row(2) };
  const Corners isosceles{ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } };
  const Corners pythagorean{ { 0, 0, 0 }, { 3, 0, 0 }, { 0, 0, 4 } };
  const Corners collinear{ { 0, 0, 0 }, { 1, 2, 3 }, { 3, 6, 9 } };
  const Corners flat{ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 } };
  const Corners coincident{ { 1, 2, 3 }, { 1, 2, 3 }, { 4, 5, 6 } };
  const Corners point{ { 1, 2, 3 }, { 1, 2, 3 }, { 1, 2, 3 } };
  for (const double scale : { 1.0, 1e-20, 1e20, 1e-150, 1e150 })
  {
    const std::string unit = " in units of " + std::to_string(std::log10(scale));
    c.Error("t of an equilateral triangle is 1" + unit, RatioError(equilateral, scale, 1), 1e-15);
    c.Error("t of a right isosceles triangle is 2 (sqrt 2 - 1)" + unit,
      RatioError(isosceles, scale, 2 * (std::sqrt(2) - 1)), 1e-15);
    // Radii 1 and 5/2.
    c.Error("t of the triangle 3-4-5 is 0.8" + unit, RatioError(pythagorean, scale, 0.8), 1e-15);
    c.Error("t of collinear points is 0" + unit, RatioError(collinear, scale, 0), 1e-30);
    c.Error("t of points on an axis is 0" + unit, RatioError(flat, scale, 0), 0);
    c.Error("t of two equal points is 0" + unit, RatioError(coincident, scale, 0), 0);
    c.Error("t of three equal points is 0" + unit, RatioError(point, scale, 0), 0);
  }
}

void CheckRange(Checks& c)
{
  const TestMesh mesh = Irregular(Icosphere(3), 0.2);
  const Vector ratios = RadiusRatios(mesh.V, mesh.T);
  c.True("t is between 0 and 1", ratios.minCoeff() >= 0 && ratios.maxCoeff() <= 1);
  double difference = 0;
  for (Eigen::Index t = 0; t < mesh.T.rows(); ++t)
  {
    const Vector3 a = mesh.V.row(mesh.T(t, 0)), b = mesh.V.row(mesh.T(t, 1)),
                  c = mesh.V.row(mesh.T(t, 2));
    difference = Larger(difference, std::abs(RadiusRatio(b, c, a) - ratios[t]));
    difference = Larger(difference, std::abs(RadiusRatio(b, a, c) - ratios[t]));
  }
  double largest = 0;
  const Points corners = Random().Displacements(1000);
  for (const auto& x : corners.rowwise())
  {
    largest = Larger(largest, RadiusRatio(x, { x[1], x[2], x[0] }, { x[2], x[0], x[1] }));
  }
  c.AtMost("t of equilateral triangles is never above 1", largest, 1);
  c.Error("t does not depend on the order of the corners", difference, 1e-14);
}

void CheckSummaries(Checks& c)
{
  Triangles triangles(3, 3);
  triangles << 0, 1, 2, 0, 2, 3, 0, 3, 1;
  const Vector ratios = Eigen::Vector3d(0.5, 0.25, 0.75);
  Vector expected(5);
  expected << 0.25, 0.5, 0.25, 0.25, -1;
  c.Error("W_t is the minimum over the triangles at a vertex, -1 where there are none",
    LargestMagnitude(MinimumAtVertices(ratios, triangles, 5) - expected), 0);

  Points V(5, 3);
  V << 0, 0, 0, 3, 0, 0, 0, 4, 0, 0, 0, 0, 9, 9, 9;
  Triangles pair(2, 3);
  pair << 0, 1, 2, 0, 1, 3; // t = 0.8 and 0
  const MeshQuality quality = MeasureQuality(V, pair);
  c.Error("t_mean is the mean", std::abs(quality.mean - 0.4), 1e-15);
  c.Error("t_min is the minimum", std::abs(quality.minimum), 0);
  const MeshQuality none = MeasureQuality(V, Triangles(0, 3));
  c.True("no triangles have t_mean and t_min -1", none.mean == -1 && none.minimum == -1);
}
}

int TestQuality(int argc, char* argv[])
{
  Groups groups(argc, argv);
  groups.Run("KnownValues", CheckKnownValues);
  groups.Run("Range", CheckRange);
  groups.Run("Summaries", CheckSummaries);
  return groups.Result();
}
