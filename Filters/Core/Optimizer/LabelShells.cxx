// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Optimizer/LabelShells.h"

#include "Core/Mesh/MeshTopology.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace lmo
{
namespace
{
/// A triangle at an edge, with one of its labels.
struct LabelledEdge
{
  Index low;
  Index high;
  double label;
  Index triangle;
  bool isForward; ///< runs from low to high, seen with the label behind it, if that is the first

  bool HasSameKey(const LabelledEdge& other) const
  {
    return this->low == other.low && this->high == other.high && this->label == other.label;
  }
  bool operator<(const LabelledEdge& other) const
  {
    return std::tie(this->low, this->high, this->label, this->triangle) <
           std::tie(other.low, other.high, other.label, other.triangle);
  }
};

std::vector<LabelledEdge> SortedEdges(const Triangles& triangles, const TriangleLabels& labels)
{
  std::vector<LabelledEdge> edges;
  edges.reserve(2 * triangles.size());
  for (Index corner = 0; corner < static_cast<Index>(triangles.size()); ++corner)
  {
    const Index t = corner / 3;
    const Index a = triangles.data()[corner];
    const Index b = triangles.data()[NextCorner(corner)];
    for (int side = 0; side < 2 && !IsDegenerate(triangles, t); ++side)
    {
      edges.push_back(
        { std::min(a, b), std::max(a, b), labels(t, side), t, (a < b) == (side == 0) });
    }
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

/// Sets of triangles, each with a flag in relation to the lowest triangle of its set.
class FlaggedSets
{
public:
  explicit FlaggedSets(Index size)
    : Parent(size)
    , Flag(size, 0)
  {
    std::iota(this->Parent.begin(), this->Parent.end(), 0);
  }

  /// The lowest triangle of the set; points the triangles on the way straight at it.
  Index Find(Index t)
  {
    Index root = t;
    unsigned char flag = 0; // of t
    for (; this->Parent[root] != root; root = this->Parent[root])
    {
      flag ^= this->Flag[root];
    }
    while (this->Parent[t] != root && t != root)
    {
      const Index next = this->Parent[t];
      const unsigned char own = this->Flag[t];
      this->Parent[t] = root;
      this->Flag[t] = flag;
      flag ^= own;
      t = next;
    }
    return root;
  }

  /// The flag of a triangle whose set Find() has looked up.
  unsigned char GetFlag(Index t) const { return this->Parent[t] == t ? 0 : this->Flag[t]; }

  /// Unites the sets of t and u, whose flags differ or not.
  void Join(Index t, Index u, bool differ)
  {
    const Index a = this->Find(t);
    const Index b = this->Find(u);
    const auto flag = static_cast<unsigned char>(this->GetFlag(t) ^ this->GetFlag(u) ^ differ);
    this->Parent[std::max(a, b)] = std::min(a, b);
    this->Flag[std::max(a, b)] = a == b ? 0 : flag;
  }

private:
  std::vector<Index> Parent;
  Mask Flag; ///< in relation to the parent
};
}

LabelShells FindLabelShells(const Triangles& triangles, const TriangleLabels& labels)
{
  const auto count = static_cast<Index>(triangles.rows());
  const std::vector<LabelledEdge> edges = SortedEdges(triangles, labels);
  FlaggedSets sets(count);
  for (auto first = edges.begin(); first != edges.end();)
  {
    const auto last = std::find_if(
      first, edges.end(), [&](const LabelledEdge& edge) { return !edge.HasSameKey(*first); });
    if (last - first == 2)
    {
      sets.Join(first->triangle, first[1].triangle, first->isForward == first[1].isForward);
    }
    first = last;
  }
  LabelShells shells{ std::vector<Index>(count), Mask(count) };
  for (Index t = 0; t < count; ++t)
  {
    shells.shell[t] = sets.Find(t);
    shells.isTurned[t] = sets.GetFlag(t);
  }
  return shells;
}
}
