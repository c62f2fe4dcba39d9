// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_SelfIntersections_h
#define lmo_SelfIntersections_h

#include "Core/Base/IndexSet.h"
#include "Core/Base/ProgressMonitor.h"
#include "Core/Mesh/MeshTopology.h"
#include "Core/Mesh/TriangleBvh.h"

#include <utility>

namespace lmo
{
/// Two triangles, the lower index first.
using TrianglePair = std::pair<Index, Index>;

/// Finds the pairs of triangles of a mesh that meet elsewhere than in the vertices and the edge
/// that they share. Pairs that are too close to be told from these count with them; a pair of which
/// both triangles have a corner of high valence is left out.
class SelfIntersections
{
public:
  /// Keeps references to the arguments.
  SelfIntersections(const Triangles& triangles, const MeshTopology& topology);

  /// The pairs of which one triangle at least is in the list, in ascending order.
  /// \param tree of the mesh with these positions
  /// \throw Cancelled if the monitor says so.
  std::vector<TrianglePair> Find(const Points& V, const std::vector<Index>& list,
    const TriangleBvh& tree, ProgressMonitor& monitor);

  /// All pairs.
  std::vector<TrianglePair> FindAll(
    const Points& V, const TriangleBvh& tree, ProgressMonitor& monitor);

private:
  bool HasHighValence(Index t) const;
  bool HaveCommonVertex(Index s, Index t) const;

  /// The pairs with a common vertex.
  void FindAtVertices(
    const Points& V, ProgressMonitor& monitor, std::vector<TrianglePair>& pairs) const;

  /// The pairs without a common vertex.
  void FindApart(const Points& V, const TriangleBvh& tree, ProgressMonitor& monitor,
    std::vector<TrianglePair>& pairs) const;

  const Triangles& T;
  const MeshTopology& Topology;
  IndexSet Listed;         ///< triangles; empty between searches
  IndexSet ListedVertices; ///< their vertices; empty between searches
};

/// The pairs before and after.
struct IntersectionReport
{
  bool isKnown = false; ///< pairs were searched for
  std::vector<TrianglePair> pairsBefore;
  std::int64_t before = 0; ///< number of pairs
  std::int64_t after = 0;
  std::int64_t added = 0; ///< pairs after, and not before
  Mask isIntersecting;    ///< for each triangle, whether it is in a pair after
};

/// \param before pairs in ascending order
/// \param after the same
IntersectionReport ReportIntersections(
  const std::vector<TrianglePair>& before, const std::vector<TrianglePair>& after, Index triangles);

/// Looks for the pairs of a mesh with the positions \a before and \a after.
/// \throw Cancelled if the monitor says so.
IntersectionReport CompareIntersections(const Points& before, const Points& after,
  const Triangles& triangles, const MeshTopology& topology, ProgressMonitor& monitor);
}

#endif
