// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Deviation/SelfIntersections.h"

#include "Core/Base/Split.h"
#include "Core/Mesh/TriangleGeometry.h"
#include "Core/Mesh/TriangleSeparation.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

namespace lmo
{
namespace
{
Eigen::AlignedBox3d BoxOf(const Points& V, const Triangles& T, Index t)
{
  const TriangleCorners corners = CornersOf(V, T, t);
  return { corners.colwise().minCoeff().transpose(), corners.colwise().maxCoeff().transpose() };
}

/// Triangles of a group with their bounding boxes, and that of all.
struct BoxedTriangles
{
  std::vector<std::pair<Index, Eigen::AlignedBox3d>> list;
  Eigen::AlignedBox3d whole;

  void Add(Index t, const Eigen::AlignedBox3d& box)
  {
    this->list.push_back({ t, box });
    this->whole.extend(box);
  }
};

/// The boxes of a group in single precision, a little too large, so that the processor compares
/// several at a time with another box.
class RoundedBoxes
{
public:
  explicit RoundedBoxes(const BoxedTriangles& group)
    : Origin(group.whole.min())
    , Size(std::max(group.whole.sizes().maxCoeff(), std::numeric_limits<double>::min()))
    , Count(static_cast<int>(group.list.size()))
  {
    this->Low.setZero();
    this->High.setZero();
    for (int k = 0; k < this->Count; ++k)
    {
      this->Low.row(k) = this->Round(group.list[k].second.min(), -1);
      this->High.row(k) = this->Round(group.list[k].second.max(), 1);
    }
  }

  /// Calls visit(k) for the boxes of the group that may overlap a box.
  template <typename Visit>
  void ForEachNear(const Eigen::AlignedBox3d& box, const Visit& visit) const
  {
    const Corner low = this->Round(box.min(), -1);
    const Corner high = this->Round(box.max(), 1);
    std::array<int, Largest> isNear;
    for (int k = 0; k < Largest; ++k)
    {
      // A comparison with NaN is false.
      isNear[k] = !(this->Low(k, 0) > high[0]) & !(low[0] > this->High(k, 0)) &
                  !(this->Low(k, 1) > high[1]) & !(low[1] > this->High(k, 1)) &
                  !(this->Low(k, 2) > high[2]) & !(low[2] > this->High(k, 2));
    }
    for (int k = 0; k < this->Count; ++k)
    {
      if (isNear[k])
      {
        visit(k);
      }
    }
  }

private:
  static constexpr int Largest = TriangleBvh::LargestGroup;
  using Corner = Eigen::Array<float, 1, 3>;
  using Corners = Eigen::Array<float, Largest, 3>; // by columns

  /// A corner in units of the group's size.
  Corner Round(const Vector3& corner, float outward) const
  {
    constexpr float roundOff = 1e-6f;
    constexpr double farthest = 1e6;
    const Eigen::Array<double, 1, 3> relative = (corner - this->Origin).array() / this->Size;
    const Corner rounded = relative.max(-farthest).min(farthest).cast<float>();
    return rounded + outward * roundOff * (1 + rounded.abs());
  }

