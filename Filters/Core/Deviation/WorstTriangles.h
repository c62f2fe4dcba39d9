// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_WorstTriangles_h
#define lmo_WorstTriangles_h

#include "Core/Base/ProgressMonitor.h"
#include "Core/Deviation/DeviationGuard.h"
#include "Core/Mesh/DisplacementConstraints.h"

#include <functional>

namespace lmo
{
/// Where a vertex comes to lie that is asked to move to a point: on its feature line, for instance.
using PlaceVertex = std::function<Vector3(Index, const Vector3&)>;

/// Moves the vertices of the worst triangles, one after the other, where that raises the minimum of
/// t around them and the guard accepts it: a pattern search in the directions that \a constraints
/// allows. What the least-squares problem cannot do, since it knows averages. \throw Cancelled if
/// the monitor says so; the guard has accepted what was done by then.
void ImproveWorstTriangles(DeviationGuard& guard, const Triangles& triangles,
  const MeshTopology& topology, const DisplacementConstraints& constraints,
  const PlaceVertex& place, ProgressMonitor& monitor);
}

#endif
