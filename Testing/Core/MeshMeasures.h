// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef MeshMeasures_h
#define MeshMeasures_h

#include "MeshFixtures.h"

#include <vector>

/// What can be measured on a mesh without the code under test, slowly.

/// Edges of exactly one triangle, found by counting.
std::vector<Edge> BoundaryEdges(const TestMesh& mesh);

/// For each vertex, whether it lies on such an edge.
std::vector<bool> BoundaryVertices(const TestMesh& mesh);

/// For each vertex the ascending ids of those that share a triangle with it; found by search.
std::vector<std::vector<lmo::Index>> Neighbours(const TestMesh& mesh);

/// Sum of the triangles' areas.
double SurfaceArea(const TestMesh& mesh);

/// Largest magnitude of a coefficient, 0 if there is none; NaN is the largest.
double LargestMagnitude(const Eigen::MatrixXd& x);

/// Largest distance between two points of the same row.
double MaximumDistance(const lmo::Points& a, const lmo::Points& b);

/// Distances, found by trying every segment or triangle.
double DistanceToSegment(const lmo::Vector3& x, const lmo::Vector3& a, const lmo::Vector3& b);

double DistanceToTriangle(
  const lmo::Vector3& x, const lmo::Vector3& a, const lmo::Vector3& b, const lmo::Vector3& c);

/// Distance to triangle t of the mesh.
double DistanceToTriangle(const lmo::Vector3& x, const TestMesh& mesh, Eigen::Index t);

double DistanceToSurface(const lmo::Vector3& x, const TestMesh& mesh);

/// A grid of points on triangle t, its corners included.
lmo::Points GridOn(const TestMesh& mesh, Eigen::Index t);

/// The largest distance of one surface to another, at GridOn() its triangles.
double LargestDistance(const TestMesh& from, const TestMesh& to);

/// Distance to the edges of exactly one triangle.
double DistanceToBoundary(const lmo::Vector3& x, const TestMesh& mesh);

#endif
