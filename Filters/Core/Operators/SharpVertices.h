// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_SharpVertices_h
#define lmo_SharpVertices_h

#include "Core/Mesh/MeshTopology.h"

namespace lmo
{
/// How much the surface turns at each vertex: |sum alpha n| / sum alpha over its triangles, with
/// unit normals n and angles alpha at the vertex. It is cos(turn / 2) on a straight edge between
/// two flat faces, however these are triangulated, and 1 on a flat face, at isolated vertices and
/// where no triangle has area.
Vector NormalAgreement(const Points& V, const Triangles& triangles, const MeshTopology& topology);

/// 1 at vertices where the surface turns by more than 60 degrees, else 0. Unlike the mean
/// curvature, this depends neither on the size nor on the shape of the triangles.
Vector SharpVertices(const Points& V, const Triangles& triangles, const MeshTopology& topology);
}

#endif
