// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SurfaceExtraction_h
#define SurfaceExtraction_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

class vtkDataObject;
class vtkPolyData;

namespace lmo
{
/// The surface of a data set: a vtkPolyData itself; of other types the cells that are a surface and
/// the outer faces of those that fill a volume, with their data and the arrays vtkOriginalPointIds
/// and vtkOriginalCellIds.
/// \return null for what is no vtkDataSet
vtkSmartPointer<vtkPolyData> SurfaceOf(vtkDataObject* data);

/// Keeps the surface as long as the data set stays as it is.
class CachedSurface
{
public:
  vtkPolyData* Of(vtkDataObject* data);

private:
  vtkSmartPointer<vtkPolyData> Surface;
  vtkDataObject* Data = nullptr; ///< to be compared only
  vtkMTimeType Time = 0;
};
}

#endif
