// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "ParallelTesting.h"

#include "vtkCellArray.h"
#include "vtkCommand.h"
#include "vtkDataObject.h"
#include "vtkIdTypeArray.h"
#include "vtkLaplacianMeshOptimizer.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <cstdlib>
#include <fstream>
#include <limits>

#include <unistd.h>

using namespace lmo;

namespace
{
using Optimizer = vtkLaplacianMeshOptimizer;

/// Checks that every process has an error with \a text after \a spoil changed the filter or its
/// input in the last process alone, and that the filter recovers.
/// \param mode one that works on pieces, or one that needs the whole
void CheckRefusal(MpiJob& job, Checks& c, int mode, const std::string& what,
  const std::string& text, const std::function<void(Optimizer*, vtkPolyData*)>& spoil)
{
  const TestMesh mesh = Irregular(Icosphere(2), 0.02);
  const auto whole = MakePolyData(mesh);
  const auto take = [&] { return TakePiece(whole, Sectors(mesh), job.Rank(), job.Size()).surface; };
  vtkNew<Optimizer> filter;
  filter->SetMode(mode);
  filter->SetInputData(take());
  filter->Update();

  const auto spoilt = take();
  if (job.Rank() == job.Size() - 1)
  {
    spoil(filter, spoilt);
  }
  filter->SetInputData(spoilt);
  const std::string errors = Update(filter).errors;
  const bool isRight = errors.find(text) != std::string::npos;
  c.Error(what + ": the error in every process says '" + text + "'", job.Largest(!isRight), 0);
  c.Error(what + ": the output is empty", job.Largest(!IsEmpty(filter->GetOutput())), 0);

  vtkNew<Optimizer> again;
  again->SetMode(mode);
  again->SetInputData(take());
  c.Error(what + ": the next execution works", job.Largest(!Update(again).errors.empty()), 0);
}

void CheckOneProcess(MpiJob& job, Checks& c, int mode)
{
  CheckRefusal(job, c, mode, "NaN in one process", "NaN",
    [](Optimizer*, vtkPolyData* input)
    { input->GetPoints()->SetPoint(3, 0, std::numeric_limits<double>::quiet_NaN(), 0); });
  CheckRefusal(job, c, mode, "a point that does not exist in one process", "Repair",
    [](Optimizer*, vtkPolyData* input) {
      input->GetPolys()->InsertNextCell({ 0, 1, 5000 });
    });
  CheckRefusal(job, c, mode, "a property out of range in one process", "ScaleFactor",
    [](Optimizer* filter, vtkPolyData*) { filter->SetScaleFactor(-1); });
}

void CheckMissingArray(MpiJob& job, Checks& c, int mode)
{
  const TestMesh mesh = Irregular(Icosphere(2), 0.02);
  const auto piece = TakePiece(MakePolyData(mesh), Sectors(mesh), job.Rank(), job.Size()).surface;
  if (job.Rank() < job.Size() - 1)
  {
    AddPointArray(piece, "Fixed", Eigen::VectorXd::Zero(piece->GetNumberOfPoints()));
  }
  vtkNew<Optimizer> filter;
  filter->SetMode(mode);
  filter->SetInputData(piece);
  filter->SetInputArrayToProcess(
    Optimizer::FIXED_POINT_ARRAY, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Fixed");
  const bool isRefused =
    Update(filter).errors.find("no numeric point array 'Fixed'") != std::string::npos;
  c.Error("an array that one process lacks is an error in all", job.Largest(!isRefused), 0);
}

void CheckGlobalIds(MpiJob& job, Checks& c, int mode)
{
  const TestMesh mesh = Irregular(Icosphere(2), 0.02);
  PieceOfMesh piece = TakePiece(MakePolyData(mesh), Sectors(mesh), job.Rank(), job.Size());
  AddGlobalIds(piece);
  auto* ids = vtkIdTypeArray::SafeDownCast(piece.surface->GetPointData()->GetGlobalIds());
  if (job.Rank() == 0)
  {
    ids->SetValue(0, ids->GetValue(ids->GetNumberOfTuples() - 1));
  }
  vtkNew<Optimizer> filter;
  filter->SetMode(mode);
  filter->SetInputData(piece.surface);
  const bool isRefused = Update(filter).errors.find("global ids") != std::string::npos;
  c.Error("equal global ids at different places are an error", job.Largest(!isRefused), 0);
}

void CheckCancellation(MpiJob& job, Checks& c)
{
  const TestMesh mesh = Irregular(Icosphere(3), 0.02);
  const auto piece = TakePiece(MakePolyData(mesh), Sectors(mesh), job.Rank(), job.Size()).surface;
  vtkNew<Optimizer> filter;
  filter->SetMode(Optimizer::OPTIMIZE_TRIANGLES);
  filter->SetInputData(piece);
  if (job.Rank() == job.Size() - 1)
  {
    filter->AddObserver(vtkCommand::ProgressEvent, filter.Get(), &Optimizer::AbortExecuteOn);
  }
  const Messages messages = Update(filter);
  c.Error("one process stops all, without an error", job.Largest(!messages.errors.empty()), 0);
  c.Error("then no process has a result", job.Largest(!IsEmpty(filter->GetOutput())), 0);
}

/// Of this process, in bytes.
double ResidentMemory()
{
  std::ifstream file("/proc/self/statm");
  double total = 0;
  double resident = 0;
  file >> total >> resident;
  return resident * double(sysconf(_SC_PAGESIZE));
}

void CheckMemory(MpiJob& job, Checks& c)
{
  const TestMesh mesh = Irregular(Icosphere(5), 0.002);
  const auto piece = TakePiece(MakePolyData(mesh), Sectors(mesh), job.Rank(), job.Size()).surface;
  const auto run = [&](int times)
  {
    for (int k = 0; k < times; ++k)
    {
      Optimized(piece, [&](Optimizer* filter)
        { filter->SetSolverType(k % 2 ? Optimizer::DIRECT : Optimizer::AUTOMATIC); });
    }
    return ResidentMemory();
  };
  const double before = run(10);
  const double growth = job.Largest((run(30) - before) / before);
  c.Error("repeated executions take no more memory", growth, 0.1);
}
}

int TestDistributedErrors(int argc, char* argv[])
{
  MpiJob job(argc, argv);
  Checks c;
  CheckOneProcess(job, c, Optimizer::OPTIMIZE_TRIANGLES);
  CheckOneProcess(job, c, Optimizer::OPTIMIZE_WITHIN_DEVIATION);
  CheckMissingArray(job, c, Optimizer::OPTIMIZE_TRIANGLES);
  CheckMissingArray(job, c, Optimizer::OPTIMIZE_WITHIN_DEVIATION);
  CheckCancellation(job, c);
  if (job.Size() > 1)
  {
    CheckGlobalIds(job, c, Optimizer::OPTIMIZE_TRIANGLES);
    CheckGlobalIds(job, c, Optimizer::OPTIMIZE_WITHIN_DEVIATION);
    CheckMemory(job, c);
  }
  return c.Result();
}
