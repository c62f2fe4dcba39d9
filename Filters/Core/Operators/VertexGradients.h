// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_VertexGradients_h
#define lmo_VertexGradients_h

#include "Core/Mesh/MeshTopology.h"

#include <algorithm>

namespace lmo
{
/// Gradients of fields on a surface, in the tangent planes of its vertices: the g that minimises
///   sum_j (g . d_j - (f_j - f_i))^2 / |x_j - x_i|^2
/// over the other corners j of the triangles at vertex i, once for each triangle, where d_j is the
/// part of x_j - x_i in the tangent plane. Exact for linear fields on a plane.
class VertexGradients
{
public:
  /// \param V a row for each vertex; referred to, as are the others
  VertexGradients(const Points& V, const Triangles& triangles, const AdjacencyLists& cornersAt);

  /// False where the neighbours lie in one direction only, and no gradient is defined.
  bool IsDefined(Index i) const { return this->Defined[i] != 0; }

  /// The gradient at vertex i, 0 where it is not defined.
  /// \param field field(j) is the value at vertex j
  template <typename Field>
  Vector3 At(Index i, const Field& field) const
  {
    Vector3 sum = Vector3::Zero();
    const double value = field(i);
    this->VisitNeighbours(
      i, [&](Index j, const Vector3& d, double weight) { sum += weight * (field(j) - value) * d; });
    return sum * this->Inverses.middleRows<3>(Eigen::Index(3) * i);
  }

  /// The gradient scaled by a factor of at most 1, such that f_i + g . (x - x_i) / 2 stays within
  /// the values of the neighbours and f_i in all triangles at the vertex (as T. J. Barth and
  /// D. C. Jespersen, 1989, limit gradients). A linear field keeps its gradient.
  template <typename Field>
  Vector3 LimitedAt(Index i, const Field& field) const
  {
    const Vector3 gradient = this->At(i, field);
    double highest = 0; // in terms of f_i
    double lowest = 0;
    double rise = 0;
    double fall = 0;
    this->VisitNeighbours(i,
      [&](Index j, const Vector3& d, double)
      {
        const double difference = field(j) - field(i);
        highest = std::max(highest, difference);
        lowest = std::min(lowest, difference);
        rise = std::max(rise, gradient.dot(d) / 2);
        fall = std::min(fall, gradient.dot(d) / 2);
      });
    const double factor =
      std::min(rise > highest ? highest / rise : 1, fall < lowest ? lowest / fall : 1);
    return factor * gradient;
  }

private:
  /// Calls visit(j, d_j, 1 / |x_j - x_i|^2) for the other corners of the triangles at vertex i.
  template <typename Visit>
  void VisitNeighbours(Index i, const Visit& visit) const
  {
    const Vector3 normal = this->Normals.row(i);
    for (const Index corner : this->CornersAt[i])
    {
      for (const Index other : { NextCorner(corner), PreviousCorner(corner) })
      {
        const Index j = this->T.data()[other];
        const Vector3 edge = this->V.row(j) - this->V.row(i);
        const double squared = edge.squaredNorm();
        if (squared > 0)
        {
          visit(j, Vector3(edge - edge.dot(normal) * normal), 1 / squared);
        }
      }
    }
  }

  void Invert(Index i);

  const Points& V;
  const Triangles& T;
  const AdjacencyLists& CornersAt;
  Points Normals;
  Points Inverses; ///< three rows for each vertex: of the matrix of its least-squares problem
  Mask Defined;
};
}

#endif
