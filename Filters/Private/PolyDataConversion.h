// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef PolyDataConversion_h
#define PolyDataConversion_h

#include "Core/Base/Types.h"

#include "vtkType.h"

#include <string>
#include <vector>

class vtkDataArray;
class vtkPolyData;

namespace lmo
{
/// Which cell each triangle belongs to.
struct TriangleCells
{
  vtkIdType firstPolygon = 0;
  std::vector<vtkIdType> cells; ///< of each triangle; empty if they are firstPolygon + triangle

  vtkIdType operator()(Index triangle) const
  {
    return this->cells.empty() ? this->firstPolygon + triangle : this->cells[triangle];
  }
};

/// The triangles of a vtkPolyData, those of its polygons and strips included.
struct SurfaceMesh
{
  Points points;
  Triangles triangles;
  TriangleCells triangleCells;
};

/// \throw InputError for coordinates that are not finite, polygons with fewer than three corners
/// and point ids out of range.
SurfaceMesh ReadMesh(vtkPolyData* input);

/// \throw InputError if new coordinates are beyond the range of their type.
void CheckRange(const Points& positions);

/// \param count of the points or cells that the array belongs to
/// \param kind what it belongs to, for the error: "point" or "cell"
/// \throw InputError if the array has not one value for each, or one that is not finite.
Vector ReadScalars(vtkDataArray* array, vtkIdType count, const char* kind = "point");

/// As ReadScalars(); negative values are errors too.
Vector ReadWeights(vtkDataArray* array, vtkIdType points);

/// \throw InputError if the array has not three finite values per point.
Points ReadVectors(vtkDataArray* array, vtkIdType points);
}

#endif
