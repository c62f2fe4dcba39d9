// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CadFixtures.h"
#include "Checks.h"
#include "CurvedSurfaces.h"
#include "MeshMeasures.h"

#include "Core/Mesh/TriangleGeometry.h"
#include "Core/Operators/PrincipalCurvatures.h"

#include <cmath>

using namespace lmo;

namespace
{
/// With these vertex normals.
PrincipalCurvatures Measure(const TestMesh& mesh, const Points& normals)
{
  const MeshTopology topology = BuildTopology(static_cast<Index>(mesh.V.rows()), mesh.T);
  ProgressMonitor monitor;
  return ComputePrincipalCurvatures(
    mesh.V, normals, topology, BoundingBoxDiagonal(mesh.V, topology), monitor);
}

PrincipalCurvatures Measure(const TestMesh& mesh)
{
  const MeshTopology topology = BuildTopology(static_cast<Index>(mesh.V.rows()), mesh.T);
  return Measure(mesh, VertexNormals(mesh.V, mesh.T, topology));
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
  const NormalCurvatures expected = CurvaturesAt(exact, x);
  const double largest = std::max(std::abs(expected.k1), std::abs(expected.k2));
  Errors errors;
  errors.curvature =
    Larger(std::abs(found.first[i] - expected.k1), std::abs(found.second[i] - expected.k2)) /
    largest;
  if (expected.k1 - expected.k2 > 0.1 * largest)
  {
    errors.direction = Larger(DegreesBetween(found.firstDirections.row(i), expected.direction1),
      DegreesBetween(found.secondDirections.row(i), expected.direction2));
  }
  return errors;
}

Errors Add(const Errors& a, const Errors& b)
{
  return { Larger(a.curvature, b.curvature), Larger(a.direction, b.direction) };
}

/// The largest errors inside the surface, and those on its boundary.
struct SurfaceErrors
{
  Errors inside;
  Errors boundary;
};

SurfaceErrors ErrorsOf(const SampledSurface& sample)
{
  const PrincipalCurvatures found = Measure(sample.mesh);
  const std::vector<bool> isBoundary = BoundaryVertices(sample.mesh);
  SurfaceErrors result;
  for (Index i = 0; i < found.first.size(); ++i)
  {
    Errors& errors = isBoundary[i] ? result.boundary : result.inside;
    errors = Add(errors, ErrorsAt(sample.mesh.V.row(i), sample.exact, found, i));
  }
  return result;
}

void CheckAnalyticSurfaces(Checks& c)
{
  for (const SampledSurface& sample : SampledSurfaces())
  {
    const SurfaceErrors errors = ErrorsOf(sample);
    const std::string where = ": " + sample.name;
    c.Error("principal curvatures are exact to 1 %" + where, errors.inside.curvature, 0.01);
    c.Error("principal directions are exact to 2 degrees" + where, errors.inside.direction, 2);
    c.Error("those at the boundary too: curvatures" + where, errors.boundary.curvature, 0.01);
    c.Error("those at the boundary too: directions" + where, errors.boundary.direction, 2);
  }
}

void CheckConvergence(Checks& c)
{
  const double coarse = ErrorsOf(SampledTorus(75, 33)).inside.curvature;
  const double fine = ErrorsOf(SampledTorus(150, 66)).inside.curvature;
  c.Less("half the edge length, less than a fourth of the error", fine, coarse / 4);
}

void CheckHandDerivedValues(Checks& c)
{
  // At the outer equator of the torus, 1 / r along the tube and 1 / (1 + r) along the equator; at
  // the inner one, 1 / r and -1 / (1 - r).
  SampledSurface torus = SampledTorus(150, 66);
  torus.mesh.V.row(0) << 1.4, 0, 0;
  torus.mesh.V.row(33) << 0.6, 0, 0;
  const PrincipalCurvatures found = Measure(torus.mesh);
  c.Error("the outer equator of a torus is convex",
    std::abs(found.first[0] - 2.5) + std::abs(found.second[0] - 1 / 1.4), 0.01);
  c.Error("the inner equator of a torus is a saddle",
    std::abs(found.first[33] - 2.5) + std::abs(found.second[33] + 1 / 0.6), 0.01);
  for (const Index i : { 0, 33 })
  {
    c.Error("the first direction is upward, along the tube",
      (found.firstDirections.row(i) - Vector3(0, 0, 1)).norm(), 0.002);
    c.Error("the second direction is along the equator, right-handed",
      (found.secondDirections.row(i) - Vector3(0, i == 0 ? -1 : 1, 0)).norm(), 0.002);
  }
}

void CheckUmbilics(Checks& c)
{
  for (const double radius : { 1e-60, 1.0, 1e60 })
  {
    const TestMesh sphere = Icosphere(3, radius);
    const PrincipalCurvatures found = Measure(sphere);
    const std::string where = ", radius " + AsText(radius);
    c.Error("both curvatures of a sphere are 1 / R" + where,
      Larger(LargestMagnitude(found.first.array() * radius - 1),
        LargestMagnitude(found.second.array() * radius - 1)),
      0.005);
    c.Error("directions on a sphere are tangent" + where,
      LargestMagnitude(found.firstDirections.cwiseProduct(sphere.V / radius).rowwise().sum()),
      0.002);
  }
  const PrincipalCurvatures plane = Measure(Grid(10, 0.3));
  c.Error(
    "a plane has no curvature", LargestMagnitude(plane.first) + LargestMagnitude(plane.second), 0);
  TestMesh tilted = Grid(10, 0.3);
  tilted.V.col(2) = 0.3 * tilted.V.col(0) + 0.7 * tilted.V.col(1);
  const PrincipalCurvatures slope = Measure(tilted);
  c.Error("a tilted plane has none either", LargestMagnitude(slope.first), 0);
  c.Error("directions on a plane are in it",
    LargestMagnitude(plane.firstDirections.rowwise().norm().array() - 1) +
      LargestMagnitude(plane.firstDirections.col(2)),
    1e-12);
}

/// Largest difference of a direction from another, or from its opposite.
double LargestAngle(const Points& a, const Points& b)
{
  double largest = 0;
  for (Eigen::Index i = 0; i < a.rows(); ++i)
  {
    largest = Larger(largest, DegreesBetween(a.row(i), b.row(i)));
  }
  return largest;
}

void CheckEquivariance(Checks& c)
{
  const TestMesh mesh = SampledSurfaces()[2].mesh;
  const PrincipalCurvatures before = Measure(mesh);
  TestMesh moved = mesh;
  const Eigen::AngleAxisd turn(1, Eigen::Vector3d(1, 2, 3).normalized());
  moved.V =
    ((3 * mesh.V * turn.toRotationMatrix().transpose()).rowwise() + Vector3(5, -7, 2)).eval();
  const PrincipalCurvatures after = Measure(moved);
  c.Error("curvatures are an inverse length and do not depend on the place",
    LargestMagnitude(3 * after.first - before.first), 1e-8);
  c.Error("directions turn with the surface",
    LargestAngle(
      after.firstDirections, before.firstDirections * turn.toRotationMatrix().transpose()),
    1e-4);

  TestMesh reversed = mesh;
  reversed.T.col(0).swap(reversed.T.col(1));
  const PrincipalCurvatures inside = Measure(reversed);
  c.Error("curvatures change their signs and places with the orientation",
    LargestMagnitude(inside.first + before.second) + LargestMagnitude(inside.second + before.first),
    1e-8);
  c.Error("directions change their places with the orientation",
    LargestAngle(inside.firstDirections, before.secondDirections), 1e-4);
}

void CheckNormals(Checks& c)
{
  const SampledSurface saddle = SampledSurfaces()[2];
  const MeshTopology topology =
    BuildTopology(static_cast<Index>(saddle.mesh.V.rows()), saddle.mesh.T);
  const Eigen::AngleAxisd tilt(0.3, Eigen::Vector3d(1, 1, 0).normalized());
  const Points tilted =
    VertexNormals(saddle.mesh.V, saddle.mesh.T, topology) * tilt.toRotationMatrix();
  const PrincipalCurvatures found = Measure(saddle.mesh, tilted);
  Errors errors;
  for (Index i = 0; i < found.first.size(); ++i)
  {
    errors = Add(errors, ErrorsAt(saddle.mesh.V.row(i), saddle.exact, found, i));
  }
  c.Error("normals that are off by 17 degrees do no harm: curvatures", errors.curvature, 0.01);
  c.Error("normals that are off by 17 degrees do no harm: directions", errors.direction, 2);
  const Points undefined = Points::Zero(tilted.rows(), 3);
  c.Error("without normals there are no curvatures",
    LargestMagnitude(Measure(saddle.mesh, undefined).first), 0);
}

/// Violation of what holds at every vertex: finite values, k1 >= k2, and directions of length 1
/// that are perpendicular, or all 0.
double Fault(const PrincipalCurvatures& found, Index i)
{
  const Vector3 first = found.firstDirections.row(i), second = found.secondDirections.row(i);
  const double values = std::abs(found.first[i]) + std::abs(found.second[i]);
  const double fault =
    first.isZero(0) ? values + second.norm()
                    : std::max(0.0, found.second[i] - found.first[i]) + std::abs(first.norm() - 1) +
                        std::abs(second.norm() - 1) + std::abs(first.dot(second)) + 0 * values;
  return fault;
}

void CheckAnyMesh(Checks& c)
{
  auto meshes = AllTestMeshes();
  meshes.push_back({ "thin triangles", WithThinTriangles(Icosphere(3)) });
  meshes.push_back({ "equal points", Transformed(Icosphere(2), 0) });
  meshes.push_back({ "needles", LongTriangles() });
  meshes.push_back({ "a line", Grid(5, 0) });
  meshes.back().second.V.rightCols(2).setZero();
  for (const auto& [name, mesh] : meshes)
  {
    const PrincipalCurvatures found = Measure(mesh);
    double fault = 0;
    for (Index i = 0; i < found.first.size(); ++i)
    {
      fault = Larger(fault, Fault(found, i));
    }
    c.Error(
      "curvatures are finite and in order, directions orthonormal or 0: " + name, fault, 1e-12);
  }
  c.Error("an unused point has no curvature",
    std::abs(Measure(WithIsolatedPoint(Icosphere(2))).first[0]), 0);
  for (const TestMesh& few : { EquilateralTriangle(), Tetrahedron(), Cube() })
  {
    c.Error("too few points have no curvature", LargestMagnitude(Measure(few).first), 0);
  }
  TestMesh line = Grid(5, 0);
  line.V.rightCols(2).setZero();
  const PrincipalCurvatures ofLine = Measure(line, Vector3(0, 0, 1).replicate(line.V.rows(), 1));
  c.Error("points on a line have no curvature",
    LargestMagnitude(ofLine.first) + LargestMagnitude(ofLine.firstDirections), 0);
  TestMesh tube = Bar(24, 5, Cap::FAN);
  tube.T = tube.T.topRows(48).eval();
  const PrincipalCurvatures ofTube = Measure(tube);
  c.Error("points on two rims do not determine a curvature between them",
    LargestMagnitude(ofTube.first) + LargestMagnitude(ofTube.firstDirections), 0);
  c.Greater("twelve points of a sphere are convex", Measure(Icosphere(0)).second.minCoeff(), 0.5);
}

void CheckHighValence(Checks& c)
{
  for (const int meridians : { 200, 4000 })
  {
    const PrincipalCurvatures found = Measure(UvSphere(meridians, 29));
    const std::string where = ", meridians: " + std::to_string(meridians);
    const double error = LargestMagnitude(found.first.tail(2).array() - 1) +
                         LargestMagnitude(found.second.tail(2).array() - 1);
    c.Error("the poles of a globe are exact to 1 %" + where, error, 0.01);
    c.True("its curvatures are finite" + where, found.second.allFinite());
  }
  const PrincipalCurvatures found = Measure(UvSphere(200, 99));
  c.Error("beside the poles too",
    LargestMagnitude(found.first.array() - 1) + LargestMagnitude(found.second.array() - 1), 0.01);
}
}

int TestPrincipalCurvatures(int argc, char* argv[])
{
  Groups groups(argc, argv);
  groups.Run("AnalyticSurfaces", CheckAnalyticSurfaces);
  groups.Run("Convergence", CheckConvergence);
  groups.Run("HandDerivedValues", CheckHandDerivedValues);
  groups.Run("Umbilics", CheckUmbilics);
  groups.Run("Equivariance", CheckEquivariance);
  groups.Run("Normals", CheckNormals);
  groups.Run("AnyMesh", CheckAnyMesh);
  groups.Run("HighValence", CheckHighValence);
  return groups.Result();
}
