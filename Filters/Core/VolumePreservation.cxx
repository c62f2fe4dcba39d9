// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumePreservation.h"

#include "Parallel.h"
#include "TriangleGeometry.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace lmo
{
namespace
{
constexpr int MostNewtonSteps = 20;
constexpr double Tolerance = 1e-13;

/// Volume of each component and, in moved + h * direction, its derivative for h.
struct Volumes
{
  std::vector<double> volume;
  std::vector<double> derivative;

  Volumes(const Points& V, const Points& direction, const Triangles& triangles,
    const std::vector<Index>& component, Index components)
    : volume(components, 0)
    , derivative(components, 0)
  {
    std::vector<Index> origin(components, -1);
    for (Index t = 0; t < static_cast<Index>(triangles.rows()); ++t)
    {
      if (IsCollapsed(triangles, t))
      {
        continue;
      }
      const Index k = component[triangles(t, 0)];
      origin[k] = origin[k] < 0 ? triangles(t, 0) : origin[k];
      const Vector3 o = V.row(origin[k]);
      const Vector3 a = V.row(triangles(t, 0)) - o;
      const Vector3 b = V.row(triangles(t, 1)) - o;
      const Vector3 c = V.row(triangles(t, 2)) - o;
      this->volume[k] += a.dot(b.cross(c)) / 6;
      const Vector3 motion = direction.row(triangles(t, 0)) + direction.row(triangles(t, 1)) +
                             direction.row(triangles(t, 2));
      this->derivative[k] += ScaledNormal(V, triangles, t).dot(motion) / 6;
    }
  }
};

/// The components with triangles and without a boundary.
Mask ClosedComponents(
  const MeshTopology& topology, const std::vector<Index>& component, Index components)
{
  Mask isClosed(components, false);
  for (Index i = 0; i < topology.vertices; ++i)
  {
    isClosed[component[i]] = topology.isUsed[i];
  }
  for (Index i = 0; i < topology.vertices; ++i)
  {
    isClosed[component[i]] = isClosed[component[i]] && !topology.isBoundary[i];
  }
  return isClosed;
}
}

void RestoreVolumes(const Points& V, const Triangles& triangles, const MeshTopology& topology,
  const std::vector<Index>& component, const MotionConstraints& motion, Points& moved)
{
  const Index components =
    component.empty() ? 0 : *std::max_element(component.begin(), component.end()) + 1;
  const Mask isClosed = ClosedComponents(topology, component, components);
  Points direction = VertexNormals(moved, triangles, topology);
  ParallelFor(topology.vertices,
    [&](Index i)
    {
      if (motion.freedom[i] != MotionConstraints::FREE || !isClosed[component[i]])
      {
        direction.row(i).setZero();
      }
    });
  const std::vector<double> target = Volumes(V, direction, triangles, component, components).volume;
  for (int step = 0; step < MostNewtonSteps; ++step)
  {
    const Volumes now(moved, direction, triangles, component, components);
    Vector offset = Vector::Zero(components);
    for (Index k = 0; k < components; ++k)
    {
      const double missing = target[k] - now.volume[k];
      if (std::abs(missing) > Tolerance * std::abs(target[k]) && now.derivative[k] != 0)
      {
        offset[k] = missing / now.derivative[k];
      }
    }
    if (offset.isZero(0))
    {
      break;
    }
    ParallelFor(
      topology.vertices, [&](Index i) { moved.row(i) += offset[component[i]] * direction.row(i); });
  }
}
}
