// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_FeatureDetection_h
#define lmo_FeatureDetection_h

#include "Core/Mesh/Subdomain.h"

namespace lmo
{
/// The edges at which the surface turns by more than an angle (SurfaceNormals), as lists of
/// neighbours along them. Edges of three and more triangles and of triangles whose orientations
/// differ are features always. Of connected edges, those are dropped that are noise:
/// - a line that ends inside the surface and has fewer than 10 edges beside which no triangle is
///   thin; closed lines and lines between corners or boundaries may be shorter;
/// - where more than one vertex in five is a corner, those beside which the surface is neither flat
///   nor made of planes;
/// - corners of triangles that are features of their own making: all three edges are sharp, and no
///   other edge pins the corner.
/// \param angle in degrees, 0 to 180
/// \param quality t of each triangle
/// \param subdomain of which the mesh is the part; right are the edges at vertices that are owned
AdjacencyLists DetectFeatureEdges(const Points& V, const Triangles& triangles,
  const MeshTopology& topology, const Vector& quality, double angle,
  const Subdomain& subdomain = Subdomain());

/// The edges between triangles with different labels.
AdjacencyLists EdgesBetweenLabels(
  const TriangleLabels& labels, const Triangles& triangles, const MeshTopology& topology);

/// The edges whose ends both have a tag that is not 0.
AdjacencyLists EdgesBetweenTagged(const Vector& tags, const MeshTopology& topology);

/// The edges that one or both hold.
AdjacencyLists MergeEdges(const AdjacencyLists& a, const AdjacencyLists& b);
}

#endif
