// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Mesh/SurfaceWalk.h"

#include "Core/Mesh/TriangleGeometry.h"

#include <limits>

namespace lmo
{
namespace
{
/// The closest triangle found so far.
class ClosestTriangle
{
public:
  ClosestTriangle(
    const Points& V, const Triangles& triangles, const AdjacencyLists& cornersAt, const Vector3& x)
    : V(V)
    , T(triangles)
    , CornersAt(cornersAt)
    , X(x)
  {
  }

  Index Get() const { return this->Closest; }

  /// Looks at the triangles at a vertex.
  void VisitVertex(Index i)
  {
    for (const Index corner : this->CornersAt[i])
    {
      const TriangleCorners abc = CornersOf(this->V, this->T, corner / 3);
      const double squared =
        (ClosestPointOnTriangle(this->X, abc.row(0), abc.row(1), abc.row(2)) - this->X)
          .squaredNorm();
      if (squared < this->SquaredDistance)
      {
        this->SquaredDistance = squared;
        this->Closest = corner / 3;
      }
    }
  }

private:
  const Points& V;
  const Triangles& T;
  const AdjacencyLists& CornersAt;
  const Vector3 X;
  Index Closest = -1;
  double SquaredDistance = std::numeric_limits<double>::infinity();
};
}

SurfaceLocation WalkToClosestPoint(const Points& V, const Triangles& triangles,
  const AdjacencyLists& cornersAt, Index vertex, const Vector3& x)
{
  SurfaceLocation location;
  ClosestTriangle closest(V, triangles, cornersAt, x);
  closest.VisitVertex(vertex);
  while (closest.Get() != location.triangle)
  {
    location.triangle = closest.Get();
    for (int k = 0; k < 3; ++k)
    {
      const Index i = triangles(location.triangle, k);
      if (cornersAt.Size(i) <= LargestStar) // the walk goes around others by the corners opposite
      {
        closest.VisitVertex(i);
      }
    }
  }
  if (location.triangle >= 0)
  {
    const TriangleCorners abc = CornersOf(V, triangles, location.triangle);
    location.weights = ClosestBarycentricCoordinates(x, abc.row(0), abc.row(1), abc.row(2));
  }
  return location;
}
}
