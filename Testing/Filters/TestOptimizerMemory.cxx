// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "FilterTesting.h"

#include "vtkLaplacianMeshOptimizer.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <vtksys/SystemInformation.hxx>

#include <algorithm>

using namespace lmo;

namespace
{
using Optimizer = vtkLaplacianMeshOptimizer;

/// Other parameters in each execution; every tenth has a new mesh.
void Execute(Optimizer* filter, vtkPolyData* input, int first, int count)
{
  for (int k = first; k < first + count; ++k)
  {
    filter->SetMode(k % 2);
    filter->SetLaplacianType(k % 3);
    filter->SetRobustLaplacian(k / 3 % 2);
    filter->SetBoundaryCondition(k / 6 % 3);
    filter->SetSolverType(k % 7 == 0 ? Optimizer::DIRECT : Optimizer::AUTOMATIC);
    filter->SetScaleFactor(0.1 + 0.01 * (k % 13));
    if (k % 10 == 0)
    {
      input->GetPoints()->Modified();
      input->Modified();
    }
    filter->Update();
  }
}

/// After an execution with the same parameters, as they decide what is kept.
double MegabytesInUse(Optimizer* filter, vtkPolyData* input)
{
  Execute(filter, input, 0, 1);
  return double(vtksys::SystemInformation().GetProcMemoryUsed()) / 1024;
}
}

int TestOptimizerMemory(int, char*[])
{
  Checks c;
  const auto input = MakePolyData(Irregular(Icosphere(5), 0.002));
  vtkNew<Optimizer> filter;
  filter->SetInputData(input);
  Execute(filter, input, 0, 100);
  const double first = MegabytesInUse(filter, input);
  Execute(filter, input, 100, 150);
  const double second = MegabytesInUse(filter, input);
  Execute(filter, input, 250, 150);
  const double third = MegabytesInUse(filter, input);
  c.True("the memory in use is known", first > 0);
  // A leak of one array of displacements in each execution would make 37 MB twice; what the heap
  // happens to hold goes up and down.
  c.Error("150 executions leave the memory in use level, in MB",
    std::min(second - first, third - second), 10);
  return c.Result();
}
