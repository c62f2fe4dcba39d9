// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "FilterTesting.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkLaplacianMeshOptimizer.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

using namespace lmo;

namespace
{
using Optimizer = vtkLaplacianMeshOptimizer;

std::string WarningsOf(
  vtkPolyData* input, int mode, const std::function<void(Optimizer*)>& setUp = [](Optimizer*) {})
{
  vtkNew<Optimizer> filter;
  filter->SetInputData(input);
  filter->SetMode(mode);
  setUp(filter);
  return Update(filter).warnings;
}

bool Has(const std::string& text, const char* part)
{
  return text.find(part) != std::string::npos;
}

const int AllModes[] = { Optimizer::OPTIMIZE_TRIANGLES, Optimizer::SMOOTH,
  Optimizer::OPTIMIZE_WITHIN_DEVIATION, Optimizer::SMOOTH_GUIDED };

/// The triangles of a sphere without common points.
vtkSmartPointer<vtkPolyData> TriangleSoup()
{
  const TestMesh sphere = Icosphere(1);
  TestMesh soup{ Points(3 * sphere.T.rows(), 3), Triangles(sphere.T.rows(), 3) };
  for (Index t = 0; t < soup.T.rows(); ++t)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      soup.V.row(3 * t + corner) = sphere.V.row(sphere.T(t, corner));
      soup.T(t, corner) = 3 * t + corner;
    }
  }
  return MakePolyData(soup);
}

void CheckWhatCannotMove(Checks& c)
{
  vtkNew<vtkPolyData> nothing;
  for (const int mode : AllModes)
  {
    const std::string name = " in mode " + std::to_string(mode);
    const auto pin = [](Optimizer* filter)
    { filter->SetInputArrayToProcess(Optimizer::FIXED_POINT_ARRAY, 0, 0, 0, "Pinned"); };
    const auto pinned = MakePolyData(Icosphere(1));
    AddPointArray(pinned, "Pinned", Vector::Ones(42));
    c.True("a surface whose points are all pinned gives a warning" + name,
      Has(WarningsOf(pinned, mode, pin), "No point can move: 42 fixed"));
    c.True("a surface that can move gives none" + name, !Has(WarningsOf(pinned, mode), "can move"));
    c.True("lines alone give a warning" + name,
      Has(WarningsOf(MakePolyData({ Points::Random(5, 3), Triangles(0, 3) }), mode),
        "5 without a triangle"));
    c.True("an empty input gives none" + name, WarningsOf(nothing, mode).empty());
  }
}

/// A needle-shaped prism whose points all lie on sharp edges: the defaults of the unbounded modes
/// do not fit it.
vtkSmartPointer<vtkPolyData> SlenderBar()
{
  TestMesh bar = Cube(2);
  bar.V.col(0) = 10 * bar.V.col(0).array().square();
  return MakePolyData(bar);
}

void CheckDamage(Checks& c)
{
  const auto sphere = MakePolyData(Icosphere(2));
  const auto strongly = [](Optimizer* filter)
  {
    filter->SetPositionWeighting(Optimizer::CONSTANT);
    filter->SetScaleFactor(0.01);
  };
  const std::string shrunk = WarningsOf(sphere, Optimizer::SMOOTH, strongly);
  c.True("a sphere that shrinks gives a warning", Has(shrunk, "1 of 1 closed component"));
  c.True("its remedy is right", WarningsOf(sphere, Optimizer::SMOOTH,
                                  [&](Optimizer* filter)
                                  {
                                    strongly(filter);
                                    filter->PreserveVolumeOn();
                                  })
                                  .empty());
  c.True("slight smoothing gives no warning",
    WarningsOf(sphere, Optimizer::SMOOTH, [](Optimizer* filter) { filter->SetScaleFactor(5); })
      .empty());
  const auto weakly = [](Optimizer* filter)
  {
    filter->SetPositionWeighting(Optimizer::CONSTANT);
    filter->SetScaleFactor(0.001);
  };
  c.True("OPTIMIZE_TRIANGLES that wrecks a coarse shape gives a warning with its remedy",
    Has(WarningsOf(SlenderBar(), Optimizer::OPTIMIZE_TRIANGLES, weakly),
      "OPTIMIZE_WITHIN_DEVIATION"));
  c.True("the default mode needs no warning",
    WarningsOf(SlenderBar(), Optimizer::OPTIMIZE_WITHIN_DEVIATION).empty());
}

void CheckVolumes(Checks& c)
{
  const auto preserve = [](Optimizer* filter)
  {
    filter->PreserveVolumeOn();
    filter->SetScaleFactor(0.2);
    filter->SetInputArrayToProcess(Optimizer::FEATURE_ARRAY, 0, 0, 1, "Labels");
  };
  // As surface nets give it: the labels on both sides of each cell, in any order.
  const auto sphere = MakePolyData(Icosphere(2));
  vtkNew<vtkDoubleArray> labels;
  labels->SetName("Labels");
  labels->SetNumberOfComponents(2);
  for (vtkIdType cell = 0; cell < sphere->GetNumberOfCells(); ++cell)
  {
    labels->InsertNextTuple2(cell % 2, 1 - cell % 2);
  }
  sphere->GetCellData()->AddArray(labels);
  c.Equal("a volume that is preserved gives no warning",
    WarningsOf(sphere, Optimizer::SMOOTH, preserve), std::string());
  labels->SetTuple2(7, 2, 3);
  c.True(
    "labels that enclose nothing give one", Has(WarningsOf(sphere, Optimizer::SMOOTH, preserve),
                                              "The volume of 4 components or labels is not"));
}

void CheckDefault(Checks& c)
{
  vtkNew<Optimizer> filter;
  filter->SetInputData(MakePolyData(Irregular(Icosphere(2), 0.05)));
  filter->Update();
  c.Equal("the default mode is that with a guarantee", filter->GetMode(),
    Optimizer::OPTIMIZE_WITHIN_DEVIATION);
  c.Error("the default keeps the surface within MaximumDeviation",
    filter->GetRelativeHausdorffBound(), filter->GetMaximumDeviation());
  c.Greater("the default improves the triangles", filter->GetMeanRadiusRatio(),
    filter->GetInputMeanRadiusRatio());
}
}

int TestOptimizerWarnings(int, char*[])
{
  Checks c;
  CheckWhatCannotMove(c);
  c.True("triangles that share no points give a warning unless these are welded",
    Has(WarningsOf(TriangleSoup(), Optimizer::OPTIMIZE_WITHIN_DEVIATION,
          [](Optimizer* filter) { filter->WeldCoincidentPointsOff(); }),
      "240 on boundaries"));
  CheckDamage(c);
  CheckVolumes(c);
  CheckDefault(c);
  return c.Result();
}
