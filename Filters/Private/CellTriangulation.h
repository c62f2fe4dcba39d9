// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef CellTriangulation_h
#define CellTriangulation_h

#include "Core/Base/Types.h"

#include "vtkType.h"

class vtkCellArray;
class vtkPoints;

namespace lmo
{
/// Triangles in the order of the cells that they belong to.
struct CellTriangles
{
  Triangles triangles;
  std::vector<vtkIdType> cells; ///< of each triangle, an index of the vtkCellArray
};

/// Cuts polygons with n corners, which may be concave, into n - 2 triangles: quads along the
/// diagonal that is inside, the shorter one if both are; larger polygons ear by ear, those with the
/// smallest ratio of squared perimeter to area first (vtkPolygon); as a fan around the first corner
/// where that fails, as for polygons without area.
/// \param polygons three corners or more each, with ids of \a points
CellTriangles TriangulatePolygons(vtkCellArray* polygons, vtkPoints* points);

/// Takes triangle strips apart.
CellTriangles TriangulateStrips(vtkCellArray* strips);
}

#endif