  Vector3 Origin;
  double Size;
  int Count; ///< of boxes
  Corners Low;
  Corners High;
};

/// The groups of the tree that have a triangle of the list.
std::vector<Index> GroupsOf(const std::vector<Index>& list, const TriangleBvh& tree)
{
  std::vector<Index> groups;
  groups.reserve(list.size());
  for (const Index t : list)
  {
    groups.push_back(tree.GroupOf(t));
  }
  std::sort(groups.begin(), groups.end());
  groups.erase(std::unique(groups.begin(), groups.end()), groups.end());
  if (!groups.empty() && groups.front() < 0)
  {
    groups.erase(groups.begin());
  }
  return groups;
}

/// Appends the pairs that search(k, pairs) finds for every k in [0, count), in this order.
template <typename Search>
void Collect(
  Index count, ProgressMonitor& monitor, std::vector<TrianglePair>& pairs, const Search& search)
{
  std::vector<std::vector<TrianglePair>> found(count);
  InterruptibleFor(count, monitor, [&](Index k) { search(k, found[k]); });
  for (const std::vector<TrianglePair>& more : found)
  {
    pairs.insert(pairs.end(), more.begin(), more.end());
  }
}
}

SelfIntersections::SelfIntersections(const Triangles& triangles, const MeshTopology& topology)
  : T(triangles)
  , Topology(topology)
  , Listed(static_cast<Index>(triangles.rows()))
  , ListedVertices(topology.vertices)
{
}

bool SelfIntersections::HasHighValence(Index t) const
{
  return this->Topology.HasHighValence(this->T(t, 0)) ||
         this->Topology.HasHighValence(this->T(t, 1)) ||
         this->Topology.HasHighValence(this->T(t, 2));
}

bool SelfIntersections::HaveCommonVertex(Index s, Index t) const
{
  const auto isOfS = [&](Index i)
  { return i == this->T(s, 0) || i == this->T(s, 1) || i == this->T(s, 2); };
  return isOfS(this->T(t, 0)) || isOfS(this->T(t, 1)) || isOfS(this->T(t, 2));
}

void SelfIntersections::FindAtVertices(
  const Points& V, ProgressMonitor& monitor, std::vector<TrianglePair>& pairs) const
{
  std::vector<Index> vertices = this->ListedVertices.Get();
  const std::vector<Index> open = Split(vertices, monitor,
    [&](Index i)
    { return !this->Topology.HasHighValence(i) && !IsFlatFan(V, this->T, this->Topology, i); });
  const Mask& isListed = this->Listed.GetMask();
  Collect(static_cast<Index>(open.size()), monitor, pairs,
    [&](Index k, std::vector<TrianglePair>& found)
    {
      const auto corners = this->Topology.cornersAt[open[k]];
      for (auto first = corners.begin(); first != corners.end(); ++first)
      {
        for (auto second = first + 1; second != corners.end(); ++second)
        {
          const Index s = std::min(*first, *second) / 3;
          const Index t = std::max(*first, *second) / 3;
          if ((isListed[s] || isListed[t]) && !AreSeparate(V, this->T, s, t))
          {
            found.push_back({ s, t });
          }
        }
      }
    });
}

void SelfIntersections::FindApart(const Points& V, const TriangleBvh& tree,
  ProgressMonitor& monitor, std::vector<TrianglePair>& pairs) const
{
  const Mask& isListed = this->Listed.GetMask();
  const std::vector<Index> groups = GroupsOf(this->Listed.Get(), tree);
  Collect(static_cast<Index>(groups.size()), monitor, pairs,
    [&](Index k, std::vector<TrianglePair>& found)
    {
      BoxedTriangles listed;
      tree.ForEachOfGroup(groups[k],
        [&](Index s)
        {
          if (isListed[s])
          {
            listed.Add(s, BoxOf(V, this->T, s));
          }
        });
      const RoundedBoxes rounded(listed);
      tree.ForEachNear(listed.whole,
        [&](Index t)
        {
          const Eigen::AlignedBox3d other = BoxOf(V, this->T, t);
          rounded.ForEachNear(other,
            [&](int k)
            {
              const auto& [s, box] = listed.list[k];
              const bool isCounted = t > s || (t < s && !isListed[t]);
              if (isCounted && box.intersects(other) && !this->HaveCommonVertex(s, t) &&
                  !(this->HasHighValence(s) && this->HasHighValence(t)) &&
                  !AreSeparate(V, this->T, s, t))
              {
                found.push_back({ std::min(s, t), std::max(s, t) });
              }
            });
        });
    });
}

std::vector<TrianglePair> SelfIntersections::Find(const Points& V, const std::vector<Index>& list,
  const TriangleBvh& tree, ProgressMonitor& monitor)
{
  this->Listed.Add(list);
  for (const Index t : list)
  {
    this->ListedVertices.Add(this->T(t, 0));
    this->ListedVertices.Add(this->T(t, 1));
    this->ListedVertices.Add(this->T(t, 2));
  }
  std::vector<TrianglePair> pairs;
  this->FindAtVertices(V, monitor, pairs);
  this->FindApart(V, tree, monitor, pairs);
  this->Listed.Clear();
  this->ListedVertices.Clear();
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

std::vector<TrianglePair> SelfIntersections::FindAll(
  const Points& V, const TriangleBvh& tree, ProgressMonitor& monitor)
{
  std::vector<Index> all(this->T.rows());
  std::iota(all.begin(), all.end(), Index(0));
  return this->Find(V, all, tree, monitor);
}

IntersectionReport ReportIntersections(
  const std::vector<TrianglePair>& before, const std::vector<TrianglePair>& after, Index triangles)
{
  IntersectionReport report;
  report.isKnown = true;
  report.pairsBefore = before;
  report.before = static_cast<std::int64_t>(before.size());
  report.after = static_cast<std::int64_t>(after.size());
  report.isIntersecting.assign(triangles, false);
  for (const TrianglePair& pair : after)
  {
    report.added += !std::binary_search(before.begin(), before.end(), pair);
    report.isIntersecting[pair.first] = report.isIntersecting[pair.second] = true;
  }
  return report;
}

IntersectionReport CompareIntersections(const Points& before, const Points& after,
  const Triangles& triangles, const MeshTopology& topology, ProgressMonitor& monitor)
{
  SelfIntersections search(triangles, topology);
  const auto find = [&](const Points& V)
  { return search.FindAll(V, TriangleBvh(V, triangles, monitor), monitor); };
  return ReportIntersections(find(before), find(after), static_cast<Index>(triangles.rows()));
}
}
