// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_NearTriangles_h
#define lmo_NearTriangles_h

#include "Communicator.h"
#include "Core/Mesh/TriangleBvh.h"

#include <array>

namespace lmo
{
using Box3 = Eigen::AlignedBox3d;

/// The corners of a triangle on its way between processes.
using TravellingCorners = std::array<double, 9>;

TravellingCorners CornersOfTriangle(const Points& V, const Triangles& triangles, Index t);

/// The box of a triangle, wider by a distance on all sides.
Box3 WideBoxOf(const Points& V, const Triangles& triangles, Index t, double distance);

/// Tells whether boxes come near one of a list of triangles.
class NearTriangles
{
public:
  explicit NearTriangles(const std::vector<TravellingCorners>& list);

  /// True if the box meets that of a triangle.
  bool IsNear(const Box3& box) const;

private:
  Points V;
  Triangles T;
  TriangleBvh Tree;
};

/// Sends triangles to the processes to which they are near.
/// \param triangles of this process
/// \param reach box of all that this process has, wider by the distance that counts as near; may be
///   empty
/// \return those of the others, with those of this process if \a keepsOwn
std::vector<TravellingCorners> ExchangeNear(const Communicator& comm,
  const std::vector<TravellingCorners>& triangles, const Box3& reach, bool keepsOwn);
}

#endif
