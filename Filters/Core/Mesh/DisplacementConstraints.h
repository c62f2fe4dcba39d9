// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_DisplacementConstraints_h
#define lmo_DisplacementConstraints_h

#include "Core/Base/Types.h"

namespace lmo
{
/// What the vertices may do. A direction of motion that is taken away is eliminated from the
/// unknowns, not penalised.
struct DisplacementConstraints
{
  enum Freedom : unsigned char
  {
    FIXED = 0,
    ALONG_LINE = 1,
    IN_PLANE = 2,
    FREE = 3
  };
  Mask freedom; ///< Freedom of each vertex
  Points
    axes; ///< unit direction of the line or unit normal of the plane; no rows if there are none

  /// Removes the forbidden part of a displacement or force at vertex i.
  Vector3 Project(Index i, const Vector3& x) const
  {
    switch (this->freedom[i])
    {
      case FREE:
        return x;
      case ALONG_LINE:
        return x.dot(this->axes.row(i)) * this->axes.row(i);
      case IN_PLANE:
        return x - x.dot(this->axes.row(i)) * this->axes.row(i);
      default:
        return Vector3::Zero();
    }
  }
};
}

#endif
