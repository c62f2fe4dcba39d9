// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef PolygonFixtures_h
#define PolygonFixtures_h

#include "MeshFixtures.h"

#include "Core/Mesh/Polygons.h"

/// Surfaces of polygons made in code, cut into the triangles around their first corners.
struct PolygonMesh
{
  lmo::Points V;
  lmo::Polygons polygons;
  lmo::Triangles T;
};

using Polygon = std::vector<lmo::Index>;

/// \param polygons whose first corners see all of them
PolygonMesh MakePolygonMesh(const lmo::Points& V, const std::vector<Polygon>& polygons);

/// The triangles of a mesh as polygons.
PolygonMesh AsPolygons(const TestMesh& mesh);

/// The same polygons, cut around the corners that are \a shift places later.
PolygonMesh CutElsewhere(const PolygonMesh& mesh, lmo::Index shift);

/// Flat square of cells x cells unit quads, with inner vertices moved by up to \a jitter.
PolygonMesh QuadGrid(int cells, double jitter);

/// Flat octagons in the shape of an L, two in each block of 2 x 3 unit squares, with inner vertices
/// moved by up to \a jitter.
PolygonMesh Ls(int blocks, double jitter);

/// A flat regular polygon in a ring of as many quads, whose inner vertices are the polygon's.
PolygonMesh PolygonInRing(int corners);

/// Unit sphere of 6 x cells x cells quads.
PolygonMesh QuadSphere(int cells);

/// Unit sphere of hexagons and 12 pentagons, the dual of Icosphere(level).
PolygonMesh HexagonSphere(int level);

/// Torus with the radii 2 and 0.8, of 2 cells x cells quads.
PolygonMesh QuadTorus(int cells);

/// Every coordinate changed by up to \a amplitude.
PolygonMesh Noisy(PolygonMesh mesh, double amplitude);

/// Rotated out of the coordinate planes.
PolygonMesh Tilted(PolygonMesh mesh);

/// Edges of exactly one polygon, counted.
std::vector<bool> BoundaryVertices(const PolygonMesh& mesh);

#endif
