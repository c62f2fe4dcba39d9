// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "ParallelTesting.h"

#include "vtkCellArray.h"
#include "vtkCommand.h"
#include "vtkDataObject.h"
#include "vtkIdTypeArray.h"
#include "vtkLaplacianMeshOptimizer.h"
#include "vtkMultiBlockDataSet.h"
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
void CheckRefusal(MpiJob& job, Checks& c, const std::string& what, const std::string& text,
  const std::function<void(Optimizer*, vtkPolyData*)>& spoil)
{
  const TestMesh mesh = Irregular(Icosphere(2), 0.02);
  const auto whole = MakePolyData(mesh);
  const auto take = [&] { return TakePiece(whole, Sectors(mesh), job.Rank(), job.Size()).surface; };
  vtkNew<Optimizer> filter;
  filter->SetMode(Optimizer::OPTIMIZE_TRIANGLES);
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
  again->SetMode(Optimizer::OPTIMIZE_TRIANGLES);
  again->SetInputData(take());
  c.Error(what + ": the next execution works", job.Largest(!Update(again).errors.empty()), 0);
}

void CheckOneProcess(MpiJob& job, Checks& c)
{
  CheckRefusal(job, c, "NaN in one process", "NaN",
    [](Optimizer*, vtkPolyData* input)
    { input->GetPoints()->SetPoint(3, 0, std::numeric_limits<double>::quiet_NaN(), 0); });
  CheckRefusal(job, c, "a point that does not exist in one process", "Repair",
    [](Optimizer*, vtkPolyData* input) {
      input->GetPolys()->InsertNextCell({ 0, 1, 5000 });
    });
  CheckRefusal(job, c, "a property out of range in one process", "ScaleFactor",
    [](Optimizer* filter, vtkPolyData*) { filter->SetScaleFactor(-1); });
  CheckRefusal(job, c, "an array that is missing in one process", "no numeric point array",
    [](Optimizer* filter, vtkPolyData*)
    {
      filter->SetInputArrayToProcess(
        Optimizer::FIXED_POINT_ARRAY, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Missing");
    });
}

void CheckWhatNeedsOneProcess(MpiJob& job, Checks& c)
{
  const TestMesh mesh = Irregular(Icosphere(1), 0.02);
  const auto piece = TakePiece(MakePolyData(mesh), Sectors(mesh), job.Rank(), job.Size()).surface;
  const std::pair<const char*, SetUp> choices[] = {
    { "staying within a deviation, for which the error names another mode,",
      [](Optimizer* filter) { filter->SetMode(Optimizer::OPTIMIZE_WITHIN_DEVIATION); } },
    { "guided smoothing", [](Optimizer* filter) { filter->SetMode(Optimizer::SMOOTH_GUIDED); } },
    { "the robust Laplacian", [](Optimizer* filter) { filter->SetRobustLaplacian(true); } },
    { "feature constraints", [](Optimizer* filter) { filter->SetFeatureConstraints(true); } },
    { "preserving the volume", [](Optimizer* filter) { filter->SetPreserveVolume(true); } },
  };
  for (const auto& [name, choose] : choices)
  {
    vtkNew<Optimizer> filter;
    filter->SetMode(Optimizer::OPTIMIZE_TRIANGLES);
    filter->SetInputData(piece);
    choose(filter);
    const std::string errors = Update(filter).errors;
    const bool isWithin = filter->GetMode() == Optimizer::OPTIMIZE_WITHIN_DEVIATION;
    const bool isRefused = errors.find("one process") != std::string::npos &&
                           (!isWithin || errors.find("OPTIMIZE_TRIANGLES") != std::string::npos);
    c.Error(std::string(name) + " is an error in every process", job.Largest(!isRefused), 0);
  }
}

void CheckGlobalIds(MpiJob& job, Checks& c)
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
  filter->SetMode(Optimizer::OPTIMIZE_TRIANGLES);
  filter->SetInputData(piece.surface);
  const bool isRefused = Update(filter).errors.find("global ids") != std::string::npos;
  c.Error("equal global ids at different places are an error", job.Largest(!isRefused), 0);
}

/// The first process has more blocks than the others.
void CheckBlocks(MpiJob& job, Checks& c)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetNumberOfBlocks(2);
  for (unsigned int k = 0; k < 2; ++k)
  {
    blocks->SetBlock(k, job.Rank() == 0 ? MakePolyData(Icosphere(1)).Get() : nullptr);
  }
  vtkNew<Optimizer> filter;
  filter->SetMode(Optimizer::OPTIMIZE_TRIANGLES);
  filter->SetInputDataObject(blocks);
  const bool isRefused = Update(filter).errors.find("composite") != std::string::npos;
  c.Error("blocks are an error in every process", job.Largest(!isRefused), 0);
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
  CheckOneProcess(job, c);
  CheckCancellation(job, c);
  if (job.Size() > 1)
  {
    CheckWhatNeedsOneProcess(job, c);
    CheckGlobalIds(job, c);
    CheckBlocks(job, c);
    CheckMemory(job, c);
  }
  return c.Result();
}
