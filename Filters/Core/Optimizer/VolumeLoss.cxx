// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Optimizer/VolumeLoss.h"

#include "Core/Optimizer/EnclosedRegions.h"

#include <algorithm>

namespace lmo
{
namespace
{
void Count(VolumeLoss& loss, double change)
{
  ++loss.closed;
  loss.shrunk += change > LargestVolumeChange;
  loss.largest = std::max(loss.largest, change);
}
}

VolumeLoss MeasureVolumeLoss(const MeshQuantities& mesh, const Points& after)
{
  VolumeLoss loss;
  const EnclosedRegions regions = FindEnclosedRegions(mesh.GetTriangles(), mesh.GetComponents());
  const RegionVolumes before = MeasureVolumes(mesh.GetPoints(), mesh.GetTriangles(), regions);
  const RegionVolumes now = MeasureVolumes(after, mesh.GetTriangles(), regions);
  for (Index k = 0; k < regions.count; ++k)
  {
    if (before.IsSignificant(k))
    {
      Count(loss, 1 - now.volume[k] / before.volume[k]);
    }
  }
  return loss;
}

VolumeLoss VolumeLossOfWhole(const SurfaceComparison& comparison)
{
  VolumeLoss loss;
  if (comparison.relativeVolumeChange != 0)
  {
    Count(loss, -comparison.relativeVolumeChange);
  }
  return loss;
}
}
