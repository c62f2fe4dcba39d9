// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTriangleRadiusRatio.h"

#include "Core/Mesh/TriangleQuality.h"
#include "Private/FilterSupport.h"
#include "Private/PolyDataConversion.h"
#include "Private/PolyDataOutput.h"
#include "Private/SurfaceExtraction.h"

#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

vtkStandardNewMacro(vtkTriangleRadiusRatio);

int vtkTriangleRadiusRatio::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  return 1;
}

int vtkTriangleRadiusRatio::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataSet* data = vtkDataSet::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  return lmo::RunFilter(this, data, output,
    [&]
    {
      const vtkSmartPointer<vtkPolyData> input = lmo::SurfaceOf(data);
      lmo::SurfaceMesh mesh = lmo::ReadMesh(input);
      if (this->WeldCoincidentPoints)
      {
        lmo::WeldCoincidentPoints(mesh);
      }
      const lmo::MeshQuality quality =
        lmo::MeasureQuality(mesh.points, mesh.triangles, mesh.polygons);
      this->MeanRadiusRatio = quality.mean;
      this->MinimumRadiusRatio = quality.minimum;
      output->ShallowCopy(input);
      lmo::ResultArrays results;
      const std::string name =
        lmo::AddRadiusRatios("RadiusRatio", quality, mesh.numbering, results, output);
      output->GetCellData()->SetActiveScalars(name.c_str()); // what viewers show first
      vtkFieldData* metrics = output->GetFieldData();
      results.Add(metrics, lmo::MakeArray("MeanRadiusRatio", quality.mean));
      results.Add(metrics, lmo::MakeArray("MinimumRadiusRatio", quality.minimum));
      results.Warn(this);
    });
}

void vtkTriangleRadiusRatio::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "WeldCoincidentPoints: " << this->WeldCoincidentPoints << "\n";
  os << indent << "MeanRadiusRatio: " << this->MeanRadiusRatio << "\n";
  os << indent << "MinimumRadiusRatio: " << this->MinimumRadiusRatio << "\n";
}

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
