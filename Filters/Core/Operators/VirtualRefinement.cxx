// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Operators/VirtualRefinement.h"

#include <Eigen/LU>

#include <algorithm>

namespace lmo
{
namespace
{
/// Least distance of a virtual vertex from the edges, as a share of 2 area / perimeter: closer to
/// one, it would make a triangle that is nearly degenerate.
constexpr double LeastDistance = 0.1;

/// Weight of the norm of the virtual vertex's weights beside the squared areas, both in units of
/// the polygon's size: so small that it matters only where the areas leave the choice, as in a
/// plane.
constexpr double NormWeight = 1e-12;

/// Values of the virtual vertex are means of those at the corners.
struct VirtualVertex
{
  Vector weights; ///< their sum is 1
  Vector3 position;
};

/// \param corners relative to their centroid, in units of the polygon's size
VirtualVertex FindVirtualVertex(const Eigen::Ref<const Points>& corners)
{
  // The doubled area of the triangle over edge e from corner x to point p is |(x - p) x e|, and the
  // sum of their squares sum (x - p)^T M (x - p) with M = |e|^2 I - e e^T. With p = sum (1/n + u_i)
  // x_i and u = X y, least squares and least norm of u make (M X^T X + NormWeight I) y = sum M x.
  const Eigen::Index size = corners.rows();
  Matrix3 sumOfM = Matrix3::Zero();
  Vector3 sumOfMx = Vector3::Zero();
  for (Eigen::Index k = 0; k < size; ++k)
  {
    const Vector3 x = corners.row(k);
    const Vector3 e = corners.row((k + 1) % size) - corners.row(k);
    sumOfM += e.squaredNorm() * Matrix3::Identity() - e.transpose() * e;
    sumOfMx += e.squaredNorm() * x - x.dot(e) * e;
  }
  const Matrix3 system =
    sumOfM * (corners.transpose() * corners) + NormWeight * Matrix3::Identity();
  const Eigen::Vector3d y = system.partialPivLu().solve(sumOfMx.transpose());
  VirtualVertex result;
  result.weights = (corners * y).array() + 1. / static_cast<double>(size);
  result.position = result.weights.transpose() * corners;
  return result;
}

/// True if the polygon lies around the point, seen along the normal of its area, and the point is
/// not too close to an edge.
bool Surrounds(const Eigen::Ref<const Points>& corners, const Vector3& point)
{
  const Eigen::Index size = corners.rows();
  const auto doubledArea = [&](Eigen::Index k) -> Vector3
  {
    const Vector3 a = corners.row(k) - point;
    const Vector3 b = corners.row((k + 1) % size) - point;
    return a.cross(b);
  };
  Vector3 normal = Vector3::Zero();
  double perimeter = 0;
  for (Eigen::Index k = 0; k < size; ++k)
  {
    normal += doubledArea(k);
    perimeter += (corners.row((k + 1) % size) - corners.row(k)).norm();
  }
  const double least = LeastDistance * normal.squaredNorm() / perimeter;
  for (Eigen::Index k = 0; k < size; ++k)
  {
    const double length = (corners.row((k + 1) % size) - corners.row(k)).norm();
    if (!(doubledArea(k).dot(normal) >= least * length))
    {
      return false;
    }
  }
  return normal.squaredNorm() > 0;
}

}

RefinedPolygon::RefinedPolygon(
  const Points& V, const Index* ids, Index size, const Triangles& triangles, Index firstTriangle)
  : Size(size)
  , Positions(size + 1, 3)
{
  for (Index k = 0; k < size; ++k)
  {
    this->Positions.row(k) = V.row(ids[k]);
  }
  if (size == 3 || !this->Refine())
  {
    this->UseTriangles(triangles, firstTriangle, ids);
  }
}

bool RefinedPolygon::Refine()
{
  Points corners = this->Positions.topRows(this->Size);
  const Vector3 centroid = corners.colwise().mean();
  corners.rowwise() -= centroid;
  const double size = corners.rowwise().norm().maxCoeff();
  if (!(size > 0))
  {
    return false;
  }
  corners /= size;
  VirtualVertex centre = FindVirtualVertex(corners);
  if (!Surrounds(corners, centre.position))
  {
    return false;
  }
  this->Positions.row(this->Size) = centroid + size * centre.position;
  this->Weights = std::move(centre.weights);
  for (Index k = 0; k < this->Size; ++k)
  {
    this->Fan.push_back({ k, (k + 1) % this->Size, this->Size });
  }
  return true;
}

void RefinedPolygon::UseTriangles(const Triangles& triangles, Index first, const Index* ids)
{
  const auto place = [&](Index id)
  { return static_cast<Index>(std::find(ids, ids + this->Size, id) - ids); };
  for (Index t = first; t < first + this->Size - 2; ++t)
  {
    if (!IsDegenerate(triangles, t))
    {
      this->Fan.push_back(
        { place(triangles(t, 0)), place(triangles(t, 1)), place(triangles(t, 2)) });
    }
  }
}

void RefinedPolygon::Distribute(std::vector<double>& values) const
{
  for (Eigen::Index k = 0; k < this->Weights.size(); ++k)
  {
    values[k] += this->Weights[k] * values.back();
  }
}
}
