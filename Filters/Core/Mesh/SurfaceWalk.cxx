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
  ClosestTriangle(const WalkableSurface& surface, const Vector3& x)
    : Surface(surface)
    , X(x)
  {
  }

  Index Get() const { return this->Closest; }

  /// Barycentric coordinates of the closest point of that triangle.
  const Vector3& GetWeights() const { return this->Weights; }

  /// Looks at the triangles at a vertex.
  void VisitVertex(Index i)
  {
    const auto& [V, T, cornersAt] = this->Surface;
    const Vector3 here = V.row(i);
    const Vector3 direction = this->X - here;
    for (const Index corner : cornersAt[i])
    {
      const Vector3 next = V.row(T.data()[NextCorner(corner)]);
      const Vector3 previous = V.row(T.data()[PreviousCorner(corner)]);
      // The weights of the corner, the next, and the previous one.
      Vector3 weights(1, 0, 0);
      if (direction.dot(next - here) > 0 || direction.dot(previous - here) > 0)
      {
        weights = ClosestBarycentricCoordinates(this->X, here, next, previous);
      }
      const Vector3 closest = here + weights[1] * (next - here) + weights[2] * (previous - here);
      const double squared = (closest - this->X).squaredNorm();
      if (squared < this->SquaredDistance)
      {
        this->SquaredDistance = squared;
        this->Closest = corner / 3;
        for (int k = 0; k < 3; ++k)
        {
          this->Weights[(corner + k) % 3] = weights[k];
        }
      }
    }
  }

private:
  const WalkableSurface Surface;
  const Vector3 X;
  Index Closest = -1;
  Vector3 Weights = Vector3::Zero();
  double SquaredDistance = std::numeric_limits<double>::infinity();
};
}

SurfaceLocation WalkToClosestPoint(const WalkableSurface& surface, Index vertex, const Vector3& x)
{
  const AdjacencyLists& cornersAt = surface.cornersAt;
  SurfaceLocation location;
  ClosestTriangle closest(surface, x);
  closest.VisitVertex(vertex);
  while (closest.Get() != location.triangle)
  {
    location = { closest.Get(), closest.GetWeights() };
    const bool isInside =
      location.weights.minCoeff() > 0; // then it is closer than what is beside it
    for (int k = 0; k < 3 && !isInside; ++k)
    {
      const Index i = surface.triangles(location.triangle, k);
      // Triangles that meet the closest point; the walk goes around vertices of high valence by the
      // corners opposite.
      const bool isThere = location.weights[k] > 0 || cornersAt.Size(vertex) > LargestStar;
      if (isThere && i != vertex && cornersAt.Size(i) <= LargestStar)
      {
        closest.VisitVertex(i);
      }
    }
  }
  return location;
}
}
