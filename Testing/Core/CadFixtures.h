// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef CadFixtures_h
#define CadFixtures_h

#include "MeshFixtures.h"

/// Tessellations as CAD programs write them: exact, with needles, and no more points than the shape
/// needs.

/// How a flat cap is cut into triangles.
enum class Cap
{
  CENTRE, ///< a fan around a point in the middle, which comes after all other points
  FAN,    ///< a fan around one of its points
  STRIP
};

/// Closed bar of radius 1 along the z axis. The points of its rims come first.
TestMesh Bar(int sides, double length, Cap cap);

/// Closed bar along the z axis; each point of the profile, a convex or star-shaped polygon around
/// the origin, makes a point of both rims. These come first.
TestMesh ExtrudedProfile(const std::vector<std::pair<double, double>>& profile, double length);

/// Closed plate of columns x rows squares of 3 x 3 with a round hole in each. The corners of
/// squares inside the plate lie in its faces, all other points on sharp edges.
/// \param radius of the holes, below 1
TestMesh PlateWithHoles(int columns, int rows, int sides, double radius, double thickness);

/// Cuts triangle t at the middle of its first edge, to which a triangle without area joins the
/// triangle on the other side.
TestMesh WithZeroAreaTriangle(const TestMesh& mesh, lmo::Index t);

/// Turned by some angle, in single precision.
TestMesh TurnedInSinglePrecision(TestMesh mesh);

#endif
