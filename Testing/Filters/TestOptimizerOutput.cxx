// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "FilterTesting.h"
#include "MeshMeasures.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkLaplacianMeshOptimizer.h"
#include "vtkMassProperties.h"
#include "vtkMeshLaplacian.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTriangleRadiusRatio.h"

#include <cmath>

using namespace lmo;

namespace
{
using Optimizer = vtkLaplacianMeshOptimizer;

vtkSmartPointer<vtkPolyData> WithRadiusRatio(vtkPolyData* input)
{
  vtkNew<vtkTriangleRadiusRatio> filter;
  filter->SetInputData(input);
  filter->Update();
  return filter->GetOutput();
}

double Volume(vtkPolyData* mesh)
{
  vtkNew<vtkMassProperties> properties;
  properties->SetInputData(mesh);
  return properties->GetVolume();
}

void CheckPointArrays(Checks& c)
{
  const auto input = MakeMixedPolyData();
  const auto output = Optimized(input);
  const std::pair<const char*, int> arrays[] = { { "RadiusRatio", 1 }, { "InputRadiusRatio", 1 },
    { "MeanCurvature", 1 }, { "PositionWeight", 1 }, { "LaplacianWeight", 1 },
    { "Displacement", 3 } };
  for (const auto& [name, components] : arrays)
  {
    const Eigen::MatrixXd values = PointValues(output, name);
    c.True(std::string("there is a point array ") + name,
      values.rows() == input->GetNumberOfPoints() && values.cols() == components);
  }
  c.Error("Displacement is output minus input",
    LargestMagnitude(PointValues(output, "Displacement") - (PointsOf(output) - PointsOf(input))),
    0);
  const Eigen::MatrixXd weights = PointValues(output, "PositionWeight").topRows(169);
  c.True("PositionWeight is the share of points with at most this curvature",
    weights.maxCoeff() == 1 && weights.minCoeff() > 0);
  c.Error("LaplacianWeight is 1",
    LargestMagnitude(PointValues(output, "LaplacianWeight").array() - 1), 0);
  vtkNew<vtkMeshLaplacian> laplacians;
  laplacians->SetInputData(input);
  laplacians->Update();
  c.Error("MeanCurvature is that of vtkMeshLaplacian",
    LargestMagnitude(
      PointValues(output, "MeanCurvature") - PointValues(laplacians->GetOutput(), "MeanCurvature")),
    0);
}

void CheckRadiusRatios(Checks& c)
{
  const auto input = MakeMixedPolyData();
  const auto output = Optimized(input);
  const auto before = WithRadiusRatio(input);
  const auto after = WithRadiusRatio(output);
  c.Error("RadiusRatio of the cells is that of vtkTriangleRadiusRatio",
    LargestMagnitude(CellValues(output, "RadiusRatio") - CellValues(after, "RadiusRatio")), 0);
  c.Error("RadiusRatio of the points is that of vtkTriangleRadiusRatio",
    LargestMagnitude(PointValues(output, "RadiusRatio") - PointValues(after, "RadiusRatio")), 0);
  c.Error("InputRadiusRatio of the cells is that of vtkTriangleRadiusRatio",
    LargestMagnitude(CellValues(output, "InputRadiusRatio") - CellValues(before, "RadiusRatio")),
    0);
  c.Error("InputRadiusRatio of the points is that of vtkTriangleRadiusRatio",
    LargestMagnitude(PointValues(output, "InputRadiusRatio") - PointValues(before, "RadiusRatio")),
    0);
  for (const char* name : { "RadiusRatio", "InputRadiusRatio" })
  {
    c.True(std::string("vertices and lines have -1: ") + name,
      (CellValues(output, name).topRows(3).array() == -1).all());
    c.True(std::string("triangles and strips have 0 to 1: ") + name,
      (CellValues(output, name).bottomRows(150).array() > 0).all());
    c.Equal(std::string("unused points have -1: ") + name, PointValues(output, name)(169), -1);
  }
  c.Different("RadiusRatio changes", FieldValue(output, "MeanRadiusRatio"),
    FieldValue(output, "InputMeanRadiusRatio"));
}

void CheckGetters(Checks& c, Optimizer* filter)
{
  const std::pair<const char*, double> metrics[] = { { "MeanRadiusRatio",
                                                       filter->GetMeanRadiusRatio() },
    { "MinimumRadiusRatio", filter->GetMinimumRadiusRatio() },
    { "InputMeanRadiusRatio", filter->GetInputMeanRadiusRatio() },
    { "InputMinimumRadiusRatio", filter->GetInputMinimumRadiusRatio() },
    { "MaximumDisplacement", filter->GetMaximumDisplacement() },
    { "RelativeMaximumDisplacement", filter->GetRelativeMaximumDisplacement() },
    { "RelativeVolumeChange", filter->GetRelativeVolumeChange() },
    { "FlippedTriangles", double(filter->GetFlippedTriangles()) },
    { "Iterations", double(filter->GetIterations()) },
    { "RelativeResidual", filter->GetRelativeResidual() } };
  for (const auto& [name, value] : metrics)
  {
    c.Equal(std::string("the field array is what the getter returns: ") + name,
      FieldValue(filter->GetOutput(), name), value);
  }
}

/// What only one mode proves is not found behind another.
void CheckProofs(Checks& c)
{
  const auto input = MakePolyData(Irregular(Icosphere(3), 0.02));
  const vtkNew<Optimizer> within;
  within->SetInputData(input);
  within->SetMode(Optimizer::OPTIMIZE_WITHIN_DEVIATION);
  const vtkNew<Optimizer> smooth;
  smooth->SetInputConnection(within->GetOutputPort());
  smooth->SetMode(Optimizer::SMOOTH);
  smooth->Update();
  c.Equal("the proved distance is a field array",
    FieldValue(within->GetOutput(), "RelativeHausdorffBound"), within->GetRelativeHausdorffBound());
  for (const char* name :
    { "HausdorffBound", "RelativeHausdorffBound", "Passes", "RolledBackPoints" })
  {
    c.True(std::string("smoothing proves nothing: ") + name,
      !smooth->GetOutput()->GetFieldData()->HasArray(name));
  }
}

/// A length in place of a fraction of the diagonal gives the same result.
void CheckAbsoluteDeviation(Checks& c)
{
  const auto input = MakePolyData(WithThinTriangles(Icosphere(3, 50)));
  const vtkNew<Optimizer> relative;
  relative->SetInputData(input);
  relative->SetMaximumDeviation(0.001);
  relative->Update();
  const vtkNew<Optimizer> absolute;
  absolute->SetInputData(input);
  absolute->DeviationIsAbsoluteOn();
  absolute->SetMaximumDeviation(0.001 * input->GetLength());
  absolute->Update();
  c.Error("a length is the same as its fraction of the diagonal",
    MaximumDistance(PointsOf(relative->GetOutput()), PointsOf(absolute->GetOutput())), 0);
  c.Greater("the length may be above 1", absolute->GetHausdorffBound(), 0.01);
  c.Error("both bounds are one",
    std::abs(
      absolute->GetHausdorffBound() / input->GetLength() - absolute->GetRelativeHausdorffBound()),
    1e-15);
  absolute->SetMaximumDeviation(2);
  c.True("a length above 1 is no error", Update(absolute).errors.empty());
  absolute->DeviationIsAbsoluteOff();
  c.True("a fraction above 1 is one", !Update(absolute).errors.empty());
}

void CheckMetrics(Checks& c)
{
  const TestMesh sphere = Irregular(Icosphere(3), 0.02);
  const auto input = MakePolyData(sphere);
  vtkNew<Optimizer> filter;
  filter->SetInputData(input);
  filter->SetMode(Optimizer::SMOOTH);
  filter->SetScaleFactor(0.1);
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  CheckGetters(c, filter);

  const Eigen::MatrixXd before = CellValues(output, "InputRadiusRatio");
  const Eigen::MatrixXd after = CellValues(output, "RadiusRatio");
  c.Error("MeanRadiusRatio", std::abs(filter->GetMeanRadiusRatio() - after.mean()), 1e-14);
  c.Error("MinimumRadiusRatio", std::abs(filter->GetMinimumRadiusRatio() - after.minCoeff()), 0);
  c.Error(
    "InputMeanRadiusRatio", std::abs(filter->GetInputMeanRadiusRatio() - before.mean()), 1e-14);
  c.Error("InputMinimumRadiusRatio",
    std::abs(filter->GetInputMinimumRadiusRatio() - before.minCoeff()), 0);

  const double displacement = MaximumDistance(PointsOf(output), sphere.V);
  c.Error("MaximumDisplacement", std::abs(filter->GetMaximumDisplacement() - displacement), 1e-15);
  c.Error("RelativeMaximumDisplacement",
    std::abs(filter->GetRelativeMaximumDisplacement() - displacement / input->GetLength()), 1e-15);
  c.Error("RelativeVolumeChange",
    std::abs(filter->GetRelativeVolumeChange() - (Volume(output) / Volume(input) - 1)), 1e-6);
  c.Less("smoothing shrinks a sphere", filter->GetRelativeVolumeChange(), -0.001);
  c.Greater("the solver iterates", filter->GetIterations(), 0);
  c.True("the residual is within the tolerance",
    filter->GetRelativeResidual() > 0 && filter->GetRelativeResidual() <= 1e-6);

  filter->SetScaleFactor(0.2);
  filter->UpdateInformation();
  c.True("metrics are undefined when the output is out of date",
    filter->GetMeanRadiusRatio() == -1 && filter->GetMaximumDisplacement() == 0);
}

void CheckOpenSurface(Checks& c)
{
  c.Equal("an open surface has no volume change",
    FieldValue(Optimized(MakeMixedPolyData()), "RelativeVolumeChange"), 0);
}

/// A ring whose centre is prescribed to be at (2, 1), across one edge of the ring.
void CheckFlips(Checks& c)
{
  const auto input = MakePolyData(CrossRing());
  Points f = Points::Zero(5, 3);
  f.row(0) = Vector3(0.25, -0.25, 0) - Vector3(2, 1, 0);
  AddPointArray(input, "f", f);
  AddPointArray(input, "free", Vector::Zero(5));
  const auto output = Optimized(input,
    [](Optimizer* filter)
    {
      filter->SetMode(Optimizer::PRESCRIBED_LAPLACIANS);
      filter->SetPositionWeighting(Optimizer::ARRAY);
      filter->SetSolverType(Optimizer::DIRECT);
      filter->SetInputArrayToProcess(Optimizer::PRESCRIBED_LAPLACIAN_ARRAY, 0, 0, 0, "f");
      filter->SetInputArrayToProcess(Optimizer::POSITION_WEIGHT_ARRAY, 0, 0, 0, "free");
    });
  c.Error(
    "a prescribed Laplacian is met", (PointsOf(output).row(0) - Vector3(2, 1, 0)).norm(), 1e-12);
  c.Error("the centre moved by sqrt 5",
    std::abs(FieldValue(output, "MaximumDisplacement") - std::sqrt(5)), 1e-12);
  c.Equal("one triangle flipped", FieldValue(output, "FlippedTriangles"), 1);
}
}

int TestOptimizerOutput(int argc, char* argv[])
{
  Groups groups(argc, argv);
  groups.Run("PointArrays", CheckPointArrays);
  groups.Run("RadiusRatios", CheckRadiusRatios);
  groups.Run("OpenSurface", CheckOpenSurface);
  groups.Run("Proofs", CheckProofs);
  groups.Run("AbsoluteDeviation", CheckAbsoluteDeviation);
  groups.Run("Metrics", CheckMetrics);
  groups.Run("Flips", CheckFlips);
  return groups.Result();
}
