// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "FilterTesting.h"
#include "MeshMeasures.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkLaplacianMeshOptimizer.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <Eigen/Geometry>

using namespace lmo;

namespace
{
void CheckPointTypes(Checks& c)
{
  const TestMesh sphere = Irregular(Icosphere(2), 0.05);
  const auto input = MakePolyData(sphere, VTK_FLOAT);
  const auto fromFloat = Optimized(input);
  const auto fromDouble = Optimized(MakePolyData(sphere, VTK_DOUBLE));
  c.Equal("float points stay float", fromFloat->GetPoints()->GetDataType(), VTK_FLOAT);
  c.Equal("double points stay double", fromDouble->GetPoints()->GetDataType(), VTK_DOUBLE);
  c.Error("float and double points give the same result",
    MaximumDistance(PointsOf(fromFloat), PointsOf(fromDouble)), 1e-5);
  c.Error("displacements are those of the float points",
    MaximumDistance(PointValues(fromFloat, "Displacement"), PointsOf(fromFloat) - PointsOf(input)),
    0);
  c.Greater("points move", MaximumDistance(PointsOf(fromDouble), sphere.V), 0.01);
}

void CheckPassing(Checks& c)
{
  const auto input = MakeMixedPolyData();
  const auto output = Optimized(input);
  c.True("vertices pass through", AreEqual(output->GetVerts(), input->GetVerts()));
  c.True("lines pass through", AreEqual(output->GetLines(), input->GetLines()));
  c.True("triangles pass through", AreEqual(output->GetPolys(), input->GetPolys()));
  c.True("strips pass through", AreEqual(output->GetStrips(), input->GetStrips()));
  c.True("point data pass through", Contains(output->GetPointData(), input->GetPointData()));
  c.True("cell data pass through", Contains(output->GetCellData(), input->GetCellData()));
  c.True("field data pass through", Contains(output->GetFieldData(), input->GetFieldData()));
  c.Equal("the active scalars stay", output->GetPointData()->GetScalars(),
    output->GetPointData()->GetArray("PointNumber"));
  c.Error(
    "an isolated point stays", (PointsOf(output).row(169) - PointsOf(input).row(169)).norm(), 0);
  c.Error("strips and triangles give the same result",
    MaximumDistance(PointsOf(output), PointsOf(Optimized(MakeMixedPolyDataWithoutStrips()))),
    1e-12);
}

void CheckInputIsKept(Checks& c)
{
  const auto input = MakeMixedPolyData();
  vtkNew<vtkPolyData> copy;
  copy->DeepCopy(input);
  const vtkMTimeType time = input->GetMTime();
  Optimized(input);
  c.True("the input is not modified", AreEqual(input, copy));
  c.Equal("the input's time does not change", input->GetMTime(), time);
}

void CheckComponents(Checks& c)
{
  const auto constant = [](vtkLaplacianMeshOptimizer* filter)
  {
    filter->SetPositionWeighting(vtkLaplacianMeshOptimizer::CONSTANT);
    filter->SetMode(vtkLaplacianMeshOptimizer::SMOOTH);
  };
  const auto both = Optimized(MakePolyData(TwoComponents()), constant);
  const auto first = Optimized(MakePolyData(Icosphere(1)), constant);
  c.Error("components do not influence each other",
    MaximumDistance(PointsOf(both).topRows(42), PointsOf(first)), 1e-6);
}

void CheckRepetition(Checks& c)
{
  const auto once = Optimized(MakeMixedPolyData());
  vtkNew<vtkPolyData> copy;
  copy->DeepCopy(once);
  const auto twice = Optimized(once);
  c.True("a second filter does not touch the arrays of the first", AreEqual(once, copy));
  c.Error("a second filter replaces the arrays of the first",
    MaximumDistance(PointValues(twice, "Displacement"), PointsOf(twice) - PointsOf(once)), 0);
}

/// Area-weighted mean of the triangles' normals.
Points NormalsOf(const TestMesh& mesh)
{
  Points normals = Points::Zero(mesh.V.rows(), 3);
  for (const auto& T : mesh.T.rowwise())
  {
    const Vector3 a = mesh.V.row(T[0]), b = mesh.V.row(T[1]), c = mesh.V.row(T[2]);
    normals(T, Eigen::indexing::all).rowwise() += (b - a).cross(c - a);
  }
  return normals.rowwise().normalized();
}

/// Adds float normals "N" that all point along x.
vtkSmartPointer<vtkDataArray> AddNormals(vtkPolyData* mesh)
{
  auto normals = vtkSmartPointer<vtkFloatArray>::New();
  normals->SetName("N");
  normals->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    normals->InsertNextTuple3(1, 0, 0);
  }
  mesh->GetPointData()->SetNormals(normals);
  return normals;
}

