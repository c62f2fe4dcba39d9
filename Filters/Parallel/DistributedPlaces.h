// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_DistributedPlaces_h
#define lmo_DistributedPlaces_h

#include "Core/Operators/FieldInterpolation.h"
#include "Core/Operators/MeshQuantities.h"
#include "DistributedSubdomain.h"

namespace lmo
{
/// The places on a distributed surface that are closest to where its vertices have moved, as
/// WalkToClosestPoint() finds them: a walk that leaves the triangles of a process goes on in the
/// one that owns them. All functions are collective.
class DistributedPlaces
{
public:
  /// \param mesh as it was before
  /// \param positions where the points of the piece are now
  DistributedPlaces(
    const MeshQuantities& mesh, const DistributedSubdomain& subdomain, const Points& positions);

  /// True if points of one piece are one vertex and have different values.
  bool HasSeam(const Fields& values) const;

  /// The values of the piece's points at their places; those that did not move keep theirs.
  Fields Interpolate(const Fields& values, Interpolation how) const;

private:
  /// A vertex that asks for its place.
  struct Origin
  {
    int rank;
    Index vertex; ///< its number there
  };

  const PetscSession Session; ///< for the ghosts
  const MeshQuantities& Mesh;
  const DistributedSubdomain& Domain;
  std::vector<SurfaceLocation> Places;        ///< on triangles of this process, for any vertices
  std::vector<Origin> Origins;                ///< of each
  std::vector<std::pair<Index, Index>> Twins; ///< points of the piece that are one vertex
};
}

#endif
