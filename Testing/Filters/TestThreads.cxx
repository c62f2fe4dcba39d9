// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "FilterTesting.h"

#include "vtkLaplacianMeshOptimizer.h"
#include "vtkMeshLaplacian.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkSurfaceDeviation.h"
#include "vtkTriangleRadiusRatio.h"

using namespace lmo;

namespace
{
/// Executes the filter ten times (once with a sanitizer) on several threads, by each backend that
/// this VTK has.
void CheckRepeats(Checks& c, const std::string& name, vtkPolyDataAlgorithm* filter)
{
  constexpr int executions = 10 / Thinning;
  constexpr int threads = 4;
  vtkSmartPointer<vtkPolyData> first;
  for (const char* backend : { "Sequential", "STDThread", "TBB", "OpenMP" })
  {
    if (!vtkSMPTools::SetBackend(backend))
    {
      continue;
    }
    vtkSMPTools::Initialize(threads);
    int different = 0;
    for (int k = 0; k < executions; ++k)
    {
      filter->Modified();
      filter->Update();
      auto result = vtkSmartPointer<vtkPolyData>::New();
      result->ShallowCopy(filter->GetOutput());
      first = first ? first : result;
      different +=
        !AreEqual(result, first) || !Contains(first->GetFieldData(), result->GetFieldData());
    }
    c.Equal(name + " gives one result on the threads of " + backend, different, 0);
  }
  vtkSMPTools::Initialize(0);
}

void CheckOptimizer(Checks& c, vtkPolyData* mesh, int mode, const std::string& name)
{
  vtkNew<vtkLaplacianMeshOptimizer> filter;
  filter->SetInputData(mesh);
  filter->SetMode(mode);
  CheckRepeats(c, name, filter);
}
}

int TestThreads(int, char*[])
{
  Checks c;
  const auto mesh = MakePolyData(Irregular(Icosphere(3), 0.1));

  vtkNew<vtkSurfaceDeviation> deviation;
  deviation->SetInputData(MakePolyData(Icosphere(4)));
  deviation->SetReferenceData(MakePolyData(Icosphere(2)));
  deviation->SetNumberOfSamples(10000);
  CheckRepeats(c, "vtkSurfaceDeviation", deviation);

  vtkNew<vtkMeshLaplacian> laplacian;
  laplacian->SetInputData(mesh);
  laplacian->PrincipalCurvaturesOn();
  CheckRepeats(c, "vtkMeshLaplacian", laplacian);

  vtkNew<vtkTriangleRadiusRatio> quality;
  quality->SetInputData(mesh);
  CheckRepeats(c, "vtkTriangleRadiusRatio", quality);

  using Optimizer = vtkLaplacianMeshOptimizer;
  CheckOptimizer(c, mesh, Optimizer::OPTIMIZE_TRIANGLES, "OPTIMIZE_TRIANGLES");
  CheckOptimizer(c, mesh, Optimizer::SMOOTH, "SMOOTH");
  CheckOptimizer(c, mesh, Optimizer::OPTIMIZE_WITHIN_DEVIATION, "OPTIMIZE_WITHIN_DEVIATION");
  CheckOptimizer(c, mesh, Optimizer::SMOOTH_GUIDED, "SMOOTH_GUIDED");
  return c.Result();
}
