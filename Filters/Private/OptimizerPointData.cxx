// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause

// What becomes of the input's data when its points have moved.
#include "CellNormals.h"
#include "OptimizerSession.h"
#include "PointNormals.h"
#include "PolyDataOutput.h"

#include "vtkCellData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

bool vtkLaplacianMeshOptimizer::Session::InterpolatesPointData() const
{
  const int mode = this->Filter->Mode;
  return this->Filter->InterpolatePointData &&
         (mode == OPTIMIZE_WITHIN_DEVIATION || mode == OPTIMIZE_TRIANGLES);
}

void vtkLaplacianMeshOptimizer::Session::WritePointData(
  const lmo::OptimizerResult& result, vtkPolyData* input, vtkPointData* pointData) const
{
  vtkDataArray* normals = pointData->GetNormals();
  if (this->Filter->ComputeNormals && normals)
  {
    lmo::CheckNormals(normals, input->GetNumberOfPoints(), "point");
  }
  if (this->InterpolatesPointData())
  {
    pointData->ShallowCopy(this->PointDataAtNewPlaces(input, result));
    return;
  }
  if (result.normals.rows() > 0)
  {
    pointData->SetNormals(lmo::ReplaceNormals(
      normals, this->Numbering.HasMergedPoints()
                 ? lmo::NormalsOfMergedPoints(
                     input, this->Numbering.ToPoints(result.positions), this->Numbering)
                 : this->Numbering.ToPoints(result.normals)));
  }
}

void vtkLaplacianMeshOptimizer::Session::WriteCellNormals(vtkPolyData* output) const
{
  vtkDataArray* normals = output->GetCellData()->GetNormals();
  if (this->Filter->ComputeNormals && output->GetPoints() && normals)
  {
    lmo::CheckNormals(normals, output->GetNumberOfCells(), "cell");
    output->GetCellData()->SetNormals(lmo::ReplaceNormals(normals, lmo::CellNormals(output)));
  }
}

vtkSmartPointer<vtkPointData> vtkLaplacianMeshOptimizer::Session::PointDataAtNewPlaces(
  vtkPolyData* input, const lmo::OptimizerResult& result) const
{
  return lmo::InterpolatePointData(
    input, this->Optimizer->GetMesh(), this->Numbering, result.positions);
}

std::vector<lmo::MovingArray> vtkLaplacianMeshOptimizer::Session::FindMovingArrays(
  vtkPolyData* input)
{
  return lmo::FindMovingArrays(input);
}

vtkSmartPointer<vtkPointData> vtkLaplacianMeshOptimizer::Session::MoveArrays(vtkPolyData* input,
  const std::vector<lmo::MovingArray>& arrays, const lmo::MoveFieldsAs& move) const
{
  return lmo::MoveArrays(input, this->Numbering, arrays, move);
}

void vtkLaplacianMeshOptimizer::Session::AddDataOfReference(
  vtkPolyData* reference, const lmo::OptimizerResult& result, vtkPolyData* output) const
{
  if (this->Reference && this->InterpolatesPointData())
  {
    lmo::ResultArrays::AddMissing(reference->GetFieldData(), output->GetFieldData());
    const lmo::Points positions = this->Numbering.ToPoints(result.positions);
    lmo::ResultArrays::AddMissing(
      lmo::PointDataAt(reference, this->ReferenceNumbering, positions), output->GetPointData());
  }
}

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
