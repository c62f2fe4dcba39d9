// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_EnclosedRegions_h
#define lmo_EnclosedRegions_h

#include "Core/Mesh/MeshTopology.h"

namespace lmo
{
/// Regions of space that triangles enclose: as many triangles of a region run along an edge in one
/// direction as in the other.
struct EnclosedRegions
{
  using Sides = Eigen::Matrix<Index, Eigen::Dynamic, 2, Eigen::RowMajor>;
  static constexpr Index None = -1;

  Index count = 0;
  Sides sides;    ///< the regions behind and before each triangle, seen along its normal, or None
  Index open = 0; ///< components, or labels of both sides, that enclose nothing
};

/// The regions of a surface. With labels of both sides, a region is what has a label in one of the
/// LabelShells. With one label, it is the triangles of a label in a component if they are closed,
/// and the rest of the component. Without labels, it is the component.
/// \param component connected component of each vertex
/// \param labels a row for each triangle, or none
EnclosedRegions FindEnclosedRegions(const Triangles& triangles, const std::vector<Index>& component,
  const TriangleLabels& labels = TriangleLabels());

/// Volume of each region, and the sum of the magnitudes that were added for it.
struct RegionVolumes
{
  Vector volume;
  Vector magnitude;

  /// False if the volume is round-off.
  bool IsSignificant(Index region) const;
};

/// \param V positions of the vertices
RegionVolumes MeasureVolumes(
  const Points& V, const Triangles& triangles, const EnclosedRegions& regions);
}

#endif
