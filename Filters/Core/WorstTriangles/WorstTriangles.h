// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_WorstTriangles_h
#define lmo_WorstTriangles_h

#include "Core/Base/ProgressMonitor.h"
#include "Core/WorstTriangles/VertexPlaces.h"

namespace lmo
{
/// Triangles with a smaller t are bad.
constexpr double BadQuality = 0.45;

/// Moves single vertices where that raises the minimum of t around them and the guard accepts it:
/// first those of all bad triangles, then those of the worst ones, as long as the least t rises.
/// What the least-squares problem cannot do, since it knows averages. Each vertex goes where
/// StarSearch finds the greatest minimum, in the directions that \a constraints allows; up to t =
/// 0.5 it is lifted off its tangent plane where nothing else helps and where mesh and reference are
/// not flat. Vertices that are distant from each other (DistantVertices) move at once, and the
/// result does not depend on the number of threads. t_mean falls by 0.002 at most.
/// The effort of proofs is limited to 1.9 times that which the guard has spent before, with 60,000
/// more.
/// \throw Cancelled if the monitor says so; the guard has accepted what was done by then.
void ImproveWorstTriangles(DeviationGuard& guard, const Triangles& triangles,
  const MeshTopology& topology, const DisplacementConstraints& constraints,
  const PlaceVertex& place, ProgressMonitor& monitor);
}

#endif
