// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Mesh/TriangleBvh.h"

#include "Core/Base/Threading.h"
#include "Core/Mesh/MeshTopology.h"
#include "Core/Mesh/TriangleGeometry.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace lmo
{
namespace
{
constexpr Index TrianglesPerLeaf = 4;
constexpr Index LeavesPerTask = 1024;

/// In terms of the radius. Where thousands of triangles meet, all are equally close.
constexpr double NegligibleDistance = 1e-3;

/// One in so many triangles may move before refitting all boxes is faster.
constexpr std::size_t StaleShare = 32;
}

TriangleBvh::TriangleBvh(const Points& V, const Triangles& triangles, ProgressMonitor& monitor)
  : V(V)
  , T(triangles)
{
  for (Index t = 0; t < static_cast<Index>(triangles.rows()); ++t)
  {
    if (!IsDegenerate(triangles, t))
    {
      this->Order.push_back(t);
    }
  }
  while (this->Leaves * std::int64_t(TrianglesPerLeaf) < std::int64_t(this->Order.size()))
  {
    this->Leaves *= 2;
  }
  this->Boxes.resize(2 * std::size_t(this->Leaves));
  Index span = this->Leaves;
  for (; span > LeavesPerTask; span /= 2)
  {
    monitor.Report(0);
    ParallelTasks(this->Leaves / span, [&](Index k) { this->Halve(k * span, span); });
  }
  monitor.Report(0);
  ParallelTasks(this->Leaves / span, [&](Index k) { this->Sort(k * span, span); });
  monitor.Report(0);
  this->LeafOf.assign(triangles.rows(), -1);
  for (Index leaf = 0; leaf < this->Leaves; ++leaf)
  {
    for (Index k = this->Begin(leaf); k < this->Begin(leaf + 1); ++k)
    {
      this->LeafOf[this->Order[k]] = leaf;
    }
  }
  this->Refit();
}

TriangleBvh::TriangleBvh(const Points& V, const TriangleBvh& other)
  : V(V)
  , T(other.T)
  , Leaves(other.Leaves)
  , Order(other.Order)
  , LeafOf(other.LeafOf)
  , Boxes(other.Boxes)
{
}

void TriangleBvh::Halve(Index firstLeaf, Index leaves)
{
  const auto centre = [this](Index t)
  { return this->V.row(this->T(t, 0)) + this->V.row(this->T(t, 1)) + this->V.row(this->T(t, 2)); };
  const auto begin = this->Order.begin() + this->Begin(firstLeaf);
  const auto middle = this->Order.begin() + this->Begin(firstLeaf + leaves / 2);
  const auto end = this->Order.begin() + this->Begin(firstLeaf + leaves);
  Box box;
  for (auto t = begin; t != end; ++t)
  {
    box.extend(centre(*t).transpose().eval());
  }
  Eigen::Index axis = 0;
  box.sizes().maxCoeff(&axis);
  std::nth_element(
    begin, middle, end, [&](Index s, Index t) { return centre(s)[axis] < centre(t)[axis]; });
}

void TriangleBvh::Sort(Index firstLeaf, Index leaves)
{
  if (leaves > 1)
  {
    this->Halve(firstLeaf, leaves);
    this->Sort(firstLeaf, leaves / 2);
    this->Sort(firstLeaf + leaves / 2, leaves / 2);
  }
}

TriangleBvh::Box TriangleBvh::LeafBox(Index leaf) const
{
  Box box;
  for (Index k = this->Begin(leaf); k < this->Begin(leaf + 1); ++k)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      box.extend(this->V.row(this->T(this->Order[k], corner)).transpose());
    }
  }
  return box;
}

void TriangleBvh::Merge(Index node)
{
  const Box* children = this->Boxes.data() + 2 * std::ptrdiff_t(node);
  this->Boxes[node] = children[0].merged(children[1]);
}

void TriangleBvh::RefitPath(Index triangle)
{
  if (this->LeafOf[triangle] >= 0)
  {
    Index node = this->Leaves + this->LeafOf[triangle];
    this->Boxes[node] = this->LeafBox(this->LeafOf[triangle]);
    for (node /= 2; node > 0; node /= 2)
    {
      this->Merge(node);
    }
  }
}

void TriangleBvh::Invalidate(const std::vector<Index>& triangles)
{
  if (!this->AreAllStale)
  {
    this->Stale.insert(this->Stale.end(), triangles.begin(), triangles.end());
    this->AreAllStale = this->Stale.size() > this->Order.size() / StaleShare;
  }
}

void TriangleBvh::Refit()
{
  if (this->AreAllStale)
  {
    ParallelFor(
      this->Leaves, [this](Index leaf) { this->Boxes[this->Leaves + leaf] = this->LeafBox(leaf); });
    for (Index level = this->Leaves / 2; level > 0; level /= 2)
    {
      ParallelFor(level, [&](Index k) { this->Merge(level + k); });
    }
  }
  else
  {
    for (const Index t : this->Stale)
    {
      this->RefitPath(t);
    }
  }
  this->AreAllStale = false;
  this->Stale.clear();
}

double TriangleBvh::SquaredDistance(Index triangle, const Vector3& x) const
{
  const Vector3 closest = ClosestPointOnTriangle(x, this->V.row(this->T(triangle, 0)),
    this->V.row(this->T(triangle, 1)), this->V.row(this->T(triangle, 2)));
  return (closest - x).squaredNorm();
}

void TriangleBvh::Try(Index triangle, const Vector3& x, Hit& best) const
{
  const double squaredDistance = this->SquaredDistance(triangle, x);
  const bool isFirst = best.triangle < 0 && squaredDistance <= best.squaredDistance;
  if (isFirst || squaredDistance < best.squaredDistance)
  {
    best = { triangle, squaredDistance };
  }
}

TriangleBvh::Hit TriangleBvh::FindClosest(const Vector3& x, double radius, Index hint) const
{
  Hit best{ -1, radius * radius };
  const double closeEnough = NegligibleDistance * NegligibleDistance * best.squaredDistance;
  if (hint >= 0)
  {
    this->Try(hint, x, best);
  }
  this->Search(x, closeEnough, best);
  return best;
}

TriangleBvh::Hit TriangleBvh::FindClosest(const Vector3& x) const
{
  Hit best{ -1, std::numeric_limits<double>::infinity() };
  this->Search(x, 0, best);
  return best;
}

void TriangleBvh::Search(const Vector3& x, double closeEnough, Hit& best) const
{
  const Eigen::Vector3d centre = x;
  std::pair<Index, double> stack[64];
  int size = 0;
  stack[size++] = { 1, this->Boxes[1].squaredExteriorDistance(centre) };
  while (size > 0 && !(best.triangle >= 0 && best.squaredDistance <= closeEnough))
  {
    const auto [node, distance] = stack[--size];
    if (!(distance <= best.squaredDistance))
    {
      continue;
    }
    if (node >= this->Leaves)
    {
      const Index leaf = node - this->Leaves;
      for (Index k = this->Begin(leaf); k < this->Begin(leaf + 1); ++k)
      {
        this->Try(this->Order[k], x, best);
      }
      continue;
    }
    const Box* children = this->Boxes.data() + 2 * std::ptrdiff_t(node);
    const double left = children[0].squaredExteriorDistance(centre);
    const double right = children[1].squaredExteriorDistance(centre);
    const bool isLeftNearer = left <= right;
    stack[size++] = { 2 * node + isLeftNearer, std::max(left, right) };
    stack[size++] = { 2 * node + !isLeftNearer, std::min(left, right) };
  }
}
}
