// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_CandidateMesh_h
#define lmo_CandidateMesh_h

#include "Core/Base/Types.h"

#include <algorithm>
#include <cmath>

namespace lmo
{
/// A mesh with the positions accepted so far and those of a candidate.
struct CandidateMesh
{
  const Triangles& T;
  Points accepted;
  Points candidate;

  bool IsMoved(Index t) const
  {
    return this->candidate.row(this->T(t, 0)) != this->accepted.row(this->T(t, 0)) ||
           this->candidate.row(this->T(t, 1)) != this->accepted.row(this->T(t, 1)) ||
           this->candidate.row(this->T(t, 2)) != this->accepted.row(this->T(t, 2));
  }

  /// The largest displacement of a triangle's corners, and thereby of any of its points.
  double LargestDisplacement(Index t) const
  {
    double largest = 0;
    for (const Index i : { this->T(t, 0), this->T(t, 1), this->T(t, 2) })
    {
      const Vector3 displacement = this->candidate.row(i) - this->accepted.row(i);
      largest = std::max(largest, displacement.squaredNorm());
    }
    return std::sqrt(largest);
  }

  /// Sets the corners of the triangles in one mesh to what they are in the other.
  static void Copy(
    const std::vector<Index>& triangles, const Triangles& T, const Points& from, Points& to)
  {
    for (const Index t : triangles)
    {
      for (const Index i : { T(t, 0), T(t, 1), T(t, 2) })
      {
        to.row(i) = from.row(i);
      }
    }
  }
};
}

#endif
