// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshFixtures.h"

#include "Core/Mesh/TriangleGeometry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

using namespace lmo;

namespace
{
TestMesh MakeMesh(
  const std::vector<Vector3>& vertices, const std::vector<std::array<Index, 3>>& triangles)
{
  TestMesh mesh{ Points(vertices.size(), 3), Triangles(triangles.size(), 3) };
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    mesh.V.row(i) = vertices[i];
  }
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    mesh.T.row(t) << triangles[t][0], triangles[t][1], triangles[t][2];
  }
  return mesh;
}

/// Cuts each triangle in four at the middles of its edges.
TestMesh Subdivide(const TestMesh& mesh)
{
  std::vector<Vector3> vertices(mesh.V.rowwise().begin(), mesh.V.rowwise().end());
  std::map<Edge, Index> middles;
  const auto middle = [&](Index i, Index j)
  {
    const auto [entry, isNew] =
      middles.emplace(EdgeBetween(i, j), static_cast<Index>(vertices.size()));
    if (isNew)
    {
      vertices.push_back((mesh.V.row(i) + mesh.V.row(j)) / 2);
    }
    return entry->second;
  };
  std::vector<std::array<Index, 3>> triangles;
  for (const auto& T : mesh.T.rowwise())
  {
    const Index a = T[0], b = T[1], c = T[2];
    const Index ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    triangles.insert(
      triangles.end(), { { a, ab, ca }, { b, bc, ab }, { c, ca, bc }, { ab, bc, ca } });
  }
  return MakeMesh(vertices, triangles);
}

/// The same \a level times.
TestMesh Subdivide(TestMesh mesh, int level)
{
  for (int i = 0; i < level; ++i)
  {
    mesh = Subdivide(mesh);
  }
  return mesh;
}

TestMesh SphereFrom(TestMesh mesh, int level, double radius)
{
  mesh = Subdivide(std::move(mesh), level);
  mesh.V.rowwise().normalize();
  mesh.V *= radius;
  return mesh;
}
}

Edge EdgeBetween(Index i, Index j)
{
  return { std::min(i, j), std::max(i, j) };
}

double Random::operator()()
{
  return this->Engine() / 2147483647.5 - 1;
}

Points Random::Displacements(Eigen::Index vertices)
{
  return Points::NullaryExpr(vertices, 3, [this] { return (*this)(); });
}

TestMesh EquilateralTriangle()
{
  return MakeMesh({ { 0, 0, 0 }, { 1, 0, 0 }, { 0.5, std::sqrt(0.75), 0 } }, { { 0, 1, 2 } });
}

TestMesh CrossRing()
{
  return MakeMesh({ { 0, 0, 0 }, { 2, 0, 0 }, { 0, 1, 0 }, { -1, 0, 0 }, { 0, -2, 0 } },
    { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 4 }, { 0, 4, 1 } });
}

TestMesh Grid(int cells, double jitter)
{
  Random random;
  std::vector<Vector3> vertices;
  std::vector<std::array<Index, 3>> triangles;
  const auto move = [&](int k) { return k + (k % cells ? jitter * random() : 0); };
  for (int j = 0; j <= cells; ++j)
  {
    for (int i = 0; i <= cells; ++i)
    {
      vertices.emplace_back(move(i), move(j), 0);
      if (i < cells && j < cells)
      {
        const Index a = j * (cells + 1) + i, b = a + 1, c = a + cells + 1, d = c + 1;
        triangles.insert(triangles.end(), { { a, b, d }, { a, d, c } });
      }
    }
  }
  return MakeMesh(vertices, triangles);
}

TestMesh LongTriangles()
{
  TestMesh mesh = Grid(6, 0.2);
  mesh.V.col(0) *= 100;
  return mesh;
}

TestMesh Hexagon()
{
  TestMesh mesh{ Points::Zero(7, 3), Triangles(6, 3) };
  for (int k = 0; k < 6; ++k)
  {
    const double angle = k * std::acos(0.5);
    mesh.V.row(k + 1) << std::cos(angle), std::sin(angle), 0;
    mesh.T.row(k) << 0, k + 1, (k + 1) % 6 + 1;
  }
  return mesh;
}

