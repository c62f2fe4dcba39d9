// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_ResultReview_h
#define lmo_ResultReview_h

#include "Core/Deviation/SelfIntersections.h"
#include "Core/Deviation/SurfaceComparison.h"
#include "Core/Mesh/DisplacementConstraints.h"
#include "Core/Operators/MeshQuantities.h"
#include "Core/Optimizer/OptimizerOptions.h"

#include <string>
#include <vector>

namespace lmo
{
/// How many vertices of the whole mesh may move, and why the others may not; every vertex counts
/// once, at the first of the reasons.
struct VertexFreedom
{
  std::int64_t movable = 0;
  std::int64_t movableWithoutArea = 0; ///< of these, vertices whose triangles all have no area
  std::int64_t unused = 0;             ///< no triangle uses the vertex
  std::int64_t pinned = 0;     ///< in VertexArrays::fixedPoints, to which the selection belongs
  std::int64_t onBoundary = 0; ///< on a boundary that is fixed
  std::int64_t corners = 0;    ///< corners of feature lines, and of a boundary that slides

  void operator+=(const VertexFreedom& other);
};

/// \param constraints what ChooseConstraints() returned
VertexFreedom CountFreedom(const MeshQuantities& mesh, const DisplacementConstraints& constraints,
  const OptimizerOptions& options, const VertexArrays& arrays);

/// Says that no vertex may move, or that those that may have no triangle with area, with counts
/// and the remedy. Empty if neither is so, and for a mesh without vertices.
std::string WarnOfFreedom(const VertexFreedom& freedom);

/// Says how many components SMOOTH_GUIDED did not move and why. Empty if there are none.
std::string WarnOfUnmoved(Index components);

/// Says how many volumes could not be preserved, and the remedy. Empty if there are none.
std::string WarnOfUnpreserved(Index volumes);

/// Says how many pairs of triangles meet that did not before, and the remedy. Empty if there are
/// none.
std::string WarnOfIntersections(const IntersectionReport& report);

/// Says how many triangles began farther away than allowed, and the remedy. Empty if there are
/// none.
/// \param triangles of the surface and of its reference
std::string WarnOfBeyond(Index triangles);

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

/// Says what a solution did to the shape that its user will hardly want, with figures and the
/// remedy, one text for each of these:
/// - OPTIMIZE_TRIANGLES lowered the mean radius ratio;
/// - more than one triangle in a thousand turned by more than a right angle;
/// - smoothing took more than a tenth of its volume from a closed component, or
///   OPTIMIZE_TRIANGLES changed that of a closed surface by more than a tenth.
/// OPTIMIZE_WITHIN_DEVIATION has guarantees instead.
std::vector<std::string> WarnOfDamage(
  const OptimizerOptions& options, const SurfaceComparison& comparison, const VolumeLoss& loss);
}

#endif
