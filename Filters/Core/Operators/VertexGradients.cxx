// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Operators/VertexGradients.h"

#include "Core/Base/Threading.h"
#include "Core/Mesh/TriangleGeometry.h"

#include <Eigen/LU>

namespace lmo
{
VertexGradients::VertexGradients(
  const Points& V, const Triangles& triangles, const AdjacencyLists& cornersAt)
  : V(V)
  , T(triangles)
  , CornersAt(cornersAt)
  , Normals(V.rows(), 3)
  , Inverses(Points::Zero(3 * V.rows(), 3))
  , Defined(V.rows(), 0)
{
  ParallelFor(static_cast<Index>(V.rows()), [this](Index i) { this->Invert(i); });
}

void VertexGradients::Invert(Index i)
{
  Vector3 normal = Vector3::Zero();
  for (const Index corner : this->CornersAt[i])
  {
    normal += ScaledNormal(this->V, this->T, corner / 3);
  }
  this->Normals.row(i) = normal.stableNormalized();
  Matrix3 matrix = Matrix3::Zero();
  this->VisitNeighbours(
    i, [&](Index, const Vector3& d, double weight) { matrix += weight * d.transpose() * d; });
  // Along the normal there is no gradient; any positive entry makes the matrix regular.
  const double trace = matrix.trace();
  matrix += trace * this->Normals.row(i).transpose() * this->Normals.row(i);
  constexpr double smallestShare = 1e-6; // of the determinant that equal directions would have
  if (trace > 0 && matrix.determinant() > smallestShare * trace * trace * trace)
  {
    this->Inverses.middleRows<3>(Eigen::Index(3) * i) = matrix.inverse();
    this->Defined[i] = 1;
  }
}
}
