// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef PolyDataConversion_h
#define PolyDataConversion_h

#include "../Core/Quality.h"

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkDataArray;
class vtkDoubleArray;
class vtkFieldData;
class vtkPoints;
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

/// The triangles of a vtkPolyData, those of its strips included.
struct SurfaceMesh
{
  Points points;
  Triangles triangles;
  TriangleCells triangleCells;
};

/// \throw InputError for coordinates that are not finite, polygons that are no triangles and point
/// ids out of range.
SurfaceMesh ReadMesh(vtkPolyData* input);

/// \throw InputError if the array has not one value per point, or one that is not finite.
Vector ReadScalars(vtkDataArray* array, vtkIdType points);

/// As ReadScalars(); negative values are errors too.
Vector ReadWeights(vtkDataArray* array, vtkIdType points);

/// \throw InputError if the array has not three finite values per point.
Points ReadVectors(vtkDataArray* array, vtkIdType points);

/// Coordinates in the type of the input's: float for float, double for all others. Like the arrays
/// below, values that are not needed any more are to be moved here, which frees their memory.
vtkSmartPointer<vtkPoints> MakePoints(Points points, vtkPoints* input);

vtkSmartPointer<vtkDoubleArray> MakeArray(const char* name, Vector values);
vtkSmartPointer<vtkDoubleArray> MakeArray(const char* name, Points values);

/// Array of one value, as field data hold it.
vtkSmartPointer<vtkDoubleArray> MakeArray(const char* name, double value);

/// Adds the radius ratios of the triangles to the cell data and of the vertices to the point data.
void AddRadiusRatios(const char* name, const MeshQuality& quality,
  const TriangleCells& triangleCells, vtkPolyData* output);

/// Copy of a normals array, in its type, with the normals of \a normals that are not 0.
/// \throw InputError if the array has not three values per point.
vtkSmartPointer<vtkDataArray> ReplaceNormals(vtkDataArray* input, const Points& normals);
}

#endif
