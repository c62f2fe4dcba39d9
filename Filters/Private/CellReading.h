// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef CellReading_h
#define CellReading_h

#include "MeshNumbering.h"

class vtkPolyData;

namespace lmo
{
/// The triangles of a vtkPolyData, those of its polygons and strips included.
struct SurfaceTriangles
{
  Triangles triangles;
  Polygons
    polygons; ///< to which the triangles belong; empty if there are only triangles and strips
  TriangleCells triangleCells;
};

/// \throw InputError for polygons with fewer than three corners and point ids out of range.
SurfaceTriangles ReadTriangles(vtkPolyData* input);
}

#endif
