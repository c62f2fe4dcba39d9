// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause

// Partitions, which are pieces of one surface.
#include "Checks.h"
#include "FilterTesting.h"
#include "MeshMeasures.h"
#include "SurfacePartitions.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkLaplacianMeshOptimizer.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiPieceDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataNormals.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkSurfaceDeviation.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>

using namespace lmo;

namespace
{
using Optimizer = vtkLaplacianMeshOptimizer;
using SetUp = std::function<void(Optimizer*)>;

void Precise(Optimizer* filter)
{
  filter->SetMode(Optimizer::OPTIMIZE_TRIANGLES);
  filter->SetTolerance(1e-12);
}

vtkSmartPointer<vtkPartitionedDataSet> OptimizedPartitions(
  vtkDataObject* input, const SetUp& setUp = Precise)
{
  vtkNew<Optimizer> filter;
  filter->SetInputDataObject(input);
  setUp(filter);
  filter->Update();
  return vtkPartitionedDataSet::SafeDownCast(filter->GetOutputDataObject(0));
}

vtkPolyData* Part(vtkPartitionedDataSet* partitions, unsigned int k)
{
  return partitions ? vtkPolyData::SafeDownCast(partitions->GetPartition(k)) : nullptr;
}

/// The largest distance between points of partitions and those of a whole surface.
double DistanceToWhole(
  const PartitionsOfMesh& mesh, vtkPartitionedDataSet* optimized, vtkPolyData* whole)
{
  const Points expected = PointsOf(whole);
  double difference = 0;
  for (unsigned int k = 0; k < mesh.points.size(); ++k)
  {
    const std::vector<Index>& points = mesh.points[k];
    const Points moved = PointsOf(Part(optimized, k));
    difference = Larger(difference, MaximumDistance(moved, expected(points, Eigen::indexing::all)));
  }
  return difference;
}

/// How far apart the copies of a point are, at most.
double DistanceOfCopies(const PartitionsOfMesh& mesh, vtkPartitionedDataSet* optimized)
{
  std::vector<std::vector<Vector3>> places(mesh.size);
  for (unsigned int k = 0; k < mesh.points.size(); ++k)
  {
    const Points moved = PointsOf(Part(optimized, k));
    for (std::size_t i = 0; i < mesh.points[k].size(); ++i)
    {
      places[mesh.points[k][i]].push_back(moved.row(static_cast<Eigen::Index>(i)));
    }
  }
  double difference = 0;
  for (const std::vector<Vector3>& copies : places)
  {
    for (const Vector3& copy : copies)
    {
      difference = Larger(difference, (copy - copies.front()).cwiseAbs().maxCoeff());
    }
  }
  return difference;
}

void CheckWhole(Checks& c)
{
  for (const auto& [name, mesh] : AllTestMeshes())
  {
    const auto whole = MakePolyData(Irregular(mesh, 0.003));
    const PartitionsOfMesh partitions = CutIntoPartitions(whole, 3);
    c.Error(name + ": partitions move as the whole surface",
      DistanceToWhole(partitions, OptimizedPartitions(partitions.data), Optimized(whole, Precise)) /
        std::max(whole->GetLength(), 1e-300),
      1e-9);
  }
  const auto whole = MakePolyData(Irregular(Icosphere(3), 0.02));
  const PartitionsOfMesh partitions = CutIntoPartitions(whole, 4);
  const double alone = MaximumDistance(PointsOf(Optimized(Part(partitions.data, 1), Precise)),
    PointsOf(Optimized(whole, Precise))(partitions.points[1], Eigen::indexing::all));
  c.Greater("which a partition alone does not", alone, 1e-3);
}

void CheckMetrics(Checks& c)
{
  const auto whole = MakePolyData(Irregular(Icosphere(3), 0.02));
  const auto optimized = OptimizedPartitions(CutIntoPartitions(whole, 3).data);
  const auto expected = Optimized(whole, Precise);
  for (const char* name : { "MeanRadiusRatio", "MinimumRadiusRatio", "RelativeVolumeChange" })
  {
    c.Error(std::string(name) + " of a partition is that of the whole surface",
      std::abs(FieldValue(Part(optimized, 1), name) - FieldValue(expected, name)), 1e-9);
  }
  double ratio = HUGE_VAL;
  for (unsigned int k = 0; k < 3; ++k)
  {
    ratio = std::min(ratio, CellValues(Part(optimized, k), "RadiusRatio").minCoeff());
  }
  c.Equal("the smallest one is in the cells of a partition", ratio,
    FieldValue(Part(optimized, 0), "MinimumRadiusRatio"));
}

void CheckBorders(Checks& c)
{
  for (const int type : { VTK_FLOAT, VTK_DOUBLE })
  {
    const auto whole = MakePolyData(Irregular(Icosphere(3), 0.02), type);
    const PartitionsOfMesh partitions = CutIntoPartitions(whole, 4);
    const auto optimized =
      OptimizedPartitions(partitions.data, [](Optimizer* filter) { filter->SetNumberOfPasses(2); });
    c.Equal("copies of a point at borders of partitions have the same bits",
      DistanceOfCopies(partitions, optimized), 0.0);
    c.Equal(
      "points have the type of the input's", Part(optimized, 0)->GetPoints()->GetDataType(), type);
  }
}

void CheckDeviation(Checks& c)
{
  const auto whole = MakePolyData(Irregular(Icosphere(3), 0.02));
  const PartitionsOfMesh partitions = CutIntoPartitions(whole, 4);
  const SetUp within = [](Optimizer* filter) { filter->SetMaximumDeviation(0.003); };
  const auto optimized = OptimizedPartitions(partitions.data, within);
  vtkNew<vtkPolyData> moved;
  moved->DeepCopy(whole);
  for (unsigned int k = 0; k < 4; ++k)
  {
    for (std::size_t i = 0; i < partitions.points[k].size(); ++i)
    {
      moved->GetPoints()->SetPoint(
        partitions.points[k][i], Part(optimized, k)->GetPoint(static_cast<vtkIdType>(i)));
    }
  }
  vtkNew<vtkSurfaceDeviation> deviation;
  deviation->SetInputData(moved);
  deviation->SetReferenceData(whole);
  deviation->Update();
  c.Error("the surface of all partitions is within the deviation",
    deviation->GetRelativeHausdorffDistance(), 0.003);
  const auto expected = Optimized(whole,
    [&](Optimizer* filter)
    {
      filter->SetMode(Optimizer::OPTIMIZE_WITHIN_DEVIATION);
      within(filter);
    });
  c.Error("with triangles as good as those of the whole surface",
    std::abs(
      FieldValue(Part(optimized, 0), "MeanRadiusRatio") - FieldValue(expected, "MeanRadiusRatio")),
    0.002);
}

void CheckStructure(Checks& c)
{
  const auto whole = MakePolyData(Irregular(HalfSphere(2), 0.02));
  const PartitionsOfMesh mesh = CutIntoPartitions(whole, 2);
  vtkNew<vtkPartitionedDataSet> input;
  input->SetNumberOfPartitions(5);
  input->SetPartition(1, Part(mesh.data, 0));
  input->SetPartition(2, vtkNew<vtkPolyData>());
  input->SetPartition(4, Part(mesh.data, 1));
  vtkNew<vtkPolyData> before;
  before->DeepCopy(Part(mesh.data, 0));
  const auto output = OptimizedPartitions(input);
  c.True("the output of partitions is partitions", output != nullptr);
  c.Equal("as many", output->GetNumberOfPartitions(), 5u);
  c.True("empty ones stay empty", !output->GetPartition(0) && !output->GetPartition(3));
  c.Equal("also with a surface without points", Part(output, 2)->GetNumberOfPoints(), 0);
  c.True("the cells are those of the input",
    AreEqual(Part(output, 4)->GetPolys(), Part(mesh.data, 1)->GetPolys()));
  c.True("the input stays", AreEqual(before, Part(mesh.data, 0)));
  c.Equal("its partitions move as without the empty ones",
    MaximumDistance(PointsOf(Part(output, 1)), PointsOf(Part(OptimizedPartitions(mesh.data), 0))),
    0.0);
  const auto again = OptimizedPartitions(output);
  c.True("an array that is a result is renewed by the next filter",
    !Part(again, 1)->GetPointData()->HasArray("RadiusRatioOptimized") &&
      !Part(again, 1)->GetFieldData()->HasArray("IterationsOptimized"));
}

void CheckArrays(Checks& c)
{
  const auto mixed = MakeMixedPolyData();
  vtkNew<vtkPartitionedDataSet> input;
  for (unsigned int k = 0; k < 2; ++k)
  {
    vtkNew<vtkPolyData> part;
    part->DeepCopy(mixed);
    for (vtkIdType i = 0; i < part->GetNumberOfPoints() && k > 0; ++i)
    {
      double x[3];
      part->GetPoint(i, x);
      x[0] += 100;
      part->GetPoints()->SetPoint(i, x);
    }
    input->SetPartition(k, part);
  }
  AddPointArray(Part(input, 1), "Own", Eigen::VectorXd::Ones(mixed->GetNumberOfPoints()));
  const auto quiet = [](Optimizer* filter)
  {
    Precise(filter);
    filter->InterpolatePointDataOff();
    filter->ComputeNormalsOff();
  };
  const auto output = OptimizedPartitions(input, quiet);
  for (unsigned int k = 0; k < 2; ++k)
  {
    c.True("vertices, lines, polygons and strips keep their arrays",
      Contains(Part(output, k)->GetCellData(), Part(input, k)->GetCellData()));
    c.True("points keep their arrays, also those that one partition has alone",
      Contains(Part(output, k)->GetPointData(), Part(input, k)->GetPointData()));
    c.True("a partition has its own field data",
      Contains(Part(output, k)->GetFieldData(), Part(input, k)->GetFieldData()));
  }
  c.True("an array of one partition is not in the other",
    !Part(output, 0)->GetPointData()->HasArray("Own"));
  const Eigen::MatrixXd ratios = CellValues(Part(output, 1), "RadiusRatio");
  c.True("vertices and lines have no radius ratio, triangles and strips have one",
    ratios.topRows(3).maxCoeff() == -1 && ratios.bottomRows(ratios.rows() - 3).minCoeff() >= 0);
}

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
  vtkNew<vtkIdTypeArray> ids;
  ids->InsertNextValue(point);
  vtkNew<vtkSelectionNode> node;
  node->SetFieldType(vtkSelectionNode::POINT);
  node->SetContentType(vtkSelectionNode::INDICES);
  node->SetSelectionList(ids);
  node->GetProperties()->Set(vtkSelectionNode::COMPOSITE_INDEX(), 2); // the set is 0
  vtkNew<vtkSelection> selection;
  selection->AddNode(node);
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

void CheckPoorPartitions(Checks& c)
{
  vtkNew<vtkPartitionedDataSet> input;
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(1, 2, 3);
  points->InsertNextPoint(1, 2, 3);
  for (unsigned int k = 0; k < 2; ++k)
  {
    vtkNew<vtkPolyData> part;
    part->SetPoints(points);
    input->SetPartition(k, part);
  }
  const auto output = OptimizedPartitions(input);
  c.Equal("partitions without cells keep their points",
    MaximumDistance(PointsOf(Part(output, 1)), PointsOf(Part(input, 1))), 0.0);
  c.Equal("and get no cells", Part(output, 0)->GetNumberOfCells(), 0);
  vtkNew<vtkPartitionedDataSet> nothing;
  vtkNew<Optimizer> filter;
  filter->SetInputDataObject(nothing);
  c.True("no partitions are no error", Update(filter).errors.empty());
}

void CheckReference(Checks& c)
{
  const auto whole = MakePolyData(Irregular(Icosphere(2), 0.02));
  const auto input = MakePolyData(Irregular(Icosphere(2), 0.021));
  const auto output = [&](vtkDataObject* reference)
  {
    vtkNew<Optimizer> filter;
    filter->SetInputData(input);
    filter->SetInputDataObject(2, reference);
    filter->Update();
    return PointsOf(filter->GetOutput());
  };
  c.Error("a reference in partitions is the whole reference",
    MaximumDistance(output(CutIntoPartitions(whole, 3).data), output(whole)), 1e-6);
}
}

int TestOptimizerPartitions(int argc, char* argv[])
{
  Groups groups(argc, argv);
  groups.Run("Whole", CheckWhole);
  groups.Run("Metrics", CheckMetrics);
  groups.Run("Borders", CheckBorders);
  groups.Run("Deviation", CheckDeviation);
  groups.Run("Structure", CheckStructure);
  groups.Run("Arrays", CheckArrays);
  groups.Run("Ghosts", CheckGhosts);
  groups.Run("Welding", CheckWelding);
  groups.Run("Touch", CheckTouch);
  groups.Run("GlobalIds", CheckGlobalIds);
  groups.Run("Blocks", CheckBlocks);
  groups.Run("Selection", CheckSelection);
  groups.Run("PoorPartitions", CheckPoorPartitions);
  groups.Run("Reference", CheckReference);
  return groups.Result();
}
