// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Optimizer/EnclosedRegions.h"

#include "Core/Mesh/TriangleGeometry.h"
#include "Core/Optimizer/LabelShells.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace lmo
{
namespace
{
using Sides = EnclosedRegions::Sides;
constexpr Index None = EnclosedRegions::None;

/// A number for the edge from i to j, its negative for that from j to i, modulo 2^64. The numbers
/// of different edges look random (finalizer of splitmix64; Steele, Lea, Flood 2014).
std::uint64_t EdgeNumber(Index i, Index j)
{
  std::uint64_t x = (std::uint64_t(std::min(i, j)) << 32) + std::uint64_t(std::max(i, j));
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
  x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
  x ^= x >> 31;
  return i < j ? x : 0 - x;
}

/// For each region 1 if its triangles are closed: the numbers of their edges cancel. That others do
/// so by chance has a probability of 2^-64.
Mask ClosedRegions(const Triangles& triangles, const Sides& sides, Index count)
{
  std::vector<std::uint64_t> sums(count, 0);
  Mask isClosed(count, 0);
  for (Index t = 0; t < static_cast<Index>(triangles.rows()); ++t)
  {
    if (IsDegenerate(triangles, t))
    {
      continue;
    }
    const Index a = triangles(t, 0);
    const Index b = triangles(t, 1);
    const Index c = triangles(t, 2);
    const std::uint64_t edges = EdgeNumber(a, b) + EdgeNumber(b, c) + EdgeNumber(c, a);
    for (int side = 0; side < 2; ++side)
    {
      if (sides(t, side) != None)
      {
        sums[sides(t, side)] += side == 0 ? edges : 0 - edges;
        isClosed[sides(t, side)] = 1; // has a triangle
      }
    }
  }
  for (Index k = 0; k < count; ++k)
  {
    isClosed[k] = isClosed[k] && sums[k] == 0;
  }
  return isClosed;
}

/// Regions by label, and by component or, with two labels, by shell.
EnclosedRegions LabelRegions(
  const Triangles& triangles, const std::vector<Index>& component, const TriangleLabels& labels)
{
  EnclosedRegions regions;
  regions.sides = Sides::Constant(triangles.rows(), 2, None);
  const bool hasBothSides = labels.cols() == 2;
  const LabelShells shells = hasBothSides ? FindLabelShells(triangles, labels) : LabelShells();
  std::map<std::pair<Index, double>, Index> numbers;
  for (Index t = 0; t < static_cast<Index>(triangles.rows()); ++t)
  {
    const Index part = hasBothSides ? shells.shell[t] : component[triangles(t, 0)];
    for (Eigen::Index k = 0; k < labels.cols(); ++k)
    {
      const Eigen::Index side = hasBothSides && shells.isTurned[t] ? 1 - k : k;
      const auto key = std::make_pair(part, labels(t, k));
      regions.sides(t, side) = numbers.emplace(key, Index(numbers.size())).first->second;
    }
  }
  regions.count = static_cast<Index>(numbers.size());
  return regions;
}

/// Gives the triangles of regions that are not closed to a region for each component.
void JoinOpenRegions(
  const Triangles& triangles, const std::vector<Index>& component, EnclosedRegions& regions)
{
  const Mask isClosed = ClosedRegions(triangles, regions.sides, regions.count);
  for (Index t = 0; t < static_cast<Index>(triangles.rows()); ++t)
  {
    Index& region = regions.sides(t, 0);
    if (region == None || !isClosed[region])
    {
      region = regions.count + component[triangles(t, 0)];
    }
  }
  regions.count += *std::max_element(component.begin(), component.end()) + 1;
}

/// Removes the regions that are not closed, and those without triangles, and numbers the others.
void RemoveOpenRegions(const Triangles& triangles, EnclosedRegions& regions)
{
  const Mask isClosed = ClosedRegions(triangles, regions.sides, regions.count);
  Mask isOpen(regions.count, 0);
  std::vector<Index> number(regions.count, None);
  Index count = 0;
  for (Index t = 0; t < static_cast<Index>(triangles.rows()); ++t)
  {
    for (int side = 0; side < 2; ++side)
    {
      Index& region = regions.sides(t, side);
      if (region == None)
      {
        continue;
      }
      isOpen[region] |= !isClosed[region] && !IsDegenerate(triangles, t);
      number[region] = isClosed[region] && number[region] == None ? count++ : number[region];
      region = number[region];
    }
  }
  regions.count = count;
  regions.open = static_cast<Index>(std::count(isOpen.begin(), isOpen.end(), 1));
}
}

EnclosedRegions FindEnclosedRegions(
  const Triangles& triangles, const std::vector<Index>& component, const TriangleLabels& labels)
{
  if (component.empty())
  {
    return EnclosedRegions{ 0, Sides(triangles.rows(), 2), 0 };
  }
  EnclosedRegions regions = LabelRegions(triangles, component, labels);
  if (labels.cols() < 2)
  {
    JoinOpenRegions(triangles, component, regions);
  }
  RemoveOpenRegions(triangles, regions);
  return regions;
}

bool RegionVolumes::IsSignificant(Index region) const
{
  constexpr double roundOff = 1e-9;
  return std::abs(this->volume[region]) > roundOff * this->magnitude[region];
}

RegionVolumes MeasureVolumes(
  const Points& V, const Triangles& triangles, const EnclosedRegions& regions)
{
  RegionVolumes volumes{ Vector::Zero(regions.count), Vector::Zero(regions.count) };
  std::vector<Index> origin(regions.count, -1); // near the region, where less is rounded
  for (Index t = 0; t < static_cast<Index>(triangles.rows()); ++t)
  {
    for (int side = 0; side < 2; ++side)
    {
      const Index region = regions.sides(t, side);
      if (region == None || IsDegenerate(triangles, t))
      {
        continue;
      }
      origin[region] = origin[region] < 0 ? triangles(t, 0) : origin[region];
      const double term = VolumeTo(V.row(origin[region]), V, triangles, t);
      volumes.volume[region] += side == 0 ? term : -term;
      volumes.magnitude[region] += std::abs(term);
    }
  }
  return volumes;
}
}
