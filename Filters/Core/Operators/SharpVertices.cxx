// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Operators/SharpVertices.h"

#include "Core/Base/Threading.h"
#include "Core/Mesh/TriangleGeometry.h"

#include <cmath>

namespace lmo
{
Vector NormalAgreement(const Points& V, const Triangles& triangles, const MeshTopology& topology)
{
  Vector agreement = Vector::Ones(topology.vertices);
  ParallelFor(topology.vertices,
    [&](Index i)
    {
      Vector3 sum = Vector3::Zero();
      double angles = 0;
      for (const Index corner : topology.cornersAt[i])
      {
        const Vector3 centre = V.row(i);
        const Vector3 a = V.row(triangles.data()[NextCorner(corner)]) - centre;
        const Vector3 b = V.row(triangles.data()[PreviousCorner(corner)]) - centre;
        const Vector3 normal = a.cross(b);
        const double length = normal.norm();
        if (length > 0)
        {
          const double angle = std::atan2(length, a.dot(b));
          sum += angle / length * normal;
          angles += angle;
        }
      }
      agreement[i] = angles > 0 ? sum.norm() / angles : 1;
    });
  return agreement;
}

Vector SharpVertices(const Points& V, const Triangles& triangles, const MeshTopology& topology)
{
  const double cosine = std::cos(Pi / 6);
  return (NormalAgreement(V, triangles, topology).array() < cosine).cast<double>();
}
}
