// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_PolygonLaplacian_h
#define lmo_PolygonLaplacian_h

#include "Core/Mesh/Polygons.h"
#include "Core/Operators/Laplacian.h"

namespace lmo
{
/// Cotangent weights and mixed Voronoi areas by virtual refinement (Bunge, Herholz, Kazhdan, Botsch
/// 2020): each polygon is a fan of triangles around a virtual vertex, the point for which the sum
/// of their squared areas is least. Its value is a mean of those at the corners with the weights of
/// least norm that give its position, and so the fan's stiffness matrix becomes one between the
/// corners. It is linearly precise on planar polygons of any shape; for a triangle the weights are
/// the cotangents. Polygons that do not surround their virtual vertex and those with more than 32
/// corners count as their triangles.
CotangentParts ComputePolygonWeights(
  const Points& V, const Triangles& triangles, const Polygons& polygons);

/// 2 pi minus the sum of the angles at each vertex, in radians, with the share of each vertex in
/// the angle defects of the virtual vertices; 0 at isolated vertices.
Vector PolygonAngleDefects(const Points& V, const Triangles& triangles, const Polygons& polygons);
}

#endif
