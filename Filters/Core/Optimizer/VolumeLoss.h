// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_VolumeLoss_h
#define lmo_VolumeLoss_h

#include "Core/Deviation/SurfaceComparison.h"
#include "Core/Operators/MeshQuantities.h"

namespace lmo
{
/// A component that changed its volume by more is worth a warning.
constexpr double LargestVolumeChange = 0.1;

/// What happened to the volumes of the connected components.
struct VolumeLoss
{
  Index closed = 0;   ///< components that enclose a volume: closed, of one orientation
  Index shrunk = 0;   ///< those that lost more than a tenth of it
  double largest = 0; ///< the largest loss, divided by the volume before
};

/// \param after positions of the vertices of \a mesh, which is no part of a distributed one
VolumeLoss MeasureVolumeLoss(const MeshQuantities& mesh, const Points& after);

/// The whole surface as one component, for a mesh that is distributed over processes.
VolumeLoss VolumeLossOfWhole(const SurfaceComparison& comparison);
}

#endif
