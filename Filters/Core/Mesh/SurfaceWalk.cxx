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

  /// Looks at the triangle at a vertex over which x lies, and at those beside it.
  /// \return true if x is closer to it than to the others at the vertex, but for those that fold
  /// back over it by more than 90 degrees
  bool VisitTriangleBelow(Index i)
  {
    const Index* corners = this->Surface.triangles.data();
    const Vector3 here = this->Surface.V.row(i);
    const Vector3 direction = this->X - here;
    const auto spokeTo = [&](Index j)
    {
      const Vector3 edge = this->Surface.V.row(j) - here;
      return Spoke{ j, edge, edge.squaredNorm(), direction.dot(edge) };
    };
    Spoke previous; // that of one triangle of a fan is the next of the following one
    for (const Index corner : this->Surface.cornersAt[i])
    {
      const Index end = corners[NextCorner(corner)];
      const Spoke next = end == previous.end ? previous : spokeTo(end);
      previous = spokeTo(corners[PreviousCorner(corner)]);
      const double product = next.edge.dot(previous.edge);
      // The projection of x is the corner and these multiples of the edges, divided by the area.
      const double ofNext = next.along * previous.squaredLength - previous.along * product;
      const double ofPrevious = previous.along * next.squaredLength - next.along * product;
      if (ofNext > 0 && ofPrevious > 0)
      {
        const CornerEdges edges{ next.edge, previous.edge };
        const double squares = next.squaredLength * previous.squaredLength;
        const double area = squares - product * product; // its square, times 4
        constexpr double thin = 1e-3;                    // costs three digits
        if (ofNext + ofPrevious >= area || area < thin * squares)
        {
          return false;
        }
        this->Keep(corner, { 1 - (ofNext + ofPrevious) / area, ofNext / area, ofPrevious / area },
          edges, direction);
        return this->IsFarFromOthers(corner, edges, direction, area);
      }
    }
    return false;
  }

  /// Looks at the triangles at a vertex.
  void VisitVertex(Index i)
  {
    const Vector3 direction = this->X - Vector3(this->Surface.V.row(i));
    for (const Index corner : this->Surface.cornersAt[i])
    {
      this->Visit(corner, this->EdgesOf(i, corner), direction);
    }
  }

private:
  /// From a corner to the next and the previous one.
  struct CornerEdges
  {
    Vector3 next;
    Vector3 previous;
  };

  /// The edge from a vertex to a neighbour.
  struct Spoke
  {
    Index end = -1;
    Vector3 edge = Vector3::Zero();
    double squaredLength = 0;
    double along = 0; ///< its product with the direction to x
  };

  CornerEdges EdgesOf(Index i, Index corner) const
  {
    const auto& [V, T, cornersAt] = this->Surface;
    return { V.row(T.data()[NextCorner(corner)]) - V.row(i),
      V.row(T.data()[PreviousCorner(corner)]) - V.row(i) };
  }

  /// \param direction from the corner to x
  void Visit(Index corner, const CornerEdges& edges, const Vector3& direction)
  {
    // The weights of the corner, the next, and the previous one.
    Vector3 weights(1, 0, 0);
    if (direction.dot(edges.next) > 0 || direction.dot(edges.previous) > 0)
    {
      weights =
        ClosestBarycentricCoordinates(direction, Vector3::Zero(), edges.next, edges.previous);
    }
    this->Keep(corner, weights, edges, direction);
  }

  /// Keeps the place with these weights if it is the closest one so far.
  void Keep(
    Index corner, const Vector3& weights, const CornerEdges& edges, const Vector3& direction)
  {
    const Vector3 closest = weights[1] * edges.next + weights[2] * edges.previous;
    const double squared = (closest - direction).squaredNorm();
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

  /// Looks at the triangles beside the one of the corner that is the closest so far.
  /// \param area its square, times 4
  bool IsFarFromOthers(
    Index corner, const CornerEdges& edges, const Vector3& direction, double area)
  {
    const auto isFar = [&](double weight, const Vector3& edge)
    { return weight * weight * area > this->SquaredDistance * edge.squaredNorm(); };
    const double atNext = this->Weights[(corner + 1) % 3];
    const double atPrevious = this->Weights[(corner + 2) % 3];
    const double toCorner = (atNext * edges.next + atPrevious * edges.previous).squaredNorm();
    if (toCorner <= this->SquaredDistance)
    {
      return false;
    }
    // What is farther from the closest point than x cannot be closer to x.
    if (isFar(atNext, edges.previous) && isFar(atPrevious, edges.next))
    {
      return true;
    }
    const Index* corners = this->Surface.triangles.data();
    const Index i = corners[corner];
    for (const Index other : this->Surface.cornersAt[i])
    {
      if (corners[NextCorner(other)] == corners[PreviousCorner(corner)] ||
          corners[PreviousCorner(other)] == corners[NextCorner(corner)])
      {
        this->Visit(other, this->EdgesOf(i, other), direction);
      }
    }
    return this->Closest == corner / 3;
  }

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
  if (closest.VisitTriangleBelow(vertex))
  {
    return { closest.Get(), closest.GetWeights() };
  }
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
