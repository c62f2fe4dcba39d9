// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef PolyDataOutput_h
#define PolyDataOutput_h

#include "Core/Mesh/TriangleQuality.h"
#include "PolyDataConversion.h"
#include "ResultArrays.h"

#include "vtkSmartPointer.h"

class vtkDoubleArray;
class vtkPoints;

namespace lmo
{
/// Coordinates in the type of the input's: float for float, double for all others. Like the arrays
/// below, values that are not needed any more are to be moved here, which frees their memory.
vtkSmartPointer<vtkPoints> MakePoints(Points points, vtkPoints* input);

vtkSmartPointer<vtkDoubleArray> MakeArray(const char* name, Vector values);
vtkSmartPointer<vtkDoubleArray> MakeArray(const char* name, Points values);

/// Array of one value, as field data hold it.
vtkSmartPointer<vtkDoubleArray> MakeArray(const char* name, double value);

/// Adds the radius ratios of the triangles to the cell data and of the vertices to the point data.
void AddRadiusRatios(const char* name, const MeshQuality& quality,
  const TriangleCells& triangleCells, ResultArrays& results, vtkPolyData* output);

/// Copy of a normals array, in its type, with the normals of \a normals that are not 0.
/// \param kind what the array belongs to, for the error: "point" or "cell"
/// \throw InputError if the array has not three values for each of \a normals.
vtkSmartPointer<vtkDataArray> ReplaceNormals(
  vtkDataArray* input, const Points& normals, const char* kind = "point");
}

#endif