TestMesh Hinge()
{
  TestMesh mesh{ Points(4, 3), Triangles(2, 3) };
  mesh.V << 0, 0, 0, 0, 1, 0, -1, 0.5, 0, 1, 0.5, 0;
  mesh.T << 0, 1, 2, 1, 0, 3;
  return mesh;
}

TestMesh ThreeWings()
{
  return MakeMesh({ { 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, { -1, 1, 0 }, { -1, -1, 0 } },
    { { 0, 1, 2 }, { 0, 1, 3 }, { 0, 1, 4 } });
}

TestMesh CylinderPatch(double radius)
{
  TestMesh mesh = Grid(12, 0);
  for (auto v : mesh.V.rowwise())
  {
    const double angle = v[0] / 10;
    v = radius * Vector3(std::cos(angle), std::sin(angle), v[1] / 10);
  }
  return mesh;
}

TestMesh HalfSphere(int level)
{
  return SphereFrom(MakeMesh({ { 1, 0, 0 }, { 0, 1, 0 }, { -1, 0, 0 }, { 0, -1, 0 }, { 0, 0, 1 } },
                      { { 0, 1, 4 }, { 1, 2, 4 }, { 2, 3, 4 }, { 3, 0, 4 } }),
    level, 1);
}

TestMesh UvSphere(int meridians, int parallels)
{
  const int rings = meridians * parallels;
  TestMesh mesh{ Points(rings + 2, 3), Triangles(2 * rings, 3) };
  for (int k = 0; k < rings; ++k)
  {
    const int ring = k / meridians;
    const int next = ring * meridians + (k + 1) % meridians;
    const double azimuth = 2 * Pi * (k % meridians) / meridians;
    const double polar = Pi * (ring + 1) / (parallels + 1);
    mesh.V.row(k) << std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth),
      std::cos(polar);
    mesh.T.row(2 * k) << next, (ring == 0 ? rings : k - meridians), k;
    mesh.T.row(2 * k + 1) << k, (ring + 1 < parallels ? next + meridians : rings + 1), next;
  }
  mesh.V.row(rings) << 0, 0, 1;
  mesh.V.row(rings + 1) << 0, 0, -1;
  return mesh;
}

TestMesh Tetrahedron()
{
  return MakeMesh({ { 1, 1, 1 }, { 1, -1, -1 }, { -1, 1, -1 }, { -1, -1, 1 } },
    { { 0, 1, 2 }, { 0, 3, 1 }, { 0, 2, 3 }, { 1, 3, 2 } });
}

TestMesh Cube(int level)
{
  return Subdivide(
    MakeMesh({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 }, { 0, 0, 1 }, { 1, 0, 1 },
               { 0, 1, 1 }, { 1, 1, 1 } },
      { { 0, 2, 1 }, { 1, 2, 3 }, { 4, 5, 6 }, { 5, 7, 6 }, { 0, 1, 4 }, { 1, 5, 4 }, { 2, 6, 3 },
        { 3, 6, 7 }, { 0, 4, 2 }, { 2, 4, 6 }, { 1, 3, 5 }, { 3, 7, 5 } }),
    level);
}

TestMesh Icosphere(int level, double radius)
{
  const double g = (1 + std::sqrt(5)) / 2;
  return SphereFrom(MakeMesh({ { -1, g, 0 }, { 1, g, 0 }, { -1, -g, 0 }, { 1, -g, 0 }, { 0, -1, g },
                               { 0, 1, g }, { 0, -1, -g }, { 0, 1, -g }, { g, 0, -1 }, { g, 0, 1 },
                               { -g, 0, -1 }, { -g, 0, 1 } },
                      { { 0, 11, 5 }, { 0, 5, 1 }, { 0, 1, 7 }, { 0, 7, 10 }, { 0, 10, 11 },
                        { 1, 5, 9 }, { 5, 11, 4 }, { 11, 10, 2 }, { 10, 7, 6 }, { 7, 1, 8 },
                        { 3, 9, 4 }, { 3, 4, 2 }, { 3, 2, 6 }, { 3, 6, 8 }, { 3, 8, 9 },
                        { 4, 9, 5 }, { 2, 4, 11 }, { 6, 2, 10 }, { 8, 6, 7 }, { 9, 8, 1 } }),
    level, radius);
}

