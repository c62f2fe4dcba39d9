// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef MeshFixtures_h
#define MeshFixtures_h

#include "Core/Base/Types.h"

#include <random>
#include <string>
#include <utility>
#include <vector>

/// Meshes made in code, the same in every run; triangles are counter-clockwise seen from outside,
/// of flat meshes from above.
struct TestMesh
{
  lmo::Points V;
  lmo::Triangles T;
};

/// Ends of an edge, the smaller id first.
using Edge = std::pair<lmo::Index, lmo::Index>;
Edge EdgeBetween(lmo::Index i, lmo::Index j);

/// Numbers from -1 to 1, the same with every standard library.
class Random
{
public:
  double operator()();
  lmo::Points Displacements(Eigen::Index vertices);

private:
  std::mt19937 Engine{ 1 };
};

/// Equilateral triangle with edges of length 1 in the plane z = 0.
TestMesh EquilateralTriangle();

/// Vertex 0 at the origin in a flat ring of (2, 0), (0, 1), (-1, 0), (0, -2).
TestMesh CrossRing();

/// Flat square of cells x cells unit squares, each cut in two. Its vertices are moved by up to
/// \a jitter, those of the boundary along it; the four corners stay.
TestMesh Grid(int cells, double jitter);

/// A grid stretched to triangles that are a hundred times longer than wide.
TestMesh LongTriangles();

/// The vertex in the middle of a flat ring of six equilateral triangles with unit edges is 0.
TestMesh Hexagon();

/// Two triangles with the edge from (0, 0, 0) to (0, 1, 0), one of them flat at x < 0.
TestMesh Hinge();

/// Three triangles at the edge between vertices 0 and 1.
TestMesh ThreeWings();

/// Part of a cylinder around the z axis, with a regular grid.
TestMesh CylinderPatch(double radius);

/// Upper half of the unit sphere, of 4 triangles that are cut in four \a level times.
TestMesh HalfSphere(int level);

/// Corners (1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1).
TestMesh Tetrahedron();

/// [0, 1]^3, each face cut in two triangles, which are cut in four \a level times.
TestMesh Cube(int level = 0);

/// Sphere of 10 4^level + 2 vertices.
TestMesh Icosphere(int level, double radius = 1);

/// Unit sphere of quads between meridians and parallels, each cut in two; poles come last.
TestMesh UvSphere(int meridians, int parallels);

/// Tips (0, 0, 1) and (0, 0, -1) over a square; 8 triangles that are cut in four \a level times.
TestMesh DoublePyramid(int level);

/// Random triangles in general position, which share no vertex.
TestMesh RandomTriangles(Random& random, int triangles);

/// The points and triangles of both.
TestMesh Joined(const TestMesh& a, const TestMesh& b);

/// A small sphere and a tetrahedron apart from it.
TestMesh TwoComponents();

/// The mesh and, as its vertex 0, a point far away that no triangle uses.
TestMesh WithIsolatedPoint(const TestMesh& mesh);

/// The mesh with every coordinate changed by up to \a amplitude and rounded to a multiple of 2^-20,
/// so that adding 1e8 to it is exact.
TestMesh Irregular(TestMesh mesh, double amplitude);

/// The mesh with one more triangle.
TestMesh WithTriangle(TestMesh mesh, lmo::Index a, lmo::Index b, lmo::Index c);

/// Moves a vertex of every so many triangles along an edge, a share of the way to its neighbour.
TestMesh WithThinTriangles(TestMesh mesh, lmo::Index every = 20, double share = 0.99);

/// V scaled and moved.
TestMesh Transformed(TestMesh mesh, double scale, const lmo::Vector3& shift = { 0, 0, 0 });

/// One mesh of each kind, with its name.
std::vector<std::pair<std::string, TestMesh>> AllTestMeshes();

#endif
