// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceExtraction.h"

#include "vtkDataSet.h"
#include "vtkGeometryFilter.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

namespace lmo
{
vtkSmartPointer<vtkPolyData> SurfaceOf(vtkDataObject* data)
{
  vtkDataSet* input = vtkDataSet::SafeDownCast(data);
  vtkPolyData* surface = vtkPolyData::SafeDownCast(data);
  if (surface || !input)
  {
    return surface;
  }
  // A copy, since the filter connects its input to a pipeline of its own.
  auto copy = vtk::TakeSmartPointer(input->NewInstance());
  copy->ShallowCopy(input);
  vtkNew<vtkGeometryFilter> extraction;
  extraction->SetInputData(copy);
  extraction->PassThroughCellIdsOn();
  extraction->PassThroughPointIdsOn();
  extraction->Update();
  return extraction->GetOutput();
}

vtkPolyData* CachedSurface::Of(vtkDataObject* data)
{
  vtkPolyData* surface = vtkPolyData::SafeDownCast(data);
  if (surface || !data)
  {
    return surface;
  }
  if (!this->Surface || this->Data != data || this->Time != data->GetMTime())
  {
    this->Surface = SurfaceOf(data);
    this->Data = data;
    this->Time = data->GetMTime();
  }
  return this->Surface;
}
}