void CheckNormals(Checks& c)
{
  const TestMesh sphere = Irregular(Icosphere(2), 0.05);
  const auto input = MakePolyData(sphere);
  const auto inputNormals = AddNormals(input);
  const auto displaced = [](vtkLaplacianMeshOptimizer* filter)
  { filter->InterpolatePointDataOff(); };
  const auto output = Optimized(input, displaced);
  vtkDataArray* normals = output->GetPointData()->GetNormals();
  c.Error("normals are recomputed",
    MaximumDistance(ValuesOf(normals), NormalsOf({ PointsOf(output), sphere.T })), 1e-6);
  c.True("normals keep their name and type",
    normals->GetName() == std::string("N") && normals->GetDataType() == VTK_FLOAT);
  c.Equal("the input's normals are not touched", inputNormals->GetComponent(5, 0), 1);
  c.Equal("normals pass through if ComputeNormals is off",
    Optimized(input,
      [](vtkLaplacianMeshOptimizer* filter)
      {
        filter->ComputeNormalsOff();
        filter->InterpolatePointDataOff();
      })
      ->GetPointData()
      ->GetNormals(),
    inputNormals);
  c.True("without normals there are none to recompute",
    !Optimized(MakePolyData(sphere))->GetPointData()->GetNormals());

  const auto strips = MakeMixedPolyData();
  const auto triangles = MakeMixedPolyDataWithoutStrips();
  AddNormals(strips);
  AddNormals(triangles);
  c.Error("strips and triangles give the same normals",
    LargestMagnitude(PointValues(Optimized(strips), "N") - PointValues(Optimized(triangles), "N")),
    1e-6);
  c.Error("an unused point keeps its normal",
    (PointValues(Optimized(strips), "N").row(169) - Vector3(1, 0, 0)).norm(), 0);
}

void CheckEmptyInput(Checks& c)
{
  vtkNew<vtkPolyData> nothing;
  vtkNew<vtkLaplacianMeshOptimizer> filter;
  filter->SetInputData(nothing);
  c.Equal("an empty input is no error", Update(filter).errors, "");
  c.True("an empty input gives an empty output",
    filter->GetOutput()->GetNumberOfPoints() == 0 && filter->GetOutput()->GetNumberOfCells() == 0);

  const Points points = Points::Ones(3, 3);
  filter->SetInputData(MakePolyData({ points, Triangles(0, 3) }));
  c.Equal("points alone are no error", Update(filter).errors, "");
  c.Error("points alone stay", MaximumDistance(PointsOf(filter->GetOutput()), points), 0);
  c.Equal("points alone have no quality", filter->GetMeanRadiusRatio(), -1);
}
}

int TestOptimizerInput(int argc, char* argv[])
{
  Groups groups(argc, argv);
  groups.Run("PointTypes", CheckPointTypes);
  groups.Run("Passing", CheckPassing);
  groups.Run("InputIsKept", CheckInputIsKept);
  groups.Run("Components", CheckComponents);
  groups.Run("Repetition", CheckRepetition);
  groups.Run("Normals", CheckNormals);
  groups.Run("EmptyInput", CheckEmptyInput);
  return groups.Result();
}
