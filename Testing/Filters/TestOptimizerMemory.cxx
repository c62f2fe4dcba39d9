// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "FilterTesting.h"

#include "vtkLaplacianMeshOptimizer.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#ifdef HAS_SANITIZER
#include <sanitizer/allocator_interface.h>
#elif defined(__GLIBC__)
#include <malloc.h>
#else
#include <vtksys/SystemInformation.hxx>
#endif

using namespace lmo;

namespace
{
using Optimizer = vtkLaplacianMeshOptimizer;

/// Other parameters in each execution; every tenth has a new mesh.
void Execute(Optimizer* filter, vtkPolyData* input, int first, int count)
{
  constexpr int modes[] = { Optimizer::OPTIMIZE_TRIANGLES, Optimizer::SMOOTH,
    Optimizer::OPTIMIZE_WITHIN_DEVIATION, Optimizer::SMOOTH_GUIDED };
  for (int k = first; k < first + count; ++k)
  {
    filter->SetMode(modes[k % 4]);
    filter->SetLaplacianType(k % 3);
    filter->SetRobustLaplacian(k / 3 % 2);
    filter->SetBoundaryCondition(k / 6 % 3);
    filter->SetSolverType(k % 7 == 0 ? Optimizer::DIRECT : Optimizer::AUTOMATIC);
    filter->SetScaleFactor(0.1 + 0.01 * (k % 13));
    if (k % 10 == 0)
    {
      Vector3 point;
      input->GetPoint(0, point.data());
      input->GetPoints()->SetPoint(0, Vector3((1 + 1e-9) * point).data());
      input->Modified();
    }
    filter->Update();
  }
}

/// What the program has allocated and not freed; the process holds more.
double BytesInUse()
{
#ifdef HAS_SANITIZER
  return static_cast<double>(__sanitizer_get_current_allocated_bytes());
#elif defined(__GLIBC__)
  const struct mallinfo2 info = mallinfo2();
  return static_cast<double>(info.uordblks + info.hblkhd);
#else
  return 1024.0 * static_cast<double>(vtksys::SystemInformation().GetProcMemoryUsed());
#endif
}

/// After an execution with the same parameters, as they decide what is kept.
double MegabytesInUse(Optimizer* filter, vtkPolyData* input)
{
  Execute(filter, input, 0, 1);
  return BytesInUse() / 1e6;
}
}

int TestOptimizerMemory(int, char*[])
{
  Checks c;
  const auto input = MakePolyData(Irregular(Icosphere(Thinning > 1 ? 3 : 4), 0.002));
  vtkNew<Optimizer> filter;
  filter->SetInputData(input);
  Execute(filter, input, 0, 100);
  const double first = MegabytesInUse(filter, input);
  Execute(filter, input, 100, 150);
  const double second = MegabytesInUse(filter, input);
  c.Greater("the memory in use is known", first, 0);
  // A leak of one number for each point in each execution would make 3 MB.
  c.Error("150 executions leave the memory in use level, in MB", second - first, 0.1);
  return c.Result();
}
