// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_VirtualRefinement_h
#define lmo_VirtualRefinement_h

#include "Core/Mesh/TriangleGeometry.h"

#include <array>

namespace lmo
{
/// A polygon as triangles that meet in a virtual vertex, or as the triangles into which it is cut.
class RefinedPolygon
{
public:
  /// Places in the polygon; its size is that of the virtual vertex.
  using Corners = std::array<Index, 3>;

  /// \param ids vertices of the polygon
  /// \param firstTriangle of the size - 2 triangles into which the polygon is cut
  RefinedPolygon(
    const Points& V, const Index* ids, Index size, const Triangles& triangles, Index firstTriangle);

  Index GetSize() const { return this->Size; }

  /// Weights of the corners in the value of the virtual vertex, with the sum 1; empty if there is
  /// no virtual vertex.
  const Vector& GetWeights() const { return this->Weights; }

  /// Calls visit(corners, positions) for each triangle.
  template <typename Visit>
  void ForEachTriangle(const Visit& visit) const
  {
    for (const Corners& corners : this->Fan)
    {
      TriangleCorners positions;
      positions << this->Positions.row(corners[0]), this->Positions.row(corners[1]),
        this->Positions.row(corners[2]);
      visit(corners, positions);
    }
  }

  /// Adds the last value, that of the virtual vertex, to those of the corners.
  void Distribute(std::vector<double>& values) const;

private:
  /// \return false if the polygon does not surround its virtual vertex
  bool Refine();

  void UseTriangles(const Triangles& triangles, Index first, const Index* ids);

  const Index Size;
  Points Positions; ///< the last row is the virtual vertex
  Vector Weights;
  std::vector<Corners> Fan;
};
}

#endif
