// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause

// Partitions and blocks on several processes.
#include "Checks.h"
#include "ParallelTesting.h"

#include "vtkDoubleArray.h"
#include "vtkLaplacianMeshOptimizer.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

using namespace lmo;

namespace
{
using Optimizer = vtkLaplacianMeshOptimizer;
using Change = std::function<void(PieceOfMesh&)>;

struct Case
{
  std::string name;
  SetUp setUp;
};

/// A mode of each kind: one that works on pieces, and one that needs the whole.
std::vector<Case> Cases()
{
  const auto precise = [](Optimizer* filter)
  {
    filter->InterpolatePointDataOff();
    filter->SetTolerance(1e-12);
    filter->SetPositionWeighting(Optimizer::LINEAR);
    filter->SetBoundaryCondition(Optimizer::SLIDING);
  };
  return { { "on pieces", precise }, { "gathered", [=](Optimizer* filter)
                                       {
                                         precise(filter);
                                         filter->FeatureConstraintsOn();
                                       } } };
}

/// A part of a surface in a partition of this process.
struct Partition
{
  unsigned int index;
  PieceOfMesh piece;
};

/// How many partitions a process has.
using Count = std::function<int(int rank)>;

std::vector<Partition> TakePartitions(
  MpiJob& job, vtkPolyData* whole, const Cut& cut, const Count& count, const Change& change)
{
  int first = 0;
  int all = 0;
  for (int rank = 0; rank < job.Size(); ++rank)
  {
    first += rank < job.Rank() ? count(rank) : 0;
    all += count(rank);
  }
  std::vector<Partition> partitions;
  for (int k = 0; k < count(job.Rank()); ++k)
  {
    PieceOfMesh piece = TakePiece(whole, cut, first + k, all);
    change(piece);
    partitions.push_back({ static_cast<unsigned int>(2 * k + 1), piece });
  }
  return partitions;
}

vtkSmartPointer<vtkPartitionedDataSet> DataOf(const std::vector<Partition>& partitions)
{
  auto data = vtkSmartPointer<vtkPartitionedDataSet>::New();
  data->SetNumberOfPartitions(static_cast<unsigned int>(2 * partitions.size() + 1));
  for (const Partition& partition : partitions)
  {
    data->SetPartition(partition.index, partition.piece.surface);
  }
  return data;
}

vtkSmartPointer<vtkDataObject> OptimizedData(vtkDataObject* input, const SetUp& setUp)
{
  vtkNew<Optimizer> filter;
  filter->SetMode(Optimizer::OPTIMIZE_TRIANGLES);
  filter->SetInputDataObject(input);
  setUp(filter);
  filter->Update();
  return filter->GetOutputDataObject(0);
}

double Difference(
  const std::vector<Partition>& partitions, vtkPartitionedDataSet* output, vtkPolyData* whole)
{
  double difference = output ? 0 : HUGE_VAL;
  for (const Partition& partition : partitions)
  {
    auto* part = vtkPolyData::SafeDownCast(output->GetPartition(partition.index));
    difference =
      Larger(difference, part ? DifferenceFromWhole(partition.piece, part, whole) : HUGE_VAL);
  }
  return difference;
}

void CheckPartitions(MpiJob& job, Checks& c)
{
  const TestMesh mesh = Irregular(HalfSphere(3), 0.02);
  const auto whole = MakePolyData(mesh);
  const std::pair<std::string, Count> counts[] = {
    { "two partitions in each process", [](int) { return 2; } },
    { "a process has none", [&](int rank) { return rank == 0 && job.Size() > 1 ? 0 : 2; } },
    { "one in the first process, two in the second, and so on", [](int rank) { return rank + 1; } },
  };
  const std::pair<std::string, Change> changes[] = {
    { "", [](PieceOfMesh&) {} },
    { " with ghost cells", [&](PieceOfMesh& piece) { AddGhostCells(piece, whole); } },
    { " with global ids", AddGlobalIds },
  };
  for (const Case& each : Cases())
  {
    const auto expected = OptimizedAlone(whole.Get(), each.setUp);
    for (const auto& [name, count] : counts)
    {
      for (const auto& [suffix, change] : changes)
      {
        const auto partitions = TakePartitions(job, whole, Scattered(), count, change);
        const auto output = OptimizedData(DataOf(partitions), each.setUp);
        c.Error(each.name + ", " + name + suffix + ": they are one surface",
          job.Largest(
            Difference(partitions, vtkPartitionedDataSet::SafeDownCast(output), expected)),
          1e-9);
      }
    }
  }
}

void CheckCollection(MpiJob& job, Checks& c)
{
  const TestMesh first = Irregular(HalfSphere(3), 0.02);
  const TestMesh second = Irregular(Icosphere(2), 0.02);
  const auto two = [](int) { return 2; };
  const auto none = [](PieceOfMesh&) {};
  const auto wholes = { MakePolyData(first), MakePolyData(second) };
  std::vector<std::vector<Partition>> sets;
  vtkNew<vtkPartitionedDataSetCollection> collection;
  collection->SetNumberOfPartitionedDataSets(3);
  for (const auto& whole : wholes)
  {
    sets.push_back(TakePartitions(job, whole, Scattered(), two, none));
    collection->SetPartitionedDataSet(
      static_cast<unsigned int>(2 * sets.size() - 2), DataOf(sets.back()));
  }
  for (const Case& each : Cases())
  {
    const auto output = OptimizedData(collection, each.setUp);
    auto* outputs = vtkPartitionedDataSetCollection::SafeDownCast(output);
    for (std::size_t k = 0; k < sets.size(); ++k)
    {
      const auto expected = OptimizedAlone((wholes.begin() + k)->Get(), each.setUp);
      c.Error(each.name + ": a set of a collection is a surface of its own",
        job.Largest(Difference(
          sets[k], outputs->GetPartitionedDataSet(static_cast<unsigned int>(2 * k)), expected)),
        1e-9);
    }
  }
}

void CheckBlocks(MpiJob& job, Checks& c)
{
  const TestMesh mesh = Irregular(HalfSphere(3), 0.02);
  const auto whole = MakePolyData(mesh);
  const auto piece = TakePiece(whole, Sectors(mesh), job.Rank(), job.Size());
  const auto alone = MakePolyData(Irregular(Icosphere(2), 0.02));
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetNumberOfBlocks(4);
  blocks->SetBlock(1, piece.surface);
  if (job.Rank() == job.Size() - 1)
  {
    vtkNew<vtkMultiBlockDataSet> inner; // which other processes do not have
    inner->SetBlock(0, alone);
    blocks->SetBlock(0, inner);
    blocks->SetBlock(3, alone);
  }
  for (const Case& each : Cases())
  {
    const auto output = OptimizedData(blocks, each.setUp);
    auto* outputs = vtkMultiBlockDataSet::SafeDownCast(output);
    c.Error(each.name + ": blocks of the same index are pieces of one surface",
      job.Largest(DifferenceFromWhole(piece, vtkPolyData::SafeDownCast(outputs->GetBlock(1)),
        OptimizedAlone(whole.Get(), each.setUp))),
      1e-9);
    double difference = 0;
    if (job.Rank() == job.Size() - 1)
    {
      const Points expected = PointsOf(OptimizedAlone(alone.Get(), each.setUp));
      auto* inner = vtkMultiBlockDataSet::SafeDownCast(outputs->GetBlock(0));
      for (vtkDataObject* block : { outputs->GetBlock(3), inner->GetBlock(0) })
      {
        difference = Larger(difference,
          (PointsOf(vtkPolyData::SafeDownCast(block)) - expected).cwiseAbs().maxCoeff());
      }
    }
    c.Error(each.name + ": blocks that one process has are surfaces of their own",
      job.Largest(difference), 1e-9);
    c.Error(each.name + ": blocks that a process has not stay missing",
      job.Largest(outputs->GetBlock(2) != nullptr || outputs->GetNumberOfBlocks() != 4), 0);
  }
}

void CheckError(MpiJob& job, Checks& c)
{
  const TestMesh mesh = Irregular(Icosphere(2), 0.02);
  const auto whole = MakePolyData(mesh);
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (unsigned int k = 0; k < 2; ++k)
  {
    blocks->SetBlock(k, TakePiece(whole, Sectors(mesh), job.Rank(), job.Size()).surface);
  }
  if (job.Rank() == job.Size() - 1)
  {
    vtkPolyData::SafeDownCast(blocks->GetBlock(1))->GetPoints()->SetPoint(2, NAN, 0, 0);
  }
  for (const Case& each : Cases())
  {
    vtkNew<Optimizer> filter;
    filter->SetMode(Optimizer::OPTIMIZE_TRIANGLES);
    each.setUp(filter);
    filter->SetInputDataObject(blocks);
    const std::string errors = Update(filter).errors;
    const bool isRight =
      errors.find("Block 1") != std::string::npos && errors.find("NaN") != std::string::npos;
    c.Error(
      each.name + ": an error in a block of one process is one in all", job.Largest(!isRight), 0);
  }
}
}

int TestDistributedPartitions(int argc, char* argv[])
{
  MpiJob job(argc, argv);
  Checks c;
  CheckPartitions(job, c);
  CheckCollection(job, c);
  CheckBlocks(job, c);
  CheckError(job, c);
  return c.Result();
}