TestMesh DoublePyramid(int level)
{
  return Subdivide(
    MakeMesh({ { 1, 1, 0 }, { -1, 1, 0 }, { -1, -1, 0 }, { 1, -1, 0 }, { 0, 0, 1 }, { 0, 0, -1 } },
      { { 0, 1, 4 }, { 1, 2, 4 }, { 2, 3, 4 }, { 3, 0, 4 }, { 1, 0, 5 }, { 2, 1, 5 }, { 3, 2, 5 },
        { 0, 3, 5 } }),
    level);
}

TestMesh RandomTriangles(Random& random, int triangles)
{
  TestMesh mesh{ random.Displacements(3 * triangles), Triangles(triangles, 3) };
  for (int k = 0; k < 3 * triangles; ++k)
  {
    mesh.T(k / 3, k % 3) = k;
  }
  return mesh;
}

TestMesh Joined(const TestMesh& a, const TestMesh& b)
{
  TestMesh both{ Points(a.V.rows() + b.V.rows(), 3), Triangles(a.T.rows() + b.T.rows(), 3) };
  both.V << a.V, b.V;
  both.T << a.T, b.T.array() + static_cast<Index>(a.V.rows());
  return both;
}

TestMesh TwoComponents()
{
  return Joined(Icosphere(1), Transformed(Tetrahedron(), 0.5, { 5, 0, 0 }));
}

TestMesh WithIsolatedPoint(const TestMesh& mesh)
{
  TestMesh result{ Points(mesh.V.rows() + 1, 3), mesh.T.array() + 1 };
  result.V << Vector3(70, 80, 90), mesh.V;
  return result;
}

TestMesh WithThinTriangles(TestMesh mesh, Index every, double share)
{
  for (Index t = 0; t < mesh.T.rows(); t += every)
  {
    mesh.V.row(mesh.T(t, 0)) += share * (mesh.V.row(mesh.T(t, 1)) - mesh.V.row(mesh.T(t, 0)));
  }
  return mesh;
}

TestMesh WithTriangle(TestMesh mesh, Index a, Index b, Index c)
{
  mesh.T.conservativeResize(mesh.T.rows() + 1, 3);
  mesh.T.bottomRows(1) << a, b, c;
  return mesh;
}

TestMesh Irregular(TestMesh mesh, double amplitude)
{
  mesh.V += amplitude * Random().Displacements(mesh.V.rows());
  mesh.V =
    mesh.V.unaryExpr([](double x) { return std::ldexp(std::round(std::ldexp(x, 20)), -20); });
  return mesh;
}

TestMesh Transformed(TestMesh mesh, double scale, const Vector3& shift)
{
  mesh.V = (scale * mesh.V).rowwise() + shift;
  return mesh;
}

std::vector<std::pair<std::string, TestMesh>> AllTestMeshes()
{
  return { { "triangle", EquilateralTriangle() }, { "cross", CrossRing() },
    { "grid", Grid(8, 0.3) }, { "long triangles", LongTriangles() },
    { "three wings", ThreeWings() }, { "cylinder", CylinderPatch(2) },
    { "half sphere", HalfSphere(3) }, { "tetrahedron", Tetrahedron() }, { "cube", Cube() },
    { "sphere", Icosphere(2) }, { "irregular sphere", Irregular(Icosphere(2), 0.08) },
    { "double pyramid", DoublePyramid(3) }, { "two components", TwoComponents() },
    { "isolated point", WithIsolatedPoint(Cube()) } };
}
