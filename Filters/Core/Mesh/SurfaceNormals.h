// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_SurfaceNormals_h
#define lmo_SurfaceNormals_h

#include "Core/Mesh/Subdomain.h"

namespace lmo
{
/// Normals of the surface at its triangles, for the angles between them.
///
/// A thin triangle (t < 0.1) also counts with the neighbour across a long edge with which it is
/// most flush, and the surface turns at its edges only if both normals say so. The needles of an
/// exact tessellation have a neighbour in their own plane and therefore keep their normals, while
/// the slivers of a scan, whose normals say little, count with a larger triangle. A triangle whose
/// height is round-off has only the normal of a neighbour.
class SurfaceNormals
{
public:
  /// \param quality t of each triangle
  /// \param angle in radians, by which flush triangles differ at most
  SurfaceNormals(const Points& V, const Triangles& triangles, const MeshTopology& topology,
    const Vector& quality, double angle, const Subdomain& subdomain);

  bool IsThin(Index t) const { return this->Thin[t]; }

  /// Angle between the normals of two triangles, in radians; 0 if one is undefined.
  double Angle(Index s, Index t) const;

  /// Bound of the error of Angle(s, t) by round-off of the coordinates, in radians.
  double Error(Index s, Index t) const { return this->Errors[s] + this->Errors[t]; }

private:
  Points Own;    ///< unit normals of the triangles, 0 where round-off
  Points Joined; ///< unit normals that thin triangles have together with a neighbour
  Vector Errors;
  Mask Thin;
};

/// Round-off of the coordinates: half a unit in the last place of a number in single precision,
/// which they have or had at some time, of the size of the mesh; of the size of the coordinates if
/// they are such numbers.
double RoundOffOf(const Points& V, const MeshTopology& topology, const Subdomain& subdomain);
}

#endif
