// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "FilterTesting.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkLaplacianMeshOptimizer.h"
#include "vtkLogger.h"
#include "vtkNew.h"
#include "vtkOutputWindow.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStringOutputWindow.h"
#include "vtkTestErrorObserver.h"

#include <cmath>
#include <limits>

using namespace lmo;

namespace
{
using Optimizer = vtkLaplacianMeshOptimizer;

const double NaN = std::numeric_limits<double>::quiet_NaN();
const double Infinity = std::numeric_limits<double>::infinity();

/// Checks that the filter refuses what \a spoil does to it or its input, with an error that holds
/// all of \a texts, and recovers.
void CheckRefusal(Checks& c, const std::string& what,
  const std::function<void(Optimizer*, vtkPolyData*)>& spoil, const std::vector<std::string>& texts)
{
  vtkNew<Optimizer> filter;
  filter->SetMode(Optimizer::OPTIMIZE_TRIANGLES);
  filter->SetInputData(MakePolyData(Icosphere(1)));
  filter->Update();

  const auto input = MakePolyData(Icosphere(1));
  spoil(filter, input);
  filter->SetInputData(input);
  const std::string errors = Update(filter).errors;
  for (const std::string& text : texts)
  {
    c.Says(what + ": the error says '" + text + "'", errors, text);
  }
  c.True(what + ": the output is empty", IsEmpty(filter->GetOutput()));

  vtkNew<Optimizer> defaults;
  filter->SetMode(defaults->GetMode());
  filter->SetFreeAxes(1, 1, 1);
  filter->SetPositionWeighting(defaults->GetPositionWeighting());
  filter->SetLaplacianWeighting(defaults->GetLaplacianWeighting());
  for (int index = 0; index < 5; ++index)
  {
    filter->SetInputArrayToProcess(index, 0, 0, 0, "None");
  }
  filter->SetInputData(MakePolyData(Icosphere(1)));
  c.True(what + ": the filter works again",
    Update(filter).errors.empty() && filter->GetOutput()->GetNumberOfPoints() == 42);
}

void CheckCells(Checks& c)
{
  CheckRefusal(c, "polygons of two points",
    [](Optimizer*, vtkPolyData* input) {
      input->GetPolys()->InsertNextCell({ 0, 1 });
    },
    { "1 polygon", "cell 80", "vtkCleanPolyData" });
  CheckRefusal(c, "point ids that are too large",
    [](Optimizer*, vtkPolyData* input) {
      input->GetPolys()->InsertNextCell({ 0, 1, 42 });
    },
    { "1 cell", "cell 80", "Repair" });
  CheckRefusal(c, "negative point ids",
    [](Optimizer*, vtkPolyData* input) {
      input->GetPolys()->InsertNextCell({ 0, -1, 2 });
    },
    { "1 cell", "cell 80", "Repair" });
  CheckRefusal(c, "point ids of a quad that are too large",
    [](Optimizer*, vtkPolyData* input) {
      input->GetPolys()->InsertNextCell({ 0, 1, 42, 2 });
    },
    { "1 cell", "cell 80", "Repair" });
  CheckRefusal(c, "point ids of a strip that are too large",
    [](Optimizer*, vtkPolyData* input)
    {
      vtkNew<vtkCellArray> strips;
      strips->InsertNextCell({ 0, 1, 2, 1000 });
      input->SetStrips(strips);
    },
    { "1 cell", "cell 80", "Repair" });
}

void CheckCoordinates(Checks& c)
{
  CheckRefusal(c, "NaN coordinates",
    [](Optimizer*, vtkPolyData* input)
    {
      input->GetPoints()->SetPoint(5, 0, NaN, 0);
      input->GetPoints()->SetPoint(7, NaN, NaN, NaN);
    },
    { "2 points", "NaN", "point 5", "Remove" });
  CheckRefusal(c, "infinite coordinates",
    [](Optimizer*, vtkPolyData* input) { input->GetPoints()->SetPoint(41, 0, 0, -Infinity); },
    { "1 point", "infinite", "point 41", "Remove" });
}

/// Squares of such coordinates overflow.
void CheckHugeCoordinates(Checks& c)
{
  for (const int mode : { Optimizer::OPTIMIZE_TRIANGLES, Optimizer::SMOOTH })
  {
    const auto input = MakePolyData(Icosphere(1));
    input->GetPoints()->SetPoint(3, 1e300, 0, 0);
    vtkNew<Optimizer> filter;
    filter->SetInputData(input);
    filter->SetMode(mode);
    const bool isRefused = !Update(filter).errors.empty();
    c.True("a coordinate of 1e300 is refused or does no harm",
      isRefused || (std::isfinite(filter->GetRelativeResidual()) &&
                     std::isfinite(filter->GetMaximumDisplacement()) &&
                     PointValues(filter->GetOutput(), "MeanCurvature").allFinite()));
  }
}

void CheckOverflow(Checks& c)
{
  CheckRefusal(c, "a result beyond the range of float",
    [](Optimizer* filter, vtkPolyData* input)
    {
      input->DeepCopy(MakePolyData(Icosphere(1), VTK_FLOAT));
      AddPointArray(input, "Array", Eigen::MatrixXd::Random(42, 3) * 1e45);
      filter->SetMode(Optimizer::PRESCRIBED_LAPLACIANS);
      filter->SetInputArrayToProcess(Optimizer::PRESCRIBED_LAPLACIAN_ARRAY, 0, 0,
        vtkDataObject::FIELD_ASSOCIATION_POINTS, "Array");
    },
    { "42 points", "range", "point 0", "double" });
}

/// The normals are written, not only read.
void CheckNormals(Checks& c)
{
  CheckRefusal(c, "normals of a wrong size",
    [](Optimizer*, vtkPolyData* input)
    {
      AddPointArray(input, "Array", Eigen::MatrixXd::Ones(1, 3));
      input->GetPointData()->SetActiveNormals("Array");
    },
    { "'Array'", "1 tuples", "42" });
}

/// Adds the array "Array" and chooses it.
std::function<void(Optimizer*, vtkPolyData*)> ChooseArray(
  int index, const Eigen::MatrixXd& values, const std::function<void(Optimizer*)>& choose)
{
  return [=](Optimizer* filter, vtkPolyData* input)
  {
    AddPointArray(input, "Array", values);
    filter->SetInputArrayToProcess(index, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Array");
    choose(filter);
  };
}

void CheckArray(Checks& c, const std::string& name, int index, int components, bool isWeight,
  const std::function<void(Optimizer*)>& choose)
{
  Eigen::MatrixXd values = Eigen::MatrixXd::Ones(42, components);
  CheckRefusal(c, name + " of a wrong size", ChooseArray(index, values.topRows(41), choose),
    { "'Array'", "41 tuples", "42", "Choose" });
  CheckRefusal(c, name + " with wrong components",
    ChooseArray(index, Eigen::MatrixXd::Ones(42, 2), choose),
    { "'Array'", "2 components", std::to_string(components), "Choose" });
  values(9, components - 1) = NaN;
  values(10, 0) = Infinity;
  CheckRefusal(c, name + " with NaN and infinity", ChooseArray(index, values, choose),
    { "2 values", "'Array'", "NaN", "point 9", "Replace" });
  values.setOnes();
  values(3, 0) = values(8, 0) = -1;
  if (isWeight)
  {
    CheckRefusal(c, name + " below 0", ChooseArray(index, values, choose),
      { "2 weights", "'Array'", "negative", "point 3", "0 or more" });
    values(3, 0) = values(8, 0) = 1e300;
    CheckRefusal(c, name + " that overflow", ChooseArray(index, values, choose),
      { "2 weights", "'Array'", "above 1e40", "point 3", "Scale" });
  }
  CheckRefusal(c, name + " that do not exist",
    [&](Optimizer* filter, vtkPolyData*)
    {
      filter->SetInputArrayToProcess(
        index, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Missing");
      choose(filter);
    },
    { "'Missing'", "Choose" });
}

/// \param useLabels switches on what reads the labels of cells
void CheckCellArray(
  Checks& c, const std::string& use, const std::function<void(Optimizer*)>& useLabels)
{
  CheckRefusal(c, "a cell array with wrong components for " + use,
    [&](Optimizer* filter, vtkPolyData* input)
    {
      vtkNew<vtkDoubleArray> labels;
      labels->SetName("Labels");
      labels->SetNumberOfComponents(3);
      labels->SetNumberOfTuples(80);
      labels->Fill(0);
      input->GetCellData()->AddArray(labels);
      useLabels(filter);
      filter->SetInputArrayToProcess(
        Optimizer::FEATURE_ARRAY, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "Labels");
    },
    { "the cell array 'Labels'", "3 components", "80 tuples of 1" });
}

void CheckNoArray(Checks& c, const std::string& name, const std::function<void(Optimizer*)>& choose)
{
  CheckRefusal(c, name + " that are not chosen",
    [&](Optimizer* filter, vtkPolyData*) { choose(filter); }, { "array", "Choose one" });
}

void CheckFreeAxes(Checks& c)
{
  CheckRefusal(c, "no free axis",
    [](Optimizer* filter, vtkPolyData*) { filter->SetFreeAxes(0, 0, 0); },
    { "FreeAxes is 0 0 0", "at least one" });
}

void CheckArrays(Checks& c)
{
  const auto weights = [](Optimizer* filter) { filter->SetPositionWeighting(Optimizer::ARRAY); };
  const auto anchors = [](Optimizer* filter) { filter->SetPositionWeighting(Optimizer::ANCHORS); };
  const auto falloff = [](Optimizer* filter) { filter->SetLaplacianWeighting(Optimizer::ARRAY); };
  const auto prescribed = [](Optimizer* filter)
  { filter->SetMode(Optimizer::PRESCRIBED_LAPLACIANS); };
  const auto nothing = [](Optimizer*) {};
  CheckArray(c, "position weights", Optimizer::POSITION_WEIGHT_ARRAY, 1, true, weights);
  CheckArray(c, "anchors", Optimizer::POSITION_WEIGHT_ARRAY, 1, false, anchors);
  CheckArray(c, "Laplacian weights", Optimizer::LAPLACIAN_WEIGHT_ARRAY, 1, true, falloff);
  CheckArray(
    c, "prescribed Laplacians", Optimizer::PRESCRIBED_LAPLACIAN_ARRAY, 3, false, prescribed);
  CheckArray(c, "fixed points", Optimizer::FIXED_POINT_ARRAY, 1, false, nothing);
  CheckCellArray(c, "features", [](Optimizer* filter) { filter->FeatureConstraintsOn(); });
  CheckCellArray(c, "lines that become smooth",
    [](Optimizer* filter)
    {
      filter->SetMode(Optimizer::SMOOTH);
      filter->FeatureSmoothingOn();
    });
  CheckCellArray(c, "volumes",
    [](Optimizer* filter)
    {
      filter->SetMode(Optimizer::SMOOTH);
      filter->PreserveVolumeOn();
    });
  CheckNoArray(c, "position weights", weights);
  CheckNoArray(c, "anchors", anchors);
  CheckNoArray(c, "Laplacian weights", falloff);
  CheckNoArray(c, "prescribed Laplacians", prescribed);
}

/// One process that is asked for a piece would tear the surface at the boundaries.
void CheckPieces(Checks& c)
{
  vtkNew<Optimizer> filter;
  filter->SetInputData(MakePolyData(Icosphere(1)));
  vtkNew<vtkTest::ErrorObserver> observer;
  filter->AddObserver(vtkCommand::ErrorEvent, observer);
  filter->UpdatePiece(0, 2, 0);
  c.Says("pieces are an error that names what is missing", observer->GetErrorMessage(), "PETSc");
  c.True("there is no result for a piece", IsEmpty(filter->GetOutput()));
}

void CheckAfterwards(Checks& c)
{
  vtkNew<Optimizer> filter;
  filter->SetInputData(MakePolyData(Icosphere(1)));
  filter->Update();
  filter->SetTolerance(-1);
  c.Says("settings are an error after a result, too", Update(filter).errors, "Tolerance");
  c.Equal("an error then gives the input", filter->GetOutput()->GetNumberOfPoints(), 42);
  c.True("the input has no results", !filter->GetOutput()->GetCellData()->HasArray("RadiusRatio"));
  filter->SetInputData(MakePolyData(Icosphere(2)));
  Update(filter);
  c.True("of a new input an error gives nothing", IsEmpty(filter->GetOutput()));
}

void CheckNumberOfErrors(Checks& c)
{
  const vtkSmartPointer<vtkOutputWindow> window = vtkOutputWindow::GetInstance();
  vtkNew<vtkStringOutputWindow> heard;
  vtkOutputWindow::SetInstance(heard);
  const auto verbosity = vtkLogger::GetCurrentVerbosityCutoff();
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  vtkNew<Optimizer> filter;
  filter->SetInputData(MakePolyData(Icosphere(1)));
  filter->SetTolerance(-1);
  filter->Update();
  filter->SetInputConnection(nullptr);
  filter->Update();
  vtkLogger::SetStderrVerbosity(verbosity);
  vtkOutputWindow::SetInstance(window);
  const std::string output = heard->GetOutput();
  c.True("one fault is one error", output.find("returned failure") == std::string::npos);
  c.Says("errors of the pipeline are still told", output, "not optional");
}
}

int TestOptimizerErrors(int argc, char* argv[])
{
  Groups groups(argc, argv);
  groups.Run("Cells", CheckCells);
  groups.Run("Coordinates", CheckCoordinates);
  groups.Run("FreeAxes", CheckFreeAxes);
  groups.Run("Arrays", CheckArrays);
  groups.Run("HugeCoordinates", CheckHugeCoordinates);
  groups.Run("Overflow", CheckOverflow);
  groups.Run("Normals", CheckNormals);
  groups.Run("Pieces", CheckPieces);
  groups.Run("Afterwards", CheckAfterwards);
  groups.Run("NumberOfErrors", CheckNumberOfErrors);
  return groups.Result();
}
