// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause

// Partitions, which are pieces of one surface.
#include "Checks.h"
#include "FilterTesting.h"
#include "MeshMeasures.h"
#include "SurfacePartitions.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkLaplacianMeshOptimizer.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSurfaceDeviation.h"

#include <algorithm>
#include <cmath>

using namespace lmo;

namespace
{
using Optimizer = vtkLaplacianMeshOptimizer;
using SetUp = std::function<void(Optimizer*)>;

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
  groups.Run("PoorPartitions", CheckPoorPartitions);
  groups.Run("Reference", CheckReference);
  return groups.Result();
}
