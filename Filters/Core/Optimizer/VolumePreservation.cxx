// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Optimizer/VolumePreservation.h"

#include "Core/Base/Exceptions.h"
#include "Core/Base/Threading.h"
#include "Core/Mesh/TriangleGeometry.h"
#include "Core/Mesh/TriangleNeighbours.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace lmo
{
namespace
{
constexpr int MostNewtonSteps = 100;
constexpr double Tolerance = 1e-12;
constexpr double RoundOff = 1e-14; ///< in terms of what the sum adds and subtracts

/// In the same terms; below that a volume is round-off.
constexpr double SmallestVolume = 1e-9;

/// Volume of each component and its derivative for h in V + h * direction.
struct Volumes
{
  std::vector<double> volume;
  std::vector<double> magnitude; ///< sum of the terms' magnitudes
  std::vector<double> derivative;

  Volumes(const Points& V, const Points& direction, const Triangles& triangles,
    const std::vector<Index>& component, Index components)
    : volume(components, 0)
    , magnitude(components, 0)
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
      const double term = VolumeTo(V.row(origin[k]), V, triangles, t);
      this->volume[k] += term;
      this->magnitude[k] += std::abs(term);
      const Vector3 motion = direction.row(triangles(t, 0)) + direction.row(triangles(t, 1)) +
                             direction.row(triangles(t, 2));
      this->derivative[k] += ScaledNormal(V, triangles, t).dot(motion) / 6;
    }
  }
};

/// The components whose triangles all have a neighbour of the same orientation at each edge.
Mask ClosedComponents(const Triangles& triangles, const MeshTopology& topology,
  const std::vector<Index>& component, Index components)
{
  const Triangles neighbours = FindTriangleNeighbours(triangles, topology);
  Mask isClosed(components, false);
  for (Index i = 0; i < topology.vertices; ++i)
  {
    isClosed[component[i]] = topology.isUsed[i];
  }
  for (Index t = 0; t < static_cast<Index>(triangles.rows()); ++t)
  {
    if (!IsCollapsed(triangles, t) && neighbours.row(t).minCoeff() == NoNeighbour)
    {
      isClosed[component[triangles(t, 0)]] = false;
    }
  }
  return isClosed;
}

/// Gives each component its volume.
class Restoration
{
public:
  Restoration(const Points& V, const Triangles& triangles, const MeshTopology& topology,
    const std::vector<Index>& component, const DisplacementConstraints& motion, const Points& moved)
    : T(triangles)
    , Component(component)
    , Components(component.empty() ? 0 : *std::max_element(component.begin(), component.end()) + 1)
    , HasVolume(ClosedComponents(triangles, topology, component, this->Components))
    , Direction(VertexNormals(moved, triangles, topology))
    , Target(this->VolumesOf(V))
  {
    for (Index k = 0; k < this->Components; ++k)
    {
      this->HasVolume[k] = this->HasVolume[k] && std::abs(this->Target.volume[k]) >
                                                   SmallestVolume * this->Target.magnitude[k];
    }
    ParallelFor(topology.vertices,
      [&](Index i)
      {
        if (motion.freedom[i] != DisplacementConstraints::FREE || !this->HasVolume[component[i]])
        {
          this->Direction.row(i).setZero();
        }
      });
  }

  /// Newton's method for the offset of each component.
  void Run(Points& moved) const
  {
    for (int step = 0; step < MostNewtonSteps; ++step)
    {
      const Volumes now = this->VolumesOf(moved);
      if (this->CountOpen(now) == 0)
      {
        return;
      }
      ParallelFor(static_cast<Index>(moved.rows()),
        [&](Index i)
        {
          const Index k = this->Component[i];
          if (this->IsOpen(now, k))
          {
            const double offset = (this->Target.volume[k] - now.volume[k]) / now.derivative[k];
            moved.row(i) += offset * this->Direction.row(i);
          }
        });
    }
    this->Check(moved);
  }

private:
  Volumes VolumesOf(const Points& V) const
  {
    return { V, this->Direction, this->T, this->Component, this->Components };
  }

  /// True if the component has not got its volume yet; NaN is none.
  bool IsOpen(const Volumes& now, Index k) const
  {
    const double missing = std::abs(this->Target.volume[k] - now.volume[k]);
    const double allowed =
      Tolerance * std::abs(this->Target.volume[k]) + RoundOff * this->Target.magnitude[k];
    return this->HasVolume[k] && !(missing <= allowed);
  }

  Index CountOpen(const Volumes& now) const
  {
    Index count = 0;
    for (Index k = 0; k < this->Components; ++k)
    {
      count += this->IsOpen(now, k);
    }
    return count;
  }

  void Check(const Points& moved) const
  {
    if (const Index open = this->CountOpen(this->VolumesOf(moved)))
    {
      throw SolverError("No offset along the normals gives " + std::to_string(open) +
                        (open == 1 ? " component" : " components") +
                        " the volume back: smoothing has left too little of the shape. Raise "
                        "ScaleFactor or DetailWeight, or switch PreserveVolume off.");
    }
  }

  const Triangles& T;
  const std::vector<Index>& Component;
  const Index Components;
  Mask HasVolume;
  Points Direction; ///< unit normals, 0 where a vertex stays
  const Volumes Target;
};
}

void RestoreVolumes(const Points& V, const Triangles& triangles, const MeshTopology& topology,
  const std::vector<Index>& component, const DisplacementConstraints& motion, Points& moved)
{
  Restoration(V, triangles, topology, component, motion, moved).Run(moved);
}
}
