// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkCases.h"

#include "BenchmarkCgal.h"

#include "vtkLaplacianMeshOptimizer.h"
#include "vtkPolyData.h"
#include "vtkSmoothPolyDataFilter.h"
#include "vtkWindowedSincPolyDataFilter.h"

#include <sstream>

const char* const ReferenceCase = "windowed-sinc";

namespace
{
using Optimizer = vtkLaplacianMeshOptimizer;

template <typename Filter, typename SetUp>
Case MakeCase(const std::string& name, const std::string& title, const SetUp& setUp)
{
  Case result;
  result.name = name;
  result.title = title;
  result.prepare = [setUp](vtkPolyData* mesh)
  {
    auto filter = vtkSmartPointer<Filter>::New();
    filter->SetInputData(mesh);
    setUp(filter.Get());
    return filter;
  };
  return result;
}

Case SmoothPolyData(int iterations)
{
  const std::string number = std::to_string(iterations);
  return MakeCase<vtkSmoothPolyDataFilter>("smooth-poly-data-" + number, "VTK smooth " + number,
    [iterations](vtkSmoothPolyDataFilter* filter) { filter->SetNumberOfIterations(iterations); });
}

void AddPeers(std::vector<Case>& cases)
{
  cases.push_back(MakeCase<vtkWindowedSincPolyDataFilter>(ReferenceCase, "VTK sinc",
    [](vtkWindowedSincPolyDataFilter* filter) { filter->SetNumberOfIterations(20); }));
  cases.push_back(SmoothPolyData(20));
  cases.push_back(SmoothPolyData(100));
  cases.back().maximumVertices = 1000000;

  if (!CgalVersion().empty())
  {
    Case relaxation;
    relaxation.name = "cgal-relaxation";
    relaxation.title = "CGAL relax";
    relaxation.prepare = [](vtkPolyData* mesh) { return MakeCgalRelaxation(mesh, 10); };
    relaxation.maximumVertices = 300000;
    relaxation.hasOutput = false;
    cases.push_back(relaxation);
  }
}

/// One solve in mode OPTIMIZE_TRIANGLES.
Case OneSolve(const char* name, const char* title, const std::function<void(Optimizer*)>& choose)
{
  return MakeCase<Optimizer>(name, title,
    [choose](Optimizer* filter)
    {
      filter->SetMode(Optimizer::OPTIMIZE_TRIANGLES);
      choose(filter);
    });
}

void AddTriangleCases(std::vector<Case>& cases)
{
  cases.push_back(OneSolve("triangles-cdf", "CDF", [](Optimizer*) {}));
  cases.push_back(OneSolve("triangles-linear", "LINEAR",
    [](Optimizer* filter) { filter->SetPositionWeighting(Optimizer::LINEAR); }));
  cases.push_back(OneSolve(
    "tangent-planes", "planes", [](Optimizer* filter) { filter->TangentPlaneConstraintsOn(); }));
  cases.push_back(OneSolve("resolve", "again",
    [](Optimizer* filter)
    {
      filter->Update();
      filter->SetScaleFactor(0.95);
    }));
  for (const int passes : { 5, 3 })
  {
    const std::string number = std::to_string(passes);
    cases.push_back(MakeCase<Optimizer>("within-deviation-" + number, "within " + number,
      [passes](Optimizer* filter)
      {
        filter->SetMode(Optimizer::OPTIMIZE_WITHIN_DEVIATION);
        filter->SetNumberOfPasses(passes);
      }));
  }
}

Case Smoothing(const std::string& name, const std::string& title, int laplacian, double scaleFactor,
  int weighting)
{
  Case result = MakeCase<Optimizer>("smooth-" + name, title,
    [=](Optimizer* filter)
    {
      filter->SetMode(Optimizer::SMOOTH);
      filter->SetLaplacianType(laplacian);
      filter->SetScaleFactor(scaleFactor);
      filter->SetPositionWeighting(weighting);
    });
  result.table = CaseTable::Smoothing;
  if (laplacian != Optimizer::UNIFORM)
  {
    result.maximumVertices = 1000000;
  }
  return result;
}

void AddSmoothingCases(
  std::vector<Case>& cases, const std::string& name, const std::string& title, int laplacian)
{
  for (const double scaleFactor : { 1., 0.1, 0.01 })
  {
    std::ostringstream number;
    number << scaleFactor;
    cases.push_back(Smoothing(name + "-" + number.str(), title + " " + number.str(), laplacian,
      scaleFactor, Optimizer::CDF));
  }
  cases.push_back(
    Smoothing(name + "-0.01-const", title + " 0.01 c", laplacian, 0.01, Optimizer::CONSTANT));
}
}

std::vector<Case> AllCases()
{
  std::vector<Case> cases;
  AddPeers(cases);
  AddTriangleCases(cases);
  AddSmoothingCases(cases, "uniform", "U", Optimizer::UNIFORM);
  AddSmoothingCases(cases, "cotangent", "C", Optimizer::COTANGENT);
  AddSmoothingCases(cases, "curvature", "K", Optimizer::MEAN_CURVATURE);
  cases.push_back(MakeCase<Optimizer>(
    "guided", "guided", [](Optimizer* filter) { filter->SetMode(Optimizer::SMOOTH_GUIDED); }));
  cases.back().table = CaseTable::Smoothing;
  return cases;
}
