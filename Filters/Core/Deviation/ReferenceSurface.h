// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_ReferenceSurface_h
#define lmo_ReferenceSurface_h

#include "Core/Deviation/DeviationCertificates.h"
#include "Core/Mesh/MeshTopology.h"

namespace lmo
{
/// The surface that a mesh has to stay near. Its parts are kept by somebody else.
struct ReferenceSurface
{
  const Points& V;
  const Triangles& T;
  const MeshTopology& topology;
};

/// What is known of a mesh that is a part of a surface of which the rest has moved already.
struct PartOfSurface
{
  Points original; ///< where the vertices were before; no rows if that is where they are
  Mask isSettled;  ///< triangles that stay, and of which others know the distance; empty: none
};

/// Certifies that each triangle of one mesh is near another mesh before anything moves: within the
/// distance, or else within a limit of its own, hardly larger than how far it is.
/// \param certificates those of \a from, with any seeds
/// \param isSettled triangles of \a from that need no certificate; empty: none
/// \param tree of \a to, which has triangles
/// \return the limits
/// \throw Cancelled if the monitor says so.
DistanceLimits CertifyInput(DeviationCertificates& certificates, const SurfaceView& from,
  const Mask& isSettled, const SurfaceView& to, TriangleBvh& tree, double distance,
  ProgressMonitor& monitor);

/// For each triangle of \a from, the triangle of the tree that is closest to its centre.
/// \throw Cancelled if the monitor says so.
std::vector<Index> FindSeeds(
  const SurfaceView& from, const TriangleBvh& tree, ProgressMonitor& monitor);

/// How far the vertices of a mesh that begins partly beyond the distance may be from the reference:
/// the distance, or as far as they began.
class VertexLimits
{
public:
  VertexLimits() = default;

  /// \param tree of the reference
  /// \throw Cancelled if the monitor says so.
  VertexLimits(const Points& V, const TriangleBvh& tree, double distance, ProgressMonitor& monitor);

  /// True if a vertex would be farther away than it may be.
  bool IsExceeded(Index vertex, const Vector3& position, const TriangleBvh& tree) const;

private:
  std::vector<double> Squared; ///< of each vertex; empty if there are no limits
};
}

#endif
