// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause

// Which points and cells of partitions are the same.
#include "Checks.h"
#include "FilterTesting.h"
#include "MeshMeasures.h"
#include "SurfacePartitions.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkLaplacianMeshOptimizer.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiPieceDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>

using namespace lmo;

namespace
{
using Optimizer = vtkLaplacianMeshOptimizer;

/// Adds to partition 0 the cells of partition 1, marked as duplicates.
void AddGhosts(PartitionsOfMesh& mesh)
{
  vtkPolyData* first = Part(mesh.data, 0);
  vtkPolyData* second = Part(mesh.data, 1);
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfTuples(first->GetNumberOfCells());
  ghosts->Fill(0);
  const vtkIdType offset = first->GetNumberOfPoints();
  for (vtkIdType i = 0; i < second->GetNumberOfPoints(); ++i)
  {
    first->GetPoints()->InsertNextPoint(second->GetPoint(i));
    mesh.points[0].push_back(mesh.points[1][i]);
  }
  vtkNew<vtkIdList> ids;
  for (vtkIdType t = 0; t < second->GetNumberOfPolys(); ++t)
  {
    second->GetPolys()->GetCellAtId(t, ids);
    first->GetPolys()->InsertNextCell(
      { offset + ids->GetId(0), offset + ids->GetId(1), offset + ids->GetId(2) });
    ghosts->InsertNextValue(vtkDataSetAttributes::DUPLICATECELL);
  }
  first->GetCellData()->AddArray(ghosts);
}

void CheckGhosts(Checks& c)
{
  const auto whole = MakePolyData(Irregular(Icosphere(2), 0.02));
  const PartitionsOfMesh without = CutIntoPartitions(whole, 3);
  PartitionsOfMesh mesh = CutIntoPartitions(whole, 3);
  const vtkIdType real = Part(mesh.data, 0)->GetNumberOfCells();
  AddGhosts(mesh);
  const auto output = OptimizedPartitions(mesh.data);
  c.Error("ghost cells do not count",
    DistanceToWhole(without, OptimizedPartitions(without.data), Optimized(whole, Precise)), 1e-9);
  c.Error("their points move with the points whose copies they are",
    DistanceToWhole(mesh, output, Optimized(whole, Precise)), 1e-9);
  c.Equal("copies that ghost cells use have the same bits", DistanceOfCopies(mesh, output), 0.0);
  c.True("ghost cells stay ghost cells",
    Contains(Part(output, 0)->GetCellData(), Part(mesh.data, 0)->GetCellData()));
  const Eigen::MatrixXd ratios = CellValues(Part(output, 0), "RadiusRatio");
  const Eigen::MatrixXd originals = CellValues(Part(output, 1), "RadiusRatio");
  c.Equal("a ghost cell has the radius ratio of the cell whose copy it is",
    (ratios.bottomRows(ratios.rows() - real) - originals).cwiseAbs().maxCoeff(), 0.0);
}

void CheckWelding(Checks& c)
{
  const TestMesh mesh = Irregular(Grid(8, 0.2), 0.02);
  const auto whole = MakePolyData(mesh);
  const PartitionsOfMesh partitions = CutIntoPartitions(whole, 2);
  const auto apart = [](Optimizer* filter)
  {
    Precise(filter);
    filter->WeldCoincidentPointsOff();
  };
  c.Error("partitions are joined without WeldCoincidentPoints",
    DistanceToWhole(
      partitions, OptimizedPartitions(partitions.data, apart), Optimized(whole, Precise)),
    1e-9);
  vtkNew<vtkPartitionedDataSet> soup;
  soup->SetPartition(0, MakePolyData(Soup(mesh)));
  const auto output = OptimizedPartitions(soup, apart);
  c.Equal("but points of one partition are not",
    MaximumDistance(PointsOf(Part(output, 0)), PointsOf(Part(soup, 0))), 0.0);
}

/// Weights that no other surface has an influence on.
void Constant(Optimizer* filter)
{
  Precise(filter);
  filter->SetPositionWeighting(Optimizer::CONSTANT);
}

/// Two closed surfaces that have a point in common, each in a partition.
void CheckTouch(Checks& c)
{
  const TestMesh first = Irregular(Icosphere(2), 0.02);
  const TestMesh second = Transformed(first, -1, 2 * first.V.row(0));
  vtkNew<vtkPartitionedDataSet> input;
  input->SetPartition(0, MakePolyData(first));
  input->SetPartition(1, MakePolyData(second));
  c.Equal("two surfaces touch", MaximumDistance(first.V.topRows(1), second.V.topRows(1)), 0.0);
  const auto output = OptimizedPartitions(input, Constant);
  c.Error("closed surfaces that touch move as if they were alone",
    MaximumDistance(PointsOf(Part(output, 0)), PointsOf(Optimized(MakePolyData(first), Constant))),
    1e-9);
}

void AddIds(vtkPolyData* part, const std::vector<Index>& points, vtkIdType shift)
{
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("GlobalIds");
  for (const Index i : points)
  {
    ids->InsertNextValue(7 * i + shift);
  }
  part->GetPointData()->SetGlobalIds(ids);
}

void CheckGlobalIds(Checks& c)
{
  const auto whole = MakePolyData(Irregular(Icosphere(2), 0.02));
  const auto cut = [&](vtkIdType shift)
  {
    PartitionsOfMesh mesh = CutIntoPartitions(whole, 2);
    AddIds(Part(mesh.data, 0), mesh.points[0], 3);
    AddIds(Part(mesh.data, 1), mesh.points[1], shift);
    return mesh;
  };
  const auto notWelded = [](Optimizer* filter)
  {
    Constant(filter);
    filter->WeldCoincidentPointsOff();
  };
  const PartitionsOfMesh same = cut(3);
  c.Error("points with the same global id are one",
    DistanceToWhole(same, OptimizedPartitions(same.data, notWelded), Optimized(whole, Constant)),
    1e-9);
  const PartitionsOfMesh different = cut(10000001);
  const Points alone = PointsOf(Optimized(Part(different.data, 0), notWelded));
  c.Error("points with different global ids are not",
    MaximumDistance(PointsOf(Part(OptimizedPartitions(different.data, notWelded), 0)), alone),
    1e-9);
  const PartitionsOfMesh apart = cut(10);
  vtkNew<Optimizer> filter;
  filter->SetInputDataObject(apart.data);
  c.Says("the same global id at different places is an error", Update(filter).errors, "global id");
}

void CheckBlocks(Checks& c)
{
  const auto whole = MakePolyData(Irregular(Icosphere(2), 0.02));
  const PartitionsOfMesh mesh = CutIntoPartitions(whole, 2);
  vtkNew<vtkPartitionedDataSetCollection> sets;
  sets->SetPartitionedDataSet(0, mesh.data);
  sets->SetPartition(1, 0, Part(mesh.data, 0));
  sets->SetPartition(2, 0, Part(mesh.data, 1));
  vtkNew<Optimizer> filter;
  Precise(filter);
  filter->SetInputDataObject(sets);
  filter->Update();
  auto* output = vtkPartitionedDataSetCollection::SafeDownCast(filter->GetOutputDataObject(0));
  c.Error("partitions of one set are one surface",
    DistanceToWhole(mesh, output->GetPartitionedDataSet(0), Optimized(whole, Precise)), 1e-9);
  c.Equal("different sets are different surfaces",
    MaximumDistance(PointsOf(vtkPolyData::SafeDownCast(output->GetPartition(1, 0))),
      PointsOf(Optimized(Part(mesh.data, 0), Precise))),
    0.0);
  vtkNew<vtkMultiBlockDataSet> blocks;
  vtkNew<vtkMultiPieceDataSet> pieces;
  pieces->SetPiece(0, Part(mesh.data, 0));
  pieces->SetPiece(1, Part(mesh.data, 1));
  blocks->SetBlock(0, pieces);
  blocks->SetBlock(1, Part(mesh.data, 0));
  filter->SetInputDataObject(blocks);
  filter->Update();
  auto* outputBlocks = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  c.Error("pieces in a block are one surface",
    DistanceToWhole(mesh, vtkPartitionedDataSet::SafeDownCast(outputBlocks->GetBlock(0)),
      Optimized(whole, Precise)),
    1e-9);
  filter->SetInputDataObject(whole);
  filter->Update();
  c.True("after that the output of a surface is a surface", filter->GetOutput() != nullptr);
}

void CheckSelection(Checks& c)
{
  const auto whole = MakePolyData(Irregular(Icosphere(2), 0.1));
  const PartitionsOfMesh mesh = CutIntoPartitions(whole, 4);
  vtkIdType point = 0; // the same id is another point in the first partition
  while (mesh.points[0][point] == mesh.points[1][point])
  {
    ++point;
  }
  const Index selected = mesh.points[1][point];
  const auto node = SelectionNode(vtkSelectionNode::POINT, { point });
  node->GetProperties()->Set(vtkSelectionNode::COMPOSITE_INDEX(), 2); // the set is 0
  const auto selection = Selection({ node });
  const auto output = OptimizedPartitions(mesh.data,
    [&](Optimizer* filter)
    {
      Precise(filter);
      filter->SetSelectionData(selection);
      filter->SetSelectionUse(Optimizer::ONLY_SELECTED_POINTS_MOVE);
    });
  bool areOthersStill = true;
  double least = HUGE_VAL;
  for (unsigned int k = 0; k < 4; ++k)
  {
    const Points shifts = PointsOf(Part(output, k)) - PointsOf(Part(mesh.data, k));
    for (std::size_t i = 0; i < mesh.points[k].size(); ++i)
    {
      const double shift = shifts.row(static_cast<Eigen::Index>(i)).norm();
      const bool isSelected = mesh.points[k][i] == selected;
      least = isSelected ? std::min(least, shift) : least;
      areOthersStill = areOthersStill && (isSelected || shift == 0);
    }
  }
  c.Greater("a point that is selected in a partition moves with its copies", least, 1e-6);
  c.True("others do not", areOthersStill);
}

}

int TestPartitionJoins(int argc, char* argv[])
{
  Groups groups(argc, argv);
  groups.Run("Ghosts", CheckGhosts);
  groups.Run("Welding", CheckWelding);
  groups.Run("Touch", CheckTouch);
  groups.Run("GlobalIds", CheckGlobalIds);
  groups.Run("Blocks", CheckBlocks);
  groups.Run("Selection", CheckSelection);
  return groups.Result();
}
