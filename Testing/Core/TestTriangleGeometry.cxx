// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "MeshMeasures.h"
#include "OperatorFixtures.h"

#include "Core/Mesh/TriangleGeometry.h"

#include <cmath>

using namespace lmo;

namespace
{
const double Pi = std::acos(-1.0);

TestMesh Triangle(const Vector3& a, const Vector3& b, const Vector3& c)
{
  TestMesh mesh = EquilateralTriangle();
  mesh.V << a, b, c;
  return mesh;
}

double CotangentError(const TestMesh& triangle, const Vector3& expected)
{
  return LargestMagnitude(Cotangents(triangle.V, triangle.T).row(0) - expected);
}

double VoronoiAreaError(const TestMesh& mesh, const Vector& expected)
{
  return LargestMagnitude(OperatorFixtures(mesh).voronoiAreas - expected);
}

double VoronoiSumError(const TestMesh& mesh)
{
  return std::abs(OperatorFixtures(mesh).voronoiAreas.sum() / SurfaceArea(mesh) - 1);
}

Vector Defects(const TestMesh& mesh)
{
  return AngleDefects(mesh.V, mesh.T, *OperatorFixtures(mesh).topology);
}

Points Normals(const TestMesh& mesh)
{
  return VertexNormals(mesh.V, mesh.T, *OperatorFixtures(mesh).topology);
}

double Volume(const TestMesh& mesh)
{
  return EnclosedVolume(mesh.V, mesh.T);
}

double SphereVolumeError(int level)
{
  return std::abs(Volume(Icosphere(level)) / (4 * Pi / 3) - 1);
}

TestMesh InsideOut(TestMesh mesh)
{
  mesh.T.col(1).swap(mesh.T.col(2));
  return mesh;
}

double Diagonal(const TestMesh& mesh)
{
  return BoundingBoxDiagonal(mesh.V, *OperatorFixtures(mesh).topology);
}

void CheckCotangents(Checks& c)
{
  const double root3 = std::sqrt(3);
  const TestMesh right = Triangle({ 0, 0, 0 }, { 4, 0, 0 }, { 0, 3, 0 });
  const TestMesh obtuse = Triangle({ 0, 1, 0 }, { -root3, 0, 0 }, { root3, 0, 0 });
  const TestMesh needle = Triangle({ 0, 0, 0 }, { 1, 0, 0 }, { 1, 1e-9, 0 });
  const TestMesh line = Triangle({ 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 });
  c.Error("cotangents of 60 degrees are 1 / sqrt 3",
    CotangentError(EquilateralTriangle(), Vector3::Constant(1 / root3)), 1e-15);
  c.Error("cotangents of the triangle 3-4-5 are 0, 4/3, 3/4",
    CotangentError(right, { 0, 4.0 / 3, 3.0 / 4 }), 1e-15);
  c.Error("the cotangent of 120 degrees is -1 / sqrt 3",
    CotangentError(obtuse, { -1 / root3, root3, root3 }), 1e-15);
  c.Error("cotangents do not depend on the unit",
    CotangentError(Transformed(right, 1e-8), { 0, 4.0 / 3, 3.0 / 4 }), 1e-15);
  c.Error("cotangents are at most 1e6", CotangentError(needle, { 1e6, 0, 1e-9 }), 1e-15);
  c.Error("cotangents of a triangle without area are 0", CotangentError(line, { 0, 0, 0 }), 0);
}

void CheckVoronoiAreas(Checks& c)
{
  c.Error("an equilateral triangle gives each corner a third",
    VoronoiAreaError(EquilateralTriangle(), Vector::Constant(3, std::sqrt(3) / 12)), 1e-15);
  // The circumcentre is (1, 3/4).
  c.Error("an acute triangle is cut at its circumcentre",
    VoronoiAreaError(
      Triangle({ 0, 0, 0 }, { 2, 0, 0 }, { 1, 2, 0 }), Vector3(11.0 / 16, 11.0 / 16, 5.0 / 8)),
    1e-15);
  c.Error("a right triangle gives half to the right angle",
    VoronoiAreaError(Triangle({ 0, 0, 0 }, { 4, 0, 0 }, { 0, 3, 0 }), Vector3(3, 1.5, 1.5)), 1e-14);
  c.Error("an obtuse triangle gives half to the obtuse angle",
    VoronoiAreaError(Triangle({ 0, 1, 0 }, { -2, 0, 0 }, { 2, 0, 0 }), Vector3(1, 0.5, 0.5)),
    1e-15);
  c.Error(
    "a corner of the cube has 3/4", VoronoiAreaError(Cube(), Vector::Constant(8, 0.75)), 1e-15);
  for (const auto& [name, mesh] : AllTestMeshes())
  {
    c.Error("Voronoi areas sum to the surface's area: " + name, VoronoiSumError(mesh), 1e-13);
  }
}

void CheckAngleDefects(Checks& c)
{
  c.Error("a corner of the cube lacks a right angle",
    LargestMagnitude(Defects(Cube()).array() - Pi / 2), 1e-14);
  c.Error(
    "angle defects of a sphere sum to 4 pi", std::abs(Defects(Icosphere(3)).sum() - 4 * Pi), 1e-11);
  c.Error("angle defects of two components sum to 8 pi",
    std::abs(Defects(TwoComponents()).sum() - 8 * Pi), 1e-12);
  c.Error(
    "an isolated point has no angle defect", std::abs(Defects(WithIsolatedPoint(Cube()))[0]), 0);
  // Each boundary vertex of a disk has pi more than its turn of the boundary.
  c.Error("angle defects of half a sphere obey Gauss-Bonnet",
    std::abs(Defects(HalfSphere(3)).sum() - (2 * Pi + 32 * Pi)), 1e-11);
}

void CheckNormals(Checks& c)
{
  const Points corners = Tetrahedron().V.rowwise().normalized();
  c.Error("normals of the tetrahedron point to its corners",
    MaximumDistance(Normals(Tetrahedron()), corners), 1e-15);
  c.Error("normals of a flat grid point upward",
    MaximumDistance(Normals(Grid(5, 0.3)), Vector3(0, 0, 1).replicate(36, 1)), 1e-15);
  c.Error("normals of a sphere point outward",
    MaximumDistance(Normals(Icosphere(4)), Icosphere(4).V), 0.01);
  // A triangle of area 1 with the normal z and one of area 3 with the normal x.
  TestMesh step = EquilateralTriangle();
  step.V.resize(4, 3);
  step.V << 0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 3;
  step.T.resize(2, 3);
  step.T << 0, 1, 2, 0, 2, 3;
  c.Error("triangles count by their area",
    (Normals(step).row(0) - Vector3(3, 0, 1) / std::sqrt(10)).norm(), 1e-15);
  c.Error("an isolated point has no normal", Normals(WithIsolatedPoint(Cube())).row(0).norm(), 0);
}

void CheckVolumesAndSizes(Checks& c)
{
  c.Error("the unit cube has volume 1", std::abs(Volume(Cube()) - 1), 1e-15);
  c.Error("a cube far away has volume 1",
    std::abs(Volume(Transformed(Cube(), 1, Vector3(1e8, -1e8, 1e8))) - 1), 1e-15);
  c.Error("the tetrahedron has volume 8/3", std::abs(Volume(Tetrahedron()) - 8.0 / 3), 1e-15);
  c.Error(
    "a surface inside out has a negative volume", std::abs(Volume(InsideOut(Cube())) + 1), 1e-15);
  c.Error("a fine sphere has volume 4/3 pi", SphereVolumeError(4), 0.005);
  c.Error("the volume's error falls with the square of the edge length",
    std::abs(SphereVolumeError(3) / SphereVolumeError(4) - 4), 0.1);
  c.Error(
    "no triangles enclose no volume", std::abs(EnclosedVolume(Points(0, 3), Triangles(0, 3))), 0);

  const TestMesh grid = Grid(4, 0);
  c.Error("a scaled normal is twice the area long",
    (ScaledNormal(grid.V, grid.T, 0) - Vector3(0, 0, 1)).norm(), 1e-15);
  c.Error(
    "the diagonal of the unit cube is sqrt 3", std::abs(Diagonal(Cube()) - std::sqrt(3)), 1e-15);
  c.Error("isolated points do not count in the diagonal",
    std::abs(Diagonal(WithIsolatedPoint(Cube())) - std::sqrt(3)), 1e-15);
}
}

int TestTriangleGeometry(int argc, char* argv[])
{
  Groups groups(argc, argv);
  groups.Run("Cotangents", CheckCotangents);
  groups.Run("VoronoiAreas", CheckVoronoiAreas);
  groups.Run("AngleDefects", CheckAngleDefects);
  groups.Run("Normals", CheckNormals);
  groups.Run("VolumesAndSizes", CheckVolumesAndSizes);
  return groups.Result();
}
