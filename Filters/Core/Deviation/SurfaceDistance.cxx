// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Deviation/SurfaceDistance.h"

#include "Core/Base/Threading.h"
#include "Core/Deviation/SurfaceSampler.h"
#include "Core/Mesh/MeshTopology.h"
#include "Core/Mesh/TriangleBvh.h"
#include "Core/Mesh/TriangleGeometry.h"

#include <algorithm>
#include <cmath>

namespace lmo
{
namespace
{
/// One of the two surfaces, ready for closest-point queries.
class Surface
{
public:
  /// Keeps references to the arguments.
  Surface(const Points& V, const Triangles& triangles, ProgressMonitor& monitor)
    : V(V)
    , Topology(BuildTopology(static_cast<Index>(V.rows()), triangles))
    , Sampler(V, triangles)
    , Tree(V, triangles, monitor)
  {
  }

  bool IsEmpty() const { return this->Topology.cornersAt.ids.empty(); }
  double Diagonal() const { return BoundingBoxDiagonal(this->V, this->Topology); }

  Points UsedVertices() const
  {
    const Mask& isUsed = this->Topology.isUsed;
    Points used(std::count(isUsed.begin(), isUsed.end(), true), 3);
    Index count = 0;
    for (Index i = 0; i < this->Topology.vertices; ++i)
    {
      if (isUsed[i])
      {
        used.row(count++) = this->V.row(i);
      }
    }
    return used;
  }

  /// No rows if the surface has no area.
  Points Samples(Index count) const
  {
    Points samples(this->Sampler.Area() > 0 ? count : 0, 3);
    ParallelFor(static_cast<Index>(samples.rows()),
      [&](Index k) { samples.row(k) = this->Sampler.Sample(k, count); });
    return samples;
  }

  struct Closest
  {
    Vector distances;
    std::vector<Index> triangles;
  };

  /// The triangle that is closest to each query point, and its distance.
  Closest FindClosest(const Points& queries, ProgressMonitor& monitor) const
  {
    Closest closest{ Vector(queries.rows()), std::vector<Index>(queries.rows()) };
    InterruptibleFor(static_cast<Index>(queries.rows()), monitor,
      [&](Index i)
      {
        const TriangleBvh::Hit hit = this->Tree.FindClosest(queries.row(i));
        closest.distances[i] = std::sqrt(hit.squaredDistance);
        closest.triangles[i] = hit.triangle;
      });
    return closest;
  }

private:
  const Points& V;
  MeshTopology Topology;
  SurfaceSampler Sampler;
  TriangleBvh Tree;
};

/// The distance in one direction.
struct Deviation
{
  double maximum = 0;
  double mean = 0;
};

Deviation MeasureDeviation(
  const Surface& from, const Surface& to, Index samples, ProgressMonitor& monitor)
{
  const Vector atVertices = to.FindClosest(from.UsedVertices(), monitor).distances;
  const Vector atSamples = to.FindClosest(from.Samples(samples), monitor).distances;
  Deviation deviation;
  deviation.maximum = atVertices.maxCoeff();
  if (atSamples.size() > 0)
  {
    deviation.maximum = std::max(deviation.maximum, atSamples.maxCoeff());
    deviation.mean = atSamples.mean();
  }
  return deviation;
}
}

SurfaceDistance MeasureSurfaceDistance(const Points& V, const Triangles& triangles,
  const Points& referenceV, const Triangles& referenceTriangles, Index samples,
  ProgressMonitor& monitor)
{
  const Surface surface(V, triangles, monitor);
  const Surface reference(referenceV, referenceTriangles, monitor);
  SurfaceDistance result;
  result.atVertices = Vector::Zero(V.rows());
  result.closestTriangles.assign(V.rows(), -1);
  result.diagonal = reference.Diagonal();
  if (surface.IsEmpty())
  {
    return result;
  }
  if (reference.IsEmpty())
  {
    throw InputError("The reference surface has no triangles. Connect one that has.");
  }
  Surface::Closest closest = reference.FindClosest(V, monitor);
  result.atVertices = std::move(closest.distances);
  result.closestTriangles = std::move(closest.triangles);
  const Deviation forth = MeasureDeviation(surface, reference, samples, monitor);
  monitor.Report(0.5);
  const Deviation back = MeasureDeviation(reference, surface, samples, monitor);
  result.hausdorff = std::max(forth.maximum, back.maximum);
  result.mean = (forth.mean + back.mean) / 2;
  return result;
}
}
