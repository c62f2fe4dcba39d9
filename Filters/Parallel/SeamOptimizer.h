// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_SeamOptimizer_h
#define lmo_SeamOptimizer_h

#include "SeamSelection.h"

namespace lmo
{
/// A vertex on its way back from process 0.
struct MovedVertex
{
  std::int64_t row;
  double position[3];
  double positionWeight;
  double laplacianWeight;
};

/// What process 0 made of the seam.
struct SeamResult
{
  PerProcess<MovedVertex> moved;  ///< for the process that owns each
  ModeResult report;              ///< without positions and weights
  std::int64_t pairsBefore = 0;   ///< of triangles of different processes that met at first
  std::vector<RowTriple> meeting; ///< triangles that are in such a pair now
  std::int64_t pairsAfter = 0;
  bool areSeparate = true; ///< no pieces moved into one another before the seam was optimised
};

/// OPTIMIZE_WITHIN_DEVIATION of the seam, in one process.
/// \param part what all processes sent
/// \param plan of this process's part of the mesh, for what does not depend on vertices
/// \param maximum the distance that was asked for, as a length
SeamResult OptimizeSeam(
  SeamPart part, const RunPlan& plan, double maximum, int processes, ProgressMonitor& monitor);
}

#endif
