// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_LabelShells_h
#define lmo_LabelShells_h

#include "Core/Base/Types.h"

namespace lmo
{
/// Triangles with the labels of the regions on both sides, which no convention tells apart.
struct LabelShells
{
  std::vector<Index> shell; ///< of each triangle: the lowest triangle that it is connected with
  Mask isTurned; ///< the second label of the triangle is behind it, seen along its normal, if the
                 ///< first is that of the first triangle in its shell
};

/// Connects two triangles if they alone have a label at an edge that they share, such that the
/// label is on the same side of both.
/// \param labels two for each triangle, in any order
LabelShells FindLabelShells(const Triangles& triangles, const TriangleLabels& labels);
}

#endif
