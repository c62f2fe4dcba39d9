// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_FeatureDetection_h
#define lmo_FeatureDetection_h

#include "Core/Mesh/MeshTopology.h"

namespace lmo
{
/// The edges whose triangles' normals differ by more than an angle, as lists of neighbours along
/// them. Nearly degenerate triangles (t < 0.1), whose normals say little, have none, and groups of
/// fewer than 10 connected edges are dropped: both would pin bad triangles. Edges of three and more
/// triangles and of triangles whose orientations differ are features always.
/// \param angle in degrees, 0 to 180
/// \param quality t of each triangle
AdjacencyLists DetectFeatureEdges(const Points& V, const Triangles& triangles,
  const MeshTopology& topology, const Vector& quality, double angle);

/// The edges between triangles with different labels.
AdjacencyLists EdgesBetweenRegions(
  const Vector& labels, const Triangles& triangles, const MeshTopology& topology);

/// The edges whose ends both have a tag that is not 0.
AdjacencyLists EdgesBetweenTagged(const Vector& tags, const MeshTopology& topology);

/// The edges that one or both hold.
AdjacencyLists MergeEdges(const AdjacencyLists& a, const AdjacencyLists& b);
}

#endif
