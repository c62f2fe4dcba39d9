// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "FilterTesting.h"
#include "MeshMeasures.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkLaplacianMeshOptimizer.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <limits>

using namespace lmo;

namespace
{
using Optimizer = vtkLaplacianMeshOptimizer;

/// x + 2 y - 3 z, which is linear on a plane.
Eigen::MatrixXd LinearField(const Points& V)
{
  return V * Eigen::Vector3d(1, 2, -3);
}

/// A fine flat square with a field, and a coarse one over it.
vtkSmartPointer<vtkPolyData> FineSquare()
{
  const TestMesh mesh = Transformed(Grid(20, 0.3), 0.5);
  auto square = MakePolyData(mesh);
  AddPointArray(square, "Field", LinearField(mesh.V));
  AddPointArray(square, "OfBoth", Vector::Constant(mesh.V.rows(), 1));
  vtkNew<vtkIntArray> ids;
  ids->SetName("Ids");
  ids->SetNumberOfTuples(mesh.V.rows());
  ids->FillValue(7);
  square->GetPointData()->SetGlobalIds(ids);
  vtkNew<vtkDoubleArray> time;
  time->SetName("Time");
  time->InsertNextValue(4);
  square->GetFieldData()->AddArray(time);
  return square;
}

vtkSmartPointer<vtkPolyData> CoarseSquare()
{
  const TestMesh mesh = Grid(10, 0.4);
  auto square = MakePolyData(mesh);
  AddPointArray(square, "OfBoth", Vector::Constant(mesh.V.rows(), 2));
  return square;
}

void CheckData(Checks& c)
{
  const auto output = Optimized(CoarseSquare(),
    [reference = FineSquare()](Optimizer* filter)
    {
      filter->SetMode(Optimizer::OPTIMIZE_WITHIN_DEVIATION);
      filter->SetReferenceData(reference);
    });
  c.Error("point data that only the reference has come with it, a linear field exactly",
    LargestMagnitude(PointValues(output, "Field") - LinearField(PointsOf(output))), 1e-12);
  c.Equal("those that the input has are its own", PointValues(output, "OfBoth")(5, 0), 2);
  c.True("ids stay with the reference", !output->GetPointData()->HasArray("Ids"));
  c.Equal("field data come, too", FieldValue(output, "Time"), 4);
  const auto without = Optimized(CoarseSquare(),
    [reference = FineSquare()](Optimizer* filter)
    {
      filter->SetMode(Optimizer::OPTIMIZE_WITHIN_DEVIATION);
      filter->SetReferenceData(reference);
      filter->InterpolatePointDataOff();
    });
  c.True("without InterpolatePointData they do not", PointValues(without, "Field").rows() == 0);
}

/// A sphere whose triangles are not connected serves as if they were.
void CheckSoup(Checks& c)
{
  const TestMesh sphere = Icosphere(2);
  const auto with = [&](const TestMesh& reference)
  {
    return PointsOf(Optimized(MakePolyData(WithThinTriangles(sphere, 7, 0.7)),
      [&](Optimizer* filter)
      {
        filter->SetMode(Optimizer::OPTIMIZE_WITHIN_DEVIATION);
        filter->SetMaximumDeviation(0.01);
        filter->SetReferenceData(MakePolyData(reference));
      }));
  };
  c.Error("a soup is the same reference as its connected mesh",
    MaximumDistance(with(Soup(sphere)), with(sphere)), 1e-12);
}

void CheckChanges(Checks& c)
{
  const TestMesh mesh = WithThinTriangles(Icosphere(2), 7, 0.7);
  const auto reference = MakePolyData(Icosphere(2));
  vtkNew<Optimizer> filter;
  filter->SetInputData(MakePolyData(mesh));
  filter->SetReferenceData(reference);
  filter->Update();
  const double before = filter->GetHausdorffBound();
  reference->SetPoints(MakePolyData(Transformed(Icosphere(2), 1.1))->GetPoints());
  reference->Modified();
  const std::string warnings = Update(filter).warnings;
  c.Greater("another reference is read", filter->GetHausdorffBound(), before + 0.05);
  c.Says("triangles beyond the deviation are counted in a warning", warnings,
    "640 triangles of the surface and of its Reference began farther apart");
  filter->SetReferenceConnection(nullptr);
  filter->Update();
  c.Less("without it the input is the reference again", filter->GetHausdorffBound(), before + 0.01);
  filter->SetMode(Optimizer::OPTIMIZE_TRIANGLES);
  filter->SetReferenceData(nullptr);
  c.True("other modes need none", Update(filter).errors.empty());
}

void CheckErrors(Checks& c)
{
  vtkNew<Optimizer> filter;
  filter->SetInputData(MakePolyData(Icosphere(1)));
  filter->SetReferenceData(vtkNew<vtkPolyData>());
  c.Says("a reference without triangles is an error", Update(filter).errors,
    "The Reference has no triangles");
  const auto reference = MakePolyData(Icosphere(1));
  reference->GetPoints()->SetPoint(3, std::numeric_limits<double>::quiet_NaN(), 0, 0);
  filter->SetReferenceData(reference);
  c.Says("an error of the reference says so", Update(filter).errors,
    "The Reference cannot be used. 1 point has NaN");
  filter->SetReferenceData(MakePolyData(Icosphere(1)));
  c.True("the filter works again", Update(filter).errors.empty());
}
}

int TestOptimizerReference(int argc, char* argv[])
{
  Groups groups(argc, argv);
  groups.Run("Data", CheckData);
  groups.Run("Soup", CheckSoup);
  groups.Run("Changes", CheckChanges);
  groups.Run("Errors", CheckErrors);
  return groups.Result();
}
