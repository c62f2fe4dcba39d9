// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_DisplacementConstraints_h
#define lmo_DisplacementConstraints_h

#include "Core/Base/Types.h"

namespace lmo
{
/// What the vertices may do. A direction in which a vertex may not move is eliminated from the
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
  Vector3 freeAxes = Vector3::Ones(); ///< 1 for each of x, y and z that may change, else 0

  /// Restricts lines and planes to the free axes; to be called when \a axes were set. A line that
  /// leads out of the free axes becomes the axis 0, along which nothing moves, and a plane that
  /// contains them the normal 0.
  void RestrictAxes()
  {
    constexpr double parallel = 1e-9;
    for (Eigen::Index i = 0; i < this->axes.rows() && this->freeAxes != Vector3::Ones(); ++i)
    {
      const Vector3 axis = this->axes.row(i);
      const Vector3 part = axis.cwiseProduct(this->freeAxes);
      const bool isKept =
        this->freedom[i] == ALONG_LINE ? (axis - part).norm() <= parallel : part.norm() > parallel;
      this->axes.row(i) = isKept ? Vector3(part.normalized()) : Vector3(Vector3::Zero());
    }
  }

  /// Removes the forbidden part of a displacement or force at vertex i.
  Vector3 Project(Index i, const Vector3& x) const
  {
    switch (this->freedom[i])
    {
      case FREE:
        return x.cwiseProduct(this->freeAxes);
      case ALONG_LINE:
        return x.dot(this->axes.row(i)) * this->axes.row(i);
      case IN_PLANE:
        return x.cwiseProduct(this->freeAxes) - x.dot(this->axes.row(i)) * this->axes.row(i);
      default:
        return Vector3::Zero();
    }
  }
};
}

#endif
