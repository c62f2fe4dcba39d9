// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Deviation/SignedDistance.h"

#include "Core/Base/Threading.h"
#include "Core/Mesh/TriangleGeometry.h"
#include "Core/Mesh/TriangleNeighbours.h"

namespace lmo
{
SurfaceSides::SurfaceSides(
  const Points& V, const Triangles& triangles, const MeshTopology& topology)
  : V(V)
  , T(triangles)
  , Topology(topology)
  , VertexNormals(V.rows(), 3)
{
  ParallelFor(
    topology.vertices, [this](Index i) { this->VertexNormals.row(i) = this->OfVertex(i); });
}

Vector3 SurfaceSides::OfTriangle(Index t) const
{
  return ScaledNormal(this->V, this->T, t).stableNormalized();
}

Vector3 SurfaceSides::OfEdge(Index t, int k) const
{
  const Index i = this->T(t, k);
  const Index j = this->T(t, (k + 1) % 3);
  const Index left = NeighbourAcross(this->T, this->Topology, j, i);
  const Index right = NeighbourAcross(this->T, this->Topology, i, j);
  const bool isDefined = left != NoNeighbour && right != NoNeighbour;
  return isDefined ? this->OfTriangle(left) + this->OfTriangle(right) : Vector3(0, 0, 0);
}

Vector3 SurfaceSides::OfVertex(Index i) const
{
  Vector3 sum = Vector3::Zero();
  for (const Index corner : this->Topology.cornersAt[i])
  {
    const Vector3 angles = TriangleAngles(CornersOf(this->V, this->T, corner / 3));
    sum += angles[corner % 3] * this->OfTriangle(corner / 3);
  }
  return sum;
}

double SurfaceSides::SideOf(const Vector3& x, Index closest) const
{
  const TriangleCorners corners = CornersOf(this->V, this->T, closest);
  const Vector3 weights =
    ClosestBarycentricCoordinates(x, corners.row(0), corners.row(1), corners.row(2));
  Eigen::Index nearest, farthest;
  weights.maxCoeff(&nearest);
  weights.minCoeff(&farthest);
  const Eigen::Index others = (weights.array() > 0).count();
  Vector3 normal = Vector3::Zero();
  if (others == 3)
  {
    normal = this->OfTriangle(closest);
  }
  else if (others == 2)
  {
    normal = this->OfEdge(closest, static_cast<int>(farthest + 1) % 3);
  }
  // Triangles without area have no normal; that of a corner says more than none.
  if (normal.isZero(0))
  {
    normal = this->VertexNormals.row(this->T(closest, nearest));
  }
  // All three are perpendicular to their part of the surface: any point of it will do.
  return normal.dot(x - corners.row(nearest)) < 0 ? -1 : 1;
}

std::optional<Vector> SignedDistances(const Points& points, const Vector& distances,
  const std::vector<Index>& closest, const Points& referenceV, const Triangles& referenceTriangles,
  ProgressMonitor& monitor)
{
  const MeshTopology topology =
    BuildTopology(static_cast<Index>(referenceV.rows()), referenceTriangles);
  if (!IsClosedAndOriented(referenceTriangles, topology))
  {
    return std::nullopt;
  }
  const SurfaceSides sides(referenceV, referenceTriangles, topology);
  const double front = IsInsideOut(referenceV, referenceTriangles, topology) ? -1 : 1;
  Vector result(points.rows());
  InterruptibleFor(static_cast<Index>(points.rows()), monitor,
    [&](Index i)
    {
      const double side = closest[i] < 0 ? front : sides.SideOf(points.row(i), closest[i]);
      result[i] = front * side * distances[i];
    });
  return result;
}
}
