// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "FilterTesting.h"
#include "MeshMeasures.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkLaplacianMeshOptimizer.h"
#include "vtkMeshLaplacian.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTriangleRadiusRatio.h"

#include <Eigen/Geometry>

using namespace lmo;

namespace
{
using Optimizer = vtkLaplacianMeshOptimizer;

vtkSmartPointer<vtkPolyData> Sphere()
{
  return MakePolyData(Irregular(Icosphere(1), 0.05));
}

/// Adds an array of sevens, as a user has it, to point, cell or field data.
void AddSevens(vtkFieldData* data, const char* name, vtkIdType tuples)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfTuples(tuples);
  array->Fill(7);
  data->AddArray(array);
}

bool HasSevens(vtkFieldData* data, const char* name)
{
  return (ValuesOf(data->GetArray(name)).array() == 7).all();
}

bool Has(const std::string& text, const char* part)
{
  return text.find(part) != std::string::npos;
}

void CheckArraysOfTheUser(Checks& c)
{
  const auto input = Sphere();
  AddSevens(input->GetPointData(), "Displacement", 42);
  AddSevens(input->GetCellData(), "RadiusRatio", 80);
  AddSevens(input->GetFieldData(), "Iterations", 1);
  vtkNew<Optimizer> filter;
  filter->SetInputData(input);
  const std::string warnings = Update(filter).warnings;
  vtkPolyData* output = filter->GetOutput();
  c.True("a point array of the user is kept", HasSevens(output->GetPointData(), "Displacement"));
  c.True("a cell array of the user is kept", HasSevens(output->GetCellData(), "RadiusRatio"));
  c.True("a field array of the user is kept", HasSevens(output->GetFieldData(), "Iterations"));
  c.Error("the result has another name",
    MaximumDistance(
      PointValues(output, "DisplacementOptimized"), PointsOf(output) - PointsOf(input)),
    0);
  c.Equal("the result of the cells has another name",
    CellValues(output, "RadiusRatioOptimized").rows(), 80);
  c.Equal("the metric has another name", FieldValue(output, "IterationsOptimized"),
    filter->GetIterations());
  for (const char* text : { "3 arrays", "point array 'Displacement'", "cell array 'RadiusRatio'",
         "field array 'Iterations'", "DisplacementOptimized" })
  {
    c.True(std::string("a warning names ") + text, Has(warnings, text));
  }
  c.True("results without a rival keep their names",
    output->GetPointData()->HasArray("RadiusRatio") &&
      !output->GetPointData()->HasArray("RadiusRatioOptimized"));
}

/// A second filter of the same kind treats the results of the first as its own.
void CheckRepetition(Checks& c)
{
  const auto input = Sphere();
  AddSevens(input->GetPointData(), "Displacement", 42);
  vtkNew<Optimizer> first;
  first->SetInputData(input);
  first->Update();
  vtkNew<vtkPolyData> copy;
  copy->DeepCopy(first->GetOutput());
  for (vtkPolyData* once : { first->GetOutput(), copy.Get() })
  {
    vtkNew<Optimizer> second;
    second->SetMode(Optimizer::SMOOTH);
    second->SetInputData(once);
    second->Update();
    vtkPolyData* twice = second->GetOutput();
    c.True("the array of the user is kept again", HasSevens(twice->GetPointData(), "Displacement"));
    c.Error("the result is replaced",
      MaximumDistance(
        PointValues(twice, "DisplacementOptimized"), PointsOf(twice) - PointsOf(once)),
      0);
    c.True(
      "no third name appears", !twice->GetPointData()->HasArray("DisplacementOptimizedOptimized"));
    c.True("metrics of another mode go", !twice->GetFieldData()->HasArray("Passes"));
  }
}

