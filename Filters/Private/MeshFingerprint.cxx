// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshFingerprint.h"

#include <functional>
#include <string_view>
#include <vector>

namespace lmo
{
namespace
{
template <typename Value>
std::size_t HashOf(const Value* values, std::size_t size)
{
  return std::hash<std::string_view>()(
    { reinterpret_cast<const char*>(values), size * sizeof(Value) });
}

/// Of the vertices of merged points and of the cells of triangles.
std::size_t HashOf(const MeshNumbering& numbering, Index triangles)
{
  std::vector<vtkIdType> numbers{ numbering.GetNumberOfPoints(), numbering.GetNumberOfCells() };
  numbers.reserve(2 + triangles);
  for (Index point = 0; numbering.HasMergedPoints() && point < numbering.GetNumberOfPoints();
       ++point)
  {
    numbers.push_back(numbering.VertexOf(point));
  }
  for (Index t = 0; t < triangles; ++t)
  {
    numbers.push_back(numbering.CellOf(t));
  }
  return HashOf(numbers.data(), numbers.size());
}
}

MeshFingerprint FingerprintOf(const SurfaceMesh& mesh)
{
  const AdjacencyLists& corners = mesh.polygons.corners;
  return { HashOf(mesh.points.data(), mesh.points.size()),
    HashOf(mesh.triangles.data(), mesh.triangles.size()),
    HashOf(corners.ids.data(), corners.ids.size()),
    HashOf(corners.offsets.data(), corners.offsets.size()),
    HashOf(mesh.numbering, static_cast<Index>(mesh.triangles.rows())) };
}
}
