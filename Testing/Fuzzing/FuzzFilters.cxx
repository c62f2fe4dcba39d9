// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause

// Makes a vtkPolyData and parameters from bytes and runs every filter. Aborts if one gives neither
// a finite result nor an error, or changes its input.
#include "FuzzInput.h"

#include "../Filters/ResultChecks.h"

#include "vtkLaplacianMeshOptimizer.h"
#include "vtkMeshLaplacian.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSurfaceDeviation.h"
#include "vtkTriangleRadiusRatio.h"

#include <cstdlib>
#include <iostream>

namespace
{
void AbortIf(const std::string& fault, const char* filter)
{
  if (!fault.empty())
  {
    std::cerr << filter << ": " << fault << std::endl;
    std::abort();
  }
}

void CheckOptimizer(FuzzBytes& bytes, vtkPolyData* data)
{
  vtkNew<vtkLaplacianMeshOptimizer> filter;
  filter->SetInputData(data);
  SetUp(filter, bytes);
  const Messages messages = Update(filter);
  AbortIf(messages.errors.empty() ? FaultOfResult(filter, messages)
                                  : FaultOfRefusal(filter, messages, {}),
    "vtkLaplacianMeshOptimizer");
}

void CheckFilter(
  vtkPolyDataAlgorithm* filter, vtkPolyData* data, std::initializer_list<const char*> arrays)
{
  filter->SetInputData(data);
  const Messages messages = Update(filter);
  AbortIf(messages.errors.empty() ? FaultOfResult(filter, messages, arrays)
                                  : FaultOfRefusal(filter, messages, {}),
    filter->GetClassName());
}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  FuzzBytes bytes(data, size);
  const auto mesh = MakeFuzzMesh(bytes);
  const auto other = MakeFuzzMesh(bytes);
  const auto copy = CopyOf(mesh);
  CheckOptimizer(bytes, mesh);
  vtkNew<vtkMeshLaplacian> laplacian;
  laplacian->SetRobustLaplacian(bytes.Take(2));
  laplacian->PrincipalCurvaturesOn();
  CheckFilter(laplacian, mesh,
    { "UniformLaplacian", "CotangentLaplacian", "MeanCurvatureNormal", "MeanCurvature",
      "GaussianCurvature", "VoronoiArea", "SignedMeanCurvature", "PrincipalCurvature1",
      "PrincipalCurvature2", "PrincipalDirection1", "PrincipalDirection2" });
  CheckFilter(vtkNew<vtkTriangleRadiusRatio>(), mesh, { "RadiusRatio" });
  vtkNew<vtkSurfaceDeviation> deviation;
  deviation->SetNumberOfSamples(bytes.Take(64));
  deviation->SetReferenceData(other);
  CheckFilter(deviation, mesh, { "Distance" });
  AbortIf(AreEqual(mesh, copy) ? "" : "changed", "the input");
  return 0;
}