void CheckOtherFilters(Checks& c)
{
  vtkNew<vtkTriangleRadiusRatio> ratio;
  ratio->SetInputData(Sphere());
  vtkNew<vtkMeshLaplacian> laplacian;
  laplacian->SetInputConnection(ratio->GetOutputPort());
  vtkNew<Optimizer> optimizer;
  optimizer->SetInputConnection(laplacian->GetOutputPort());
  c.Equal(
    "results of the other filters are replaced without a word", Update(optimizer).warnings, "");
  c.Error("radius ratios have their name",
    std::abs(
      CellValues(optimizer->GetOutput(), "RadiusRatio").mean() - optimizer->GetMeanRadiusRatio()),
    1e-14);
  c.True("no curvature has another name",
    !optimizer->GetOutput()->GetPointData()->HasArray("MeanCurvatureOptimized"));

  const auto input = Sphere();
  AddSevens(input->GetPointData(), "MeanCurvature", 42);
  AddSevens(input->GetCellData(), "RadiusRatio", 80);
  laplacian->SetInputData(input);
  ratio->SetInputData(input);
  c.True("the filter of Laplacians keeps arrays of the user and says so",
    Has(Update(laplacian).warnings, "MeanCurvature") &&
      HasSevens(laplacian->GetOutput()->GetPointData(), "MeanCurvature"));
  c.True("the filter of radius ratios keeps arrays of the user and says so",
    Has(Update(ratio).warnings, "RadiusRatio") &&
      HasSevens(ratio->GetOutput()->GetCellData(), "RadiusRatio"));
}

/// Float cell normals "N" that all point along x.
void AddCellNormals(vtkPolyData* mesh)
{
  vtkNew<vtkFloatArray> normals;
  normals->SetName("N");
  normals->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    normals->InsertNextTuple3(1, 0, 0);
  }
  mesh->GetCellData()->SetNormals(normals);
}

Points TriangleNormals(const Points& V, const Triangles& T)
{
  Points normals(T.rows(), 3);
  for (Eigen::Index t = 0; t < T.rows(); ++t)
  {
    const Vector3 a = V.row(T(t, 0)), b = V.row(T(t, 1)), c = V.row(T(t, 2));
    normals.row(t) = (b - a).cross(c - a).normalized();
  }
  return normals;
}

void CheckCellNormals(Checks& c)
{
  const TestMesh sphere = Irregular(Icosphere(2), 0.05);
  const auto input = MakePolyData(sphere);
  AddCellNormals(input);
  const auto output = Optimized(input);
  vtkDataArray* normals = output->GetCellData()->GetNormals();
  c.Error("cell normals are those of the new triangles",
    MaximumDistance(ValuesOf(normals), TriangleNormals(PointsOf(output), sphere.T)), 1e-6);
  c.True("cell normals keep their name and type",
    normals->GetName() == std::string("N") && normals->GetDataType() == VTK_FLOAT);
  c.Error("the input's cell normals are not touched",
    LargestMagnitude(CellValues(input, "N").col(0).array() - 1), 0);
  c.Error("cell normals pass through if ComputeNormals is off",
    LargestMagnitude(
      CellValues(Optimized(input, [](Optimizer* filter) { filter->ComputeNormalsOff(); }), "N")
        .col(0)
        .array() -
      1),
    0);
}

void CheckCellNormalsOfMixedCells(Checks& c)
{
  const auto strips = MakeMixedPolyData();
  AddCellNormals(strips);
  const auto output = Optimized(strips);
  const Eigen::MatrixXd normals = CellValues(output, "N");
  c.Error("vertices and lines keep their normals",
    LargestMagnitude(normals.topRows(3).rowwise() - Vector3(1, 0, 0)), 0);
  c.Error(
    "all normals have length 1", LargestMagnitude(normals.rowwise().norm().array() - 1), 1e-6);
  // Strips lie in the upper half of a cylinder around z, whose triangles look outward.
  const auto triangles = MakeMixedPolyDataWithoutStrips();
  AddCellNormals(triangles);
  const Eigen::MatrixXd ofTriangles = CellValues(Optimized(triangles), "N");
  const Vector3 first = ofTriangles.row(147);
  c.Greater("a strip looks where its triangles look", first.dot(normals.row(147)), 0.8);
}
}

int TestResultArrays(int argc, char* argv[])
{
  Groups groups(argc, argv);
  groups.Run("ArraysOfTheUser", CheckArraysOfTheUser);
  groups.Run("Repetition", CheckRepetition);
  groups.Run("OtherFilters", CheckOtherFilters);
  groups.Run("CellNormals", CheckCellNormals);
  groups.Run("CellNormalsOfMixedCells", CheckCellNormalsOfMixedCells);
  return groups.Result();
}
