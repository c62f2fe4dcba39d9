// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_IntrinsicTriangulation_h
#define lmo_IntrinsicTriangulation_h

#include "Core/Base/Types.h"

namespace lmo
{
/// A closed surface glued from triangles of which the edge lengths are known, not the place in
/// space. Side 3 t + k of triangle t leads from its corner k to the next. Two sides may belong to
/// one triangle, and an edge may return to its vertex.
struct IntrinsicTriangulation
{
  std::vector<Index> tails;    ///< vertex from which each side leads
  std::vector<Index> twins;    ///< side that each is glued to, which leads back
  std::vector<double> lengths; ///< of each side, in unit
  double unit = 0;             ///< mean length of the sides of the mesh

  Index Size() const { return static_cast<Index>(this->twins.size()); }

  /// cot alpha + cot beta of the two angles opposite to the edge of a side, each at most
  /// MaximumCotangent in magnitude and 0 in a triangle without area.
  double CotangentSum(Index side) const;
};

/// The tufted cover (Sharp and Crane 2020, "A Laplacian for Nonmanifold Triangle Meshes"): two
/// copies of each triangle, its front and its back, glued so that each edge has two triangles.
/// Around an edge of three and more triangles in space, facing sides are glued; at a boundary edge
/// the front and the back of its triangle. Degenerate triangles are left out.
IntrinsicTriangulation TuftedCover(const Points& V, const Triangles& triangles);

/// Intrinsic mollification (same paper): adds the least length to all edges that makes each
/// triangle obey the triangle inequality by 1e-5 units. None where all do.
void Mollify(IntrinsicTriangulation& triangulation);

/// Flips edges until none has a negative sum of cotangents (Fisher, Springborn, Schroeder and
/// Bobenko 2007, "An Algorithm for the Construction of Intrinsic Delaunay Triangulations").
/// \return number of flips
std::int64_t FlipToDelaunay(IntrinsicTriangulation& triangulation);
}

#endif
