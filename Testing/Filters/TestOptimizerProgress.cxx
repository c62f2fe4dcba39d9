// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "FilterTesting.h"

#include "vtkCallbackCommand.h"
#include "vtkLaplacianMeshOptimizer.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <set>

using namespace lmo;

namespace
{
using Optimizer = vtkLaplacianMeshOptimizer;

/// Remembers the progress and aborts at the given one.
class ProgressObserver : public vtkCommand
{
public:
  static ProgressObserver* New() { return new ProgressObserver; }

  void Execute(vtkObject* caller, unsigned long, void* callData) override
  {
    const double progress = *static_cast<double*>(callData);
    this->Progress.push_back(progress);
    if (progress >= this->AbortAt)
    {
      static_cast<vtkAlgorithm*>(caller)->AbortExecuteOn();
    }
  }

  std::vector<double> Progress;
  double AbortAt = 2;
};

/// A problem that takes many iterations.
void SetUp(Optimizer* filter)
{
  filter->SetInputData(MakePolyData(Irregular(Icosphere(3), 0.02)));
  filter->SetMode(Optimizer::SMOOTH);
  filter->SetScaleFactor(0.01);
  filter->SetTolerance(1e-10);
}

void CheckProgress(Checks& c)
{
  vtkNew<Optimizer> filter;
  SetUp(filter);
  vtkNew<ProgressObserver> observer;
  filter->AddObserver(vtkCommand::ProgressEvent, observer);
  filter->Update();
  const std::vector<double>& progress = observer->Progress;
  c.True("progress never falls", std::is_sorted(progress.begin(), progress.end()));
  c.True("progress is between 0 and 1",
    !progress.empty() && progress.front() >= 0 && progress.back() <= 1);
  c.Greater("progress is shown in many steps",
    std::set<double>(progress.begin(), progress.end()).size(), 10);
  c.True("progress gets near the end before it is there",
    std::any_of(progress.begin(), progress.end(), [](double p) { return p > 0.8 && p < 1; }));

  observer->Progress.clear();
  filter->Update();
  c.True("a second Update() has nothing to do", observer->Progress.empty());
}

void CheckAbort(Checks& c)
{
  vtkNew<Optimizer> undisturbed;
  SetUp(undisturbed);
  undisturbed->Update();
  for (const double abortAt : { 0.01, 0.3 })
  {
    vtkNew<Optimizer> filter;
    SetUp(filter);
    vtkNew<ProgressObserver> observer;
    observer->AbortAt = abortAt;
    const unsigned long tag = filter->AddObserver(vtkCommand::ProgressEvent, observer);
    c.Equal("an abort is no error", Update(filter).errors, "");
    c.True("an abort leaves the output empty", IsEmpty(filter->GetOutput()));
    c.Equal("an abort stops at once",
      std::count_if(observer->Progress.begin(), observer->Progress.end(),
        [&](double p) { return p >= abortAt && p < 1; }),
      1);

    filter->RemoveObserver(tag);
    filter->AbortExecuteOff();
    filter->Modified();
    filter->Update();
    c.True("the filter works again after an abort",
      filter->GetOutput()->GetNumberOfPoints() == 642 &&
        AreEqual(filter->GetOutput(), undisturbed->GetOutput()));
  }
}

void CheckAbortWithinDeviation(Checks& c)
{
  vtkNew<Optimizer> filter;
  SetUp(filter);
  filter->SetMode(Optimizer::OPTIMIZE_WITHIN_DEVIATION);
  filter->SetMaximumDeviation(0.01);
  vtkNew<ProgressObserver> observer;
  observer->AbortAt = 0.45; // within a solve
  filter->AddObserver(vtkCommand::ProgressEvent, observer);
  c.Equal("an abort within a deviation is no error", Update(filter).errors, "");
  c.True("an abort within a deviation leaves the mesh so far",
    filter->GetOutput()->GetNumberOfPoints() == 642 && filter->GetPasses() > 0 &&
      filter->GetPasses() < filter->GetNumberOfPasses());
  c.Error("the mesh so far has its bound", filter->GetRelativeHausdorffBound(),
    filter->GetMaximumDeviation());
  c.Greater("the mesh so far is better than the input", filter->GetMeanRadiusRatio(),
    filter->GetInputMeanRadiusRatio());
}

void CheckTolerance(Checks& c)
{
  vtkNew<Optimizer> filter;
  SetUp(filter);
  filter->PreserveVolumeOn(); // a loss of volume is another warning
  filter->SetMaximumNumberOfIterations(3);
  filter->SetSolverType(Optimizer::ITERATIVE);
  const Messages messages = Update(filter);
  std::ostringstream residual;
  residual << filter->GetRelativeResidual();
  c.Equal("too few iterations are no error", messages.errors, "");
  for (const std::string& text : { residual.str(), std::string("MaximumNumberOfIterations") })
  {
    c.Says("too few iterations give a warning with " + text, messages.warnings, text);
  }
  c.True("the best result so far is kept",
    filter->GetIterations() == 3 && filter->GetOutput()->GetNumberOfPoints() == 642);

  filter->SetTolerance(1e-9);
  filter->SetMaximumNumberOfIterations(1);
  filter->SetSolverType(Optimizer::AUTOMATIC);
  c.Equal("the automatic choice gives no warning", Update(filter).warnings, "");
  c.Error(
    "the automatic choice falls back to the direct solver", filter->GetRelativeResidual(), 1e-9);
}
}

int TestOptimizerProgress(int argc, char* argv[])
{
  Groups groups(argc, argv);
  groups.Run("Progress", CheckProgress);
  groups.Run("Abort", CheckAbort);
  groups.Run("AbortWithinDeviation", CheckAbortWithinDeviation);
  groups.Run("Tolerance", CheckTolerance);
  return groups.Result();
}
