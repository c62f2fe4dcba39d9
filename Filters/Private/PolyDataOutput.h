// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef PolyDataOutput_h
#define PolyDataOutput_h

#include "Core/Mesh/TriangleQuality.h"
#include "MeshNumbering.h"
#include "ResultArrays.h"

#include "vtkSmartPointer.h"

#include <string>

class vtkDataArray;
class vtkDoubleArray;
class vtkPoints;
class vtkPolyData;

namespace lmo
{
/// Coordinates of the points from those of the vertices, in the type of the input's: float for
/// float, double for all others. Like the arrays below, values that are not needed any more are to
/// be moved here, which frees their memory.
vtkSmartPointer<vtkPoints> MakePoints(
  const Points& positions, const MeshNumbering& numbering, vtkPoints* input);

/// Point arrays from values at the vertices.
vtkSmartPointer<vtkDoubleArray> MakeArray(
  const char* name, Vector values, const MeshNumbering& numbering);
vtkSmartPointer<vtkDoubleArray> MakeArray(
  const char* name, Points values, const MeshNumbering& numbering);

/// Array of one value, as field data hold it.
vtkSmartPointer<vtkDoubleArray> MakeArray(const char* name, double value);

/// Adds a cell array of 0 and 1: whether one of the cell's triangles is marked.
void AddCellFlags(const char* name, const Mask& isMarked, const MeshNumbering& numbering,
  ResultArrays& results, vtkPolyData* output);

/// Adds the qualities of the cells to the cell data, of a strip the least of its triangles, and
/// those of the vertices to the point data.
/// \return the name of the cell array
std::string AddRadiusRatios(const char* name, const MeshQuality& quality,
  const MeshNumbering& numbering, ResultArrays& results, vtkPolyData* output);

/// \param count of the points or cells that the normals belong to
/// \param kind what they belong to, for the error: "point" or "cell"
/// \throw InputError if the array has not three values for each.
void CheckNormals(vtkDataArray* normals, vtkIdType count, const char* kind);

/// Copy of a normals array in its type. The rows of \a normals, one per tuple, replace its tuples
/// unless they are 0.
vtkSmartPointer<vtkDataArray> ReplaceNormals(vtkDataArray* input, const Points& normals);
}

#endif
