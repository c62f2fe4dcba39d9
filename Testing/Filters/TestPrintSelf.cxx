// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"

#include "vtkMeshLaplacian.h"
#include "vtkNew.h"
#include "vtkSurfaceDeviation.h"
#include "vtkTriangleRadiusRatio.h"

#include <vector>

namespace
{
void CheckNames(Checks& c, vtkObject* filter, const std::vector<std::string>& names)
{
  std::ostringstream text;
  filter->Print(text);
  for (const std::string& name : names)
  {
    c.Says(
      std::string(filter->GetClassName()) + " prints " + name, text.str(), "\n  " + name + ": ");
  }
}
}

int TestPrintSelf(int, char*[])
{
  Checks c;
  CheckNames(c, vtkNew<vtkSurfaceDeviation>(),
    { "NumberOfSamples", "HausdorffDistance", "RelativeHausdorffDistance", "MeanDistance",
      "RelativeMeanDistance" });
  CheckNames(c, vtkNew<vtkTriangleRadiusRatio>(), { "MeanRadiusRatio", "MinimumRadiusRatio" });
  CheckNames(c, vtkNew<vtkMeshLaplacian>(), { "RobustLaplacian", "PrincipalCurvatures" });
  return c.Result();
}
