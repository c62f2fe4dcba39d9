// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef PolyDataConversion_h
#define PolyDataConversion_h

#include "MeshNumbering.h"

class vtkDataArray;
class vtkPolyData;

namespace lmo
{
/// The mesh of a vtkPolyData.
struct SurfaceMesh
{
  Points points;
  Triangles triangles;
  Polygons polygons; ///< to which the triangles belong; empty if the triangles are the cells
  MeshNumbering numbering;
};

/// \throw InputError for coordinates that are not finite, polygons with fewer than three corners
/// and point ids out of range.
SurfaceMesh ReadMesh(vtkPolyData* input);

/// Makes vertices one.
/// \param lowest for each vertex the lowest one that is the same; empty if no two are
void MergeVertices(SurfaceMesh& mesh, const std::vector<Index>& lowest);

/// Makes points on the boundary that have the same coordinates one vertex.
void WeldCoincidentPoints(SurfaceMesh& mesh);

/// Numbers vertices and triangles so that neighbours lie close together in memory, if they do not.
void RenumberIfScattered(SurfaceMesh& mesh);

/// \throw InputError if new coordinates are beyond the range of their type.
void CheckRange(const Points& positions, const MeshNumbering& numbering);

/// The values of a point array at the vertices.
/// \throw InputError if the array has not one value per point, or one that is not finite.
Vector ReadScalars(vtkDataArray* array, const MeshNumbering& numbering);

/// As ReadScalars(), but 1 if one of the vertex's points has a value other than 0, else 0.
Vector ReadFlags(vtkDataArray* array, const MeshNumbering& numbering);

/// As ReadScalars(); negative values are errors too.
Vector ReadWeights(vtkDataArray* array, const MeshNumbering& numbering);

/// The vectors of a point array at the vertices.
/// \throw InputError if the array has not three finite values per point.
Points ReadVectors(vtkDataArray* array, const MeshNumbering& numbering);

/// The labels of a cell array at the triangles, two in ascending order.
/// \throw InputError if the array has not one or two values per cell, or one that is not finite.
TriangleLabels ReadLabels(vtkDataArray* array, const MeshNumbering& numbering);
}

#endif
