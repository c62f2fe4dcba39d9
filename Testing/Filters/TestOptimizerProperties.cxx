// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "FilterTesting.h"
#include "Private/OptimizerTables.h"

#include "vtkCellData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <limits>
#include <map>
#include <set>
#include <type_traits>

namespace
{
struct Access : vtkLaplacianMeshOptimizer
{
  using vtkLaplacianMeshOptimizer::Tables;
};
using Tables = Access::Tables;

const double NaN = std::numeric_limits<double>::quiet_NaN();
const double Infinity = std::numeric_limits<double>::infinity();

/// What a property takes, and what an error says of other values.
struct Limits
{
  std::vector<double> invalid;
  std::vector<double> valid;
  std::string error;
};

const std::map<std::string, Limits> PropertyLimits = {
  { "Mode", { { -1, 5, 99 }, { 0, 4 }, "choose a value from 0 to 4." } },
  { "LaplacianType", { { -1, 3, 99 }, { 0, 2 }, "choose a value from 0 to 2." } },
  { "PositionWeighting", { { -1, 5, 99 }, { 0, 4 }, "choose a value from 0 to 4." } },
  { "LaplacianWeighting", { { -1, 5, 99 }, { 0, 4 }, "choose a value from 0 to 4." } },
  { "BoundaryCondition", { { -1, 4, 99 }, { 0, 3 }, "choose a value from 0 to 3." } },
  { "SelectionUse", { { -1, 2, 99 }, { 0, 1 }, "choose a value from 0 to 1." } },
  { "SolverType", { { -1, 3, 99 }, { 0, 2 }, "choose a value from 0 to 2." } },
  { "ScaleFactor", { { 0, -1, 1e-300, 1e-41, 1e41, 1e300, NaN, Infinity }, { 1e-40, 1e40 },
                     "it must be more than 0, from 1e-40 to 1e40." } },
  { "GaussianWidth", { { 0, -1, NaN, Infinity }, { 1e-9, 1e9 }, "it must be more than 0." } },
  { "TangentPlaneWeight",
    { { -1, 1e41, 1e300, NaN, Infinity }, { 0, 1e40 }, "it must be 0 or more, up to 1e40." } },
  { "Tolerance", { { 0, 1, -1, NaN, Infinity }, { 1e-9, 0.999 }, "it must be between 0 and 1." } },
  { "MaximumNumberOfIterations", { { 0, -1 }, { 1 }, "it must be more than 0." } },
  { "MaximumDeviation",
    { { 0, -1, 1.01, NaN, Infinity }, { 1e-9, 1 }, "it must be more than 0, up to 1." } },
  { "NumberOfPasses", { { 0, -1 }, { 1 }, "it must be more than 0." } },
  { "FeatureAngle", { { -1, 180.5, NaN, Infinity }, { 0, 180 }, "it must be from 0 to 180." } },
  { "NormalIterations", { { -1 }, { 0 }, "it must be 0 or more." } },
  { "NormalWidth", { { 0, -1, NaN, Infinity }, { 1e-9, 1e9 }, "it must be more than 0." } },
  { "DetailWeight",
    { { 0, -1, 1e41, NaN, Infinity }, { 1e-9, 1e40 }, "it must be more than 0, up to 1e40." } },
};

void CheckDefaults(Checks& c)
{
  vtkNew<vtkLaplacianMeshOptimizer> filter;
  const lmo::OptimizerOptions options;
  Tables::VisitProperties(*filter.Get(), options,
    [&](const std::string& name, auto& value, auto, auto&... option)
    {
      using Value = std::decay_t<decltype(value)>;
      (c.Equal(name + " has the default of its option", value, static_cast<Value>(option)), ...);
    });
}

void CheckPrinting(Checks& c)
{
  vtkNew<vtkLaplacianMeshOptimizer> filter;
  std::ostringstream text;
  filter->Print(text);
  const auto check = [&](const std::string& name, auto value, auto...)
  {
    std::ostringstream line;
    line << "\n  " << name << ": " << value << "\n";
    c.Says("the filter prints " + name, text.str(), line.str());
  };
  const lmo::OptimizerOptions options;
  Tables::VisitProperties(*filter.Get(), options, check);
  Tables::VisitMetrics(*filter.Get(), {}, check);
}

/// Checks that the filter refuses the values outside the limits of a property, and no others.
template <typename Value>
void CheckLimits(Checks& c, vtkLaplacianMeshOptimizer* filter, const std::string& name,
  Value& property, const Limits& limits)
{
  const Value before = property;
  const auto isRefused = [&](double value)
  {
    property = static_cast<Value>(value);
    filter->Modified();
    std::ostringstream error;
    error << name << " is " << value << "; " << limits.error;
    return Update(filter).errors.find(error.str()) != std::string::npos;
  };
  for (const double value : limits.invalid)
  {
    std::ostringstream text;
    text << name << " " << value;
    const std::string what = text.str();
    c.True(what + " is an error that names the range", isRefused(value));
    // After a result, an error gives the input back.
    c.True(what + " gives no result", !filter->GetOutput()->GetCellData()->HasArray("RadiusRatio"));
  }
  for (const double value : limits.valid)
  {
    std::ostringstream text;
    text << name << " may be " << value;
    c.True(text.str(), !isRefused(value));
  }
  property = before;
  filter->Modified();
  c.True(name + ": the filter works again",
    Update(filter).errors.empty() && filter->GetOutput()->GetNumberOfPoints() == 42);
}

void CheckRanges(Checks& c)
{
  vtkNew<vtkLaplacianMeshOptimizer> filter;
  filter->SetInputData(MakePolyData(Icosphere(1)));
  const lmo::OptimizerOptions options;
  Tables::VisitProperties(*filter.Get(), options,
    [&](const std::string& name, auto& value, auto validValues, auto&...)
    {
      const auto limits = PropertyLimits.find(name);
      const bool isSwitch = std::is_same_v<decltype(validValues), lmo::Switch>;
      c.Equal(
        name + " has limits unless it is a switch", (limits == PropertyLimits.end()), isSwitch);
      if (limits != PropertyLimits.end())
      {
        CheckLimits(c, filter, name, value, limits->second);
      }
    });
}

std::map<std::string, double> MetricsOf(vtkLaplacianMeshOptimizer* filter)
{
  std::map<std::string, double> metrics;
  Tables::VisitMetrics(*filter, {},
    [&](const char* name, auto value, auto...) { metrics[name] = static_cast<double>(value); });
  return metrics;
}

void CheckMetricsOf(Checks& c, int mode)
{
  const std::string ofMode = " of mode " + std::to_string(mode);
  vtkNew<vtkLaplacianMeshOptimizer> filter;
  const auto initial = MetricsOf(filter);
  filter->SetInputData(MakePolyData(Icosphere(1)));
  filter->SetMode(mode);
  filter->Update();
  for (const auto& [name, value] : MetricsOf(filter))
  {
    const double written = FieldValue(filter->GetOutput(), name.c_str());
    static const std::set<std::string> ofDeviation{ "HausdorffBound", "RelativeHausdorffBound",
      "Passes", "RolledBackPoints", "PinnedBadTriangles", "InputSelfIntersections",
      "SelfIntersections" };
    const bool isWritten =
      ofDeviation.count(name) == 0 || mode == vtkLaplacianMeshOptimizer::OPTIMIZE_WITHIN_DEVIATION;
    c.True("the field data hold " + name + ofMode + " if it has one",
      isWritten ? written == value : std::isnan(written));
  }
  filter->Modified();
  filter->UpdateInformation();
  c.True("metrics" + ofMode + " are reset", MetricsOf(filter) == initial);
}

void CheckMetrics(Checks& c)
{
  CheckMetricsOf(c, vtkLaplacianMeshOptimizer::SMOOTH);
  CheckMetricsOf(c, vtkLaplacianMeshOptimizer::OPTIMIZE_WITHIN_DEVIATION);
}
}

int TestOptimizerProperties(int argc, char* argv[])
{
  Groups groups(argc, argv);
  groups.Run("Defaults", CheckDefaults);
  groups.Run("Printing", CheckPrinting);
  groups.Run("Ranges", CheckRanges);
  groups.Run("Metrics", CheckMetrics);
  return groups.Result();
}
