// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_SurfaceComparison_h
#define lmo_SurfaceComparison_h

#include "Core/Mesh/TriangleQuality.h"

#include <Eigen/Geometry>

#include <memory>

namespace lmo
{
/// What an optimisation did to the surface: the metrics of Fig. 5 and some more.
struct SurfaceComparison
{
  std::shared_ptr<const MeshQuality> before = std::make_shared<MeshQuality>(); ///< not null
  MeshQuality after;
  double maximumDisplacement = 0;         ///< in the unit of the mesh
  double relativeMaximumDisplacement = 0; ///< divided by the bounding-box diagonal of \a before
  bool isClosed = false;                  ///< and has a volume
  double relativeVolumeChange = 0;        ///< (after - before) / |before|; 0 for an open surface
  std::int64_t triangles = 0;             ///< number of them
  std::int64_t flippedTriangles = 0;      ///< HasTurnedOver()
};

/// The largest distance that a vertex has moved. The Hausdorff distance of the surfaces is at most
/// that, since every point of a triangle moves no farther than its corners.
double LargestDisplacement(const Points& before, const Points& after, const Subdomain& subdomain);

/// \param quality of \a before
/// \param box of \a before
/// \param isClosed the whole surface, of which this may be a part
SurfaceComparison CompareSurfaces(const Points& before, const Points& after,
  const Triangles& triangles, const MeshTopology& topology,
  std::shared_ptr<const MeshQuality> quality, const Eigen::AlignedBox3d& box, bool isClosed,
  const Subdomain& subdomain);
}

#endif
