// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_TriangleBvh_h
#define lmo_TriangleBvh_h

#include "Core/Base/ProgressMonitor.h"
#include "Core/Base/Types.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace lmo
{
/// Closest-point queries on a mesh whose vertices move: a binary tree of bounding boxes, built once
/// and refitted when vertices have moved. (VTK's locators and Eigen's KdBVH have to be built anew.)
class TriangleBvh
{
public:
  struct Hit
  {
    Index triangle = -1; ///< -1: there is none within the radius
    double squaredDistance = 0;
  };

  /// Keeps references to the arguments. Triangles that name a vertex twice are left out.
  /// \throw Cancelled if the monitor says so.
  TriangleBvh(const Points& V, const Triangles& triangles, ProgressMonitor& monitor);

  /// The same tree over vertices that may move on their own; keeps a reference to \a V.
  TriangleBvh(const Points& V, const TriangleBvh& other);

  bool IsEmpty() const { return this->Order.empty(); }

  /// Says which triangles have moved: Refit() has to follow before the next query.
  void Invalidate(const std::vector<Index>& triangles);

  /// Adapts the boxes to the present positions.
  void Refit();

  /// The triangle closest to x, if its distance is at most \a radius; any one whose distance is at
  /// most a thousandth of that.
  /// \param hint a triangle that is perhaps close, or -1
  Hit FindClosest(const Vector3& x, double radius, Index hint = -1) const;

  /// The triangle closest to x, at any distance; triangle -1 if there are no triangles.
  Hit FindClosest(const Vector3& x) const;

  /// Calls visit(triangle) for the triangles of all leaves whose boxes meet a box: for each
  /// triangle that meets it, and for others.
  template <typename Visit>
  void ForEachNear(const Eigen::AlignedBox3d& box, const Visit& visit) const
  {
    Index stack[64];
    int size = 0;
    stack[size++] = 1;
    while (size > 0)
    {
      const Index node = stack[--size];
      if (!this->Boxes[node].intersects(box))
      {
        continue;
      }
      if (node < this->Leaves)
      {
        stack[size++] = 2 * node + 1;
        stack[size++] = 2 * node;
        continue;
      }
      const Index leaf = node - this->Leaves;
      for (Index k = this->Begin(leaf); k < this->Begin(leaf + 1); ++k)
      {
        visit(this->Order[k]);
      }
    }
  }

  static constexpr Index LargestGroup = 16;

  /// A number for each group of triangles that lie side by side, at most LargestGroup; -1
  /// for one that is left out.
  Index GroupOf(Index triangle) const
  {
    const Index leaf = this->LeafOf[triangle];
    return leaf < 0 ? -1 : leaf / LeavesPerGroup;
  }

  /// Calls visit(triangle) for the triangles of a group.
  template <typename Visit>
  void ForEachOfGroup(Index group, const Visit& visit) const
  {
    const Index end = std::min((group + 1) * LeavesPerGroup, this->Leaves);
    for (Index k = this->Begin(group * LeavesPerGroup); k < this->Begin(end); ++k)
    {
      visit(this->Order[k]);
    }
  }

  /// Of x to one triangle.
  double SquaredDistance(Index triangle, const Vector3& x) const;

private:
  using Box = Eigen::AlignedBox3d;

  static constexpr Index LeavesPerGroup = 4;

  Index Begin(Index leaf) const
  {
    return static_cast<Index>(std::int64_t(this->Order.size()) * leaf / this->Leaves);
  }

  /// Halves the triangles of these leaves along the longest axis of their centres.
  void Halve(Index firstLeaf, Index leaves);

  /// Halves until every leaf has its own.
  void Sort(Index firstLeaf, Index leaves);

  Box LeafBox(Index leaf) const;

  /// Adapts the boxes on the way from a triangle's leaf to the root.
  void RefitPath(Index triangle);

  /// Sets the box of a node to that of its children's.
  void Merge(Index node);

  void Try(Index triangle, const Vector3& x, Hit& best) const;

  /// Makes best the closest triangle, or any one whose squared distance is at most \a closeEnough.
  void Search(const Vector3& x, double closeEnough, Hit& best) const;

  const Points& V;
  const Triangles& T;
  bool AreAllStale = true;
  std::vector<Index> Stale; ///< triangles that have moved since Refit(), if not all boxes are stale
  Index Leaves = 1;         ///< a power of two
  std::vector<Index> Order; ///< the triangles, those of a leaf side by side
  std::vector<Index> LeafOf; ///< leaf of each triangle, or -1
  std::vector<Box> Boxes;    ///< node k has the children 2 k and 2 k + 1; leaves start at Leaves
};
}

#endif
