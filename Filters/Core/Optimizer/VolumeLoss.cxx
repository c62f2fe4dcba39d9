// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Optimizer/VolumeLoss.h"

#include "Core/Base/Threading.h"
#include "Core/Mesh/TriangleGeometry.h"

#include <algorithm>
#include <cmath>

namespace lmo
{
namespace
{
/// Shares of volume and area below this are round-off.
constexpr double RoundOff = 1e-6;

/// More components are summed one after the other.
constexpr Index MostParallelComponents = 8;

/// Sums over the triangles of a component.
struct ComponentSums
{
  double before = 0;    ///< volume
  double after = 0;     ///< volume
  double magnitude = 0; ///< of the terms of the volume before
  Vector3 normal = Vector3::Zero();
  double area = 0; ///< twice the area

  /// The triangles' normals of a closed surface of one orientation cancel.
  bool HasVolume() const
  {
    return this->normal.norm() <= RoundOff * this->area &&
           std::abs(this->before) > RoundOff * this->magnitude;
  }

  double Loss() const { return (this->before - this->after) / this->before; }
};

struct SumsOfAll
{
  std::vector<ComponentSums> components;

  void operator+=(const SumsOfAll& other)
  {
    for (std::size_t k = 0; k < this->components.size(); ++k)
    {
      ComponentSums& sums = this->components[k];
      sums.before += other.components[k].before;
      sums.after += other.components[k].after;
      sums.magnitude += other.components[k].magnitude;
      sums.normal += other.components[k].normal;
      sums.area += other.components[k].area;
    }
  }
};

SumsOfAll SumComponents(const MeshQuantities& mesh, const Points& after)
{
  const Points& V = mesh.GetPoints();
  const Triangles& T = mesh.GetTriangles();
  const std::vector<Index>& component = mesh.GetComponents();
  SumsOfAll all;
  std::vector<Index> origin;
  for (Index i = 0; i < static_cast<Index>(component.size()); ++i)
  {
    if (component[i] == static_cast<Index>(origin.size()))
    {
      origin.push_back(i);
    }
  }
  all.components.resize(origin.size());
  const auto add = [&](SumsOfAll& sums, Index t)
  {
    const Index k = component[T(t, 0)];
    if (!IsCollapsed(T, t))
    {
      ComponentSums& sum = sums.components[k];
      const double term = VolumeTo(V.row(origin[k]), V, T, t);
      const Vector3 normal = ScaledNormal(V, T, t);
      sum.before += term;
      sum.after += VolumeTo(V.row(origin[k]), after, T, t);
      sum.magnitude += std::abs(term);
      sum.normal += normal;
      sum.area += normal.norm();
    }
  };
  const auto count = static_cast<Index>(T.rows());
  if (static_cast<Index>(origin.size()) <= MostParallelComponents)
  {
    return ParallelSum(count, all, add);
  }
  for (Index t = 0; t < count; ++t)
  {
    add(all, t);
  }
  return all;
}

void Count(VolumeLoss& loss, double change)
{
  ++loss.closed;
  loss.shrunk += change > LargestVolumeChange;
  loss.largest = std::max(loss.largest, change);
}

}

VolumeLoss MeasureVolumeLoss(const MeshQuantities& mesh, const Points& after)
{
  VolumeLoss loss;
  const MeshTopology& topology = mesh.GetTopology();
  const std::vector<Index>& component = mesh.GetComponents();
  const SumsOfAll sums = SumComponents(mesh, after);
  Mask isOpen(sums.components.size(), 0);
  for (Index i = 0; i < topology.vertices; ++i)
  {
    isOpen[component[i]] |= topology.isBoundary[i];
  }
  for (std::size_t k = 0; k < isOpen.size(); ++k)
  {
    if (!isOpen[k] && sums.components[k].HasVolume())
    {
      Count(loss, sums.components[k].Loss());
    }
  }
  return loss;
}

VolumeLoss VolumeLossOfWhole(const SurfaceComparison& comparison)
{
  VolumeLoss loss;
  if (comparison.relativeVolumeChange != 0)
  {
    Count(loss, -comparison.relativeVolumeChange);
  }
  return loss;
}
}
