// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "FilterTesting.h"
#include "MeshMeasures.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTriangleRadiusRatio.h"

#include <cmath>

using namespace lmo;

namespace
{
/// A right isosceles triangle, one with the sides 3-4-5, both at point 0, and an unused point 5.
vtkSmartPointer<vtkPolyData> TwoTriangles()
{
  TestMesh mesh{ Points(6, 3), Triangles(2, 3) };
  mesh.V << 0, 0, 0, 1, 0, 0, 0, 1, 0, -3, 0, 0, 0, -4, 0, 9, 9, 9;
  mesh.T << 0, 1, 2, 0, 3, 4;
  return MakePolyData(mesh);
}

const double Isosceles = 2 * (std::sqrt(2) - 1);

void CheckKnownValues(Checks& c)
{
  vtkNew<vtkTriangleRadiusRatio> filter;
  const auto input = TwoTriangles();
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 0, 5 });
  input->SetLines(lines);
  filter->SetInputData(input);
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  c.Error("cells have the values of the triangles, lines -1",
    LargestMagnitude(CellValues(output, "RadiusRatio") - Eigen::Vector3d(-1, Isosceles, 0.8)),
    1e-15);
  c.True("viewers colour the cells by it",
    output->GetCellData()->GetScalars() == output->GetCellData()->GetArray("RadiusRatio"));
  Vector atPoints(6);
  atPoints << 0.8, Isosceles, Isosceles, 0.8, 0.8, -1;
  c.Error("points have the minimum, unused points -1",
    LargestMagnitude(PointValues(output, "RadiusRatio") - atPoints), 1e-15);
  const double mean = (Isosceles + 0.8) / 2;
  c.Error("the mean counts triangles only", std::abs(filter->GetMeanRadiusRatio() - mean), 1e-15);
  c.Error(
    "the minimum counts triangles only", std::abs(filter->GetMinimumRadiusRatio() - 0.8), 1e-15);
  c.True("field data hold what the getters return",
    FieldValue(output, "MeanRadiusRatio") == filter->GetMeanRadiusRatio() &&
      FieldValue(output, "MinimumRadiusRatio") == filter->GetMinimumRadiusRatio());
}

void CheckStrips(Checks& c)
{
  // Two right isosceles triangles, then one with the sides 3-4-5.
  TestMesh mesh{ Points(5, 3), Triangles(0, 3) };
  mesh.V << 0, 3, 0, 0, 0, 0, 3, 3, 0, 3, 0, 0, 7, 0, 0;
  const auto input = MakePolyData(mesh);
  vtkNew<vtkCellArray> strips;
  strips->InsertNextCell({ 0, 1, 2, 3 });
  strips->InsertNextCell({ 0, 1, 2, 3, 4 });
  strips->InsertNextCell({ 4, 3, 2, 1, 0 });
  input->SetStrips(strips);
  vtkNew<vtkTriangleRadiusRatio> filter;
  filter->SetInputData(input);
  filter->Update();
  c.Error("a strip has the minimum of its triangles",
    LargestMagnitude(
      CellValues(filter->GetOutput(), "RadiusRatio") - Eigen::Vector3d(Isosceles, 0.8, 0.8)),
    1e-15);
  c.Error("the mean counts each triangle of a strip",
    std::abs(filter->GetMeanRadiusRatio() - (3 * Isosceles + 0.8) / 4), 1e-15);
}

void CheckMixedCells(Checks& c)
{
  const auto input = MakeMixedPolyData();
  vtkNew<vtkTriangleRadiusRatio> filter;
  filter->SetInputData(input);
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  c.True("there is one value for each cell and point",
    CellValues(output, "RadiusRatio").size() == input->GetNumberOfCells() &&
      PointValues(output, "RadiusRatio").size() == input->GetNumberOfPoints());
  c.True("all data pass through", Contains(output->GetPointData(), input->GetPointData()) &&
                                    Contains(output->GetCellData(), input->GetCellData()) &&
                                    Contains(output->GetFieldData(), input->GetFieldData()));
  c.True("points and cells pass through", PointsOf(output) == PointsOf(input) &&
                                            AreEqual(output->GetVerts(), input->GetVerts()) &&
                                            AreEqual(output->GetLines(), input->GetLines()) &&
                                            AreEqual(output->GetPolys(), input->GetPolys()) &&
                                            AreEqual(output->GetStrips(), input->GetStrips()));
}

void CheckOtherInput(Checks& c)
{
  vtkNew<vtkTriangleRadiusRatio> filter;
  vtkNew<vtkPolyData> nothing;
  filter->SetInputData(nothing);
  c.Equal("an empty input is no error", Update(filter).errors, "");
  c.True("an empty input has no quality",
    filter->GetMeanRadiusRatio() == -1 && filter->GetMinimumRadiusRatio() == -1);

  const auto edges = MakePolyData(Cube());
  edges->GetPolys()->InsertNextCell({ 0, 1 });
  filter->SetInputData(edges);
  c.Says("polygons of two points are an error which names vtkCleanPolyData", Update(filter).errors,
    "vtkCleanPolyData");
  c.True("after an error the output is empty", IsEmpty(filter->GetOutput()));
}
}

int TestTriangleRadiusRatio(int argc, char* argv[])
{
  Groups groups(argc, argv);
  groups.Run("KnownValues", CheckKnownValues);
  groups.Run("Strips", CheckStrips);
  groups.Run("MixedCells", CheckMixedCells);
  groups.Run("OtherInput", CheckOtherInput);
  return groups.Result();
}
