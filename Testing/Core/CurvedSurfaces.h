// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef CurvedSurfaces_h
#define CurvedSurfaces_h

#include "MeshFixtures.h"

#include <functional>

/// A surface F(x) = 0 with F > 0 outside, by the derivatives of F.
struct ImplicitSurface
{
  std::function<lmo::Vector3(const lmo::Vector3&)> gradient;
  std::function<lmo::Matrix3(const lmo::Vector3&)> hessian;
};

/// Principal curvatures k1 >= k2, positive where the surface is convex, and their unit directions.
struct NormalCurvatures
{
  double k1;
  double k2;
  lmo::Vector3 direction1;
  lmo::Vector3 direction2;
};

/// From the Hessian of F in the tangent plane, over the length of the gradient.
NormalCurvatures CurvaturesAt(const ImplicitSurface& surface, const lmo::Vector3& x);

/// A surface and points on it with triangles.
struct SampledSurface
{
  std::string name;
  TestMesh mesh;
  ImplicitSurface exact;
};

/// Torus with a tube of radius 0.4 around the unit circle.
/// \param jitter up to which the points are moved along the surface, in edges; without it all quads
/// are cut along the same diagonal
TestMesh Torus(int around, int along, double jitter);

/// Torus with irregular points and diagonals.
SampledSurface SampledTorus(int around, int along);

/// Torus, part of a cylinder, saddle and ellipsoid with about 10,000 irregular points.
std::vector<SampledSurface> SampledSurfaces();

#endif
