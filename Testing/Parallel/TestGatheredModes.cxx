// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause

// What needs the whole surface: process 0 gathers the pieces.
#include "Checks.h"
#include "ParallelTesting.h"

#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkLaplacianMeshOptimizer.h"
#include "vtkPolyData.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"

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
  double error = 1e-9; ///< by another order of the vertices
};

std::vector<Case> ModesWithoutChoices()
{
  return {
    { "SMOOTH_GUIDED", [](Optimizer* filter) { filter->SetMode(Optimizer::SMOOTH_GUIDED); }, 1e-6 },
    { "RobustLaplacian", [](Optimizer* filter) { filter->RobustLaplacianOn(); } },
    { "FeatureSmoothing",
      [](Optimizer* filter)
      {
        filter->SetMode(Optimizer::SMOOTH);
        filter->FeatureSmoothingOn();
      } },
    { "CURVE",
      [](Optimizer* filter)
      {
        filter->SetMode(Optimizer::SMOOTH);
        filter->SetBoundaryCondition(Optimizer::CURVE);
      } },
    { "PreserveVolume",
      [](Optimizer* filter)
      {
        filter->SetMode(Optimizer::SMOOTH);
        filter->PreserveVolumeOn();
      } },
    { "volumes of labels",
      [](Optimizer* filter)
      {
        filter->SetMode(Optimizer::SMOOTH);
        filter->PreserveVolumeOn();
        filter->SetInputArrayToProcess(
          Optimizer::FEATURE_ARRAY, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "Label");
      } },
    { "CheckSelfIntersections", [](Optimizer* filter) { filter->CheckSelfIntersectionsOn(); } },
  };
}

std::vector<Case> AllModes()
{
  std::vector<Case> cases = ModesWithoutChoices();
  cases.push_back({ "OPTIMIZE_WITHIN_DEVIATION",
    [](Optimizer* filter) { filter->SetMode(Optimizer::OPTIMIZE_WITHIN_DEVIATION); } });
  cases.push_back({ "OPTIMIZE_WITHIN_DEVIATION without welding", [](Optimizer* filter)
    {
      filter->SetMode(Optimizer::OPTIMIZE_WITHIN_DEVIATION);
      filter->WeldCoincidentPointsOff();
    } });
  return cases;
}

/// Labels of the cells, of the pieces as of the whole.
void AddLabels(vtkPolyData* surface, const std::vector<Index>& cells)
{
  vtkNew<vtkDoubleArray> labels;
  labels->SetName("Label");
  for (const Index cell : cells)
  {
    labels->InsertNextValue(cell % 1000 < 500);
  }
  surface->GetCellData()->AddArray(labels);
}

/// A surface with edges, a border and arrays.
vtkSmartPointer<vtkPolyData> Whole(const TestMesh& mesh)
{
  auto whole = MakePolyData(mesh);
  AddPointArray(whole, "Field", (mesh.V.col(0).array() * 3).sin().matrix());
  std::vector<Index> cells(mesh.T.rows());
  for (std::size_t t = 0; t < cells.size(); ++t)
  {
    cells[t] = static_cast<Index>(t);
  }
  AddLabels(whole, cells);
  return whole;
}

PieceOfMesh Take(vtkPolyData* whole, const Cut& cut, int rank, int size, const Change& change)
{
  PieceOfMesh piece = TakePiece(whole, cut, rank, size);
  change(piece);
  AddLabels(piece.surface, piece.cells);
  return piece;
}

/// The pieces of all processes, as partitions, optimized in this process alone.
/// \return the partition of this process
vtkSmartPointer<vtkPolyData> OptimizedAsPartition(
  MpiJob& job, vtkPolyData* whole, const Cut& cut, const SetUp& setUp, const Change& change)
{
  vtkNew<vtkPartitionedDataSet> partitions;
  for (int rank = 0; rank < job.Size(); ++rank)
  {
    partitions->SetPartition(rank, Take(whole, cut, rank, job.Size(), change).surface);
  }
  const auto output = OptimizedAlone(partitions.Get(), setUp);
  return vtkPolyData::SafeDownCast(
    vtkPartitionedDataSet::SafeDownCast(output)->GetPartition(job.Rank()));
}

void CheckModes(MpiJob& job, Checks& c)
{
  // Around the axis of the sectors, so that every process has a piece.
  const TestMesh mesh = Transformed(Irregular(Cube(3), 0.01), 1, { -0.5, -0.5, 0 });
  const auto whole = Whole(mesh);
  const std::pair<std::string, Change> changes[] = {
    { "", [](PieceOfMesh&) {} },
    { " with ghost cells", [&](PieceOfMesh& piece) { AddGhostCells(piece, whole); } },
    { " with global ids", AddGlobalIds },
  };
  for (const auto& [suffix, change] : changes)
  {
    for (const Case& each : AllModes())
    {
      const auto expected = OptimizedAsPartition(job, whole, Sectors(mesh), each.setUp, change);
      const auto piece = Take(whole, Sectors(mesh), job.Rank(), job.Size(), change);
      c.Error(each.name + suffix + ": pieces are the partitions of one process, bit by bit",
        job.Largest(!AreEqual(Optimized(piece.surface, each.setUp), expected)), 0);
    }
  }
}

void CheckWhole(MpiJob& job, Checks& c)
{
  const std::pair<std::string, TestMesh> meshes[] = {
    { "a cube", Irregular(Cube(3), 0.01) },
    { "an open surface", Irregular(HalfSphere(3), 0.02) },
  };
  for (const auto& [name, mesh] : meshes)
  {
    const auto whole = Whole(mesh);
    for (const Case& each : ModesWithoutChoices())
    {
      const SetUp precise = [&](Optimizer* filter)
      {
        filter->SetTolerance(1e-12);
        filter->InterpolatePointDataOff();
        each.setUp(filter);
      };
      const auto piece = Take(whole, Scattered(), job.Rank(), job.Size(), [](PieceOfMesh&) {});
      c.Error(each.name + " on " + name + ": the pieces are those of the whole surface",
        job.Largest(DifferenceFromWhole(
          piece, Optimized(piece.surface, precise), OptimizedAlone(whole.Get(), precise))),
        each.error);
    }
  }
}

void CheckDeviation(MpiJob& job, Checks& c)
{
  const TestMesh mesh = Irregular(Icosphere(3), 0.02);
  const auto whole = Whole(mesh);
  const SetUp within = [](Optimizer* filter)
  { filter->SetMode(Optimizer::OPTIMIZE_WITHIN_DEVIATION); };
  const auto piece = Take(whole, Scattered(), job.Rank(), job.Size(), [](PieceOfMesh&) {});
  const auto output = Optimized(piece.surface, within);
  const auto expected = OptimizedAlone(whole.Get(), within);
  const auto difference = [&](const char* name)
  { return job.Largest(std::abs(FieldValue(output, name) - FieldValue(expected, name))); };
  c.Error("the mean radius ratio is that of one process", difference("MeanRadiusRatio"), 0.002);
  c.Error("so is the least one", difference("MinimumRadiusRatio"), 0.02);
  c.Error("the bound holds", job.Largest(FieldValue(output, "RelativeHausdorffBound")), 0.002);
  vtkNew<Optimizer> filter;
  filter->SetInputData(piece.surface);
  filter->Update();
  c.Error("every process has the metrics",
    job.Largest(std::abs(filter->GetMeanRadiusRatio() - FieldValue(output, "MeanRadiusRatio"))), 0);
  filter->SetNumberOfPasses(1);
  filter->Update();
  c.Error("other properties take effect",
    job.Largest(std::abs(FieldValue(filter->GetOutput(), "Passes") - 1)), 0);
  filter->SetMode(Optimizer::OPTIMIZE_TRIANGLES);
  filter->Update();
  c.Error("a mode that works on pieces may follow",
    job.Largest(!AreEqual(filter->GetOutput(), Optimized(piece.surface))), 0);
  filter->SetMode(Optimizer::OPTIMIZE_WITHIN_DEVIATION);
  filter->SetNumberOfPasses(5);
  filter->Update();
  c.Error("and the first one again", job.Largest(!AreEqual(filter->GetOutput(), output)), 0);
}

void CheckReference(MpiJob& job, Checks& c)
{
  const TestMesh mesh = Irregular(Icosphere(3), 0.02);
  const auto whole = Whole(mesh);
  const auto reference = MakePolyData(Icosphere(3));
  AddPointArray(reference, "OfReference", Icosphere(3).V.col(1));
  const auto take = [&](vtkPolyData* surface)
  { return TakePiece(surface, Sectors(mesh), job.Rank(), job.Size()).surface; };
  const auto pieceOfReference = take(reference);
  const auto output = Optimized(take(whole),
    [&](Optimizer* filter)
    {
      filter->SetMode(Optimizer::OPTIMIZE_WITHIN_DEVIATION);
      filter->SetMaximumDeviation(0.02);
      filter->SetReferenceData(pieceOfReference);
    });
  const auto expected = OptimizedAlone(whole.Get(),
    [&](Optimizer* filter)
    {
      filter->SetMode(Optimizer::OPTIMIZE_WITHIN_DEVIATION);
      filter->SetMaximumDeviation(0.02);
      filter->SetReferenceData(reference);
    });
  c.Error("a reference in pieces leads to the radius ratios of the whole one",
    job.Largest(
      std::abs(FieldValue(output, "MeanRadiusRatio") - FieldValue(expected, "MeanRadiusRatio"))),
    1e-3);
  c.Error("the surface stays within the deviation from the whole reference",
    job.Largest(FieldValue(output, "RelativeHausdorffBound")), 0.02);
  c.Error("its arrays arrive",
    job.Largest(
      (PointsOf(output).col(1) - PointValues(output, "OfReference")).cwiseAbs().maxCoeff()),
    0.1);
}

void CheckSelection(MpiJob& job, Checks& c)
{
  const TestMesh mesh = Irregular(Icosphere(3), 0.02);
  const auto piece = TakePiece(MakePolyData(mesh), Sectors(mesh), job.Rank(), job.Size()).surface;
  const auto selection = Selection({ SelectionNode(vtkSelectionNode::POINT, { 5 }) });
  const auto shifts = [&](int use)
  {
    const auto output = Optimized(piece,
      [&](Optimizer* filter)
      {
        filter->SetMode(Optimizer::SMOOTH_GUIDED);
        filter->SetSelectionData(selection);
        filter->SetSelectionUse(use);
      });
    return Vector((PointsOf(output) - PointsOf(piece)).rowwise().norm());
  };
  c.Error("a point that is selected in a piece stays",
    job.Largest(shifts(Optimizer::SELECTED_POINTS_STAY)[5]), 0);
  const Vector alone = shifts(Optimizer::ONLY_SELECTED_POINTS_MOVE);
  c.Error("or it moves", job.Largest(alone[5] <= 1e-6), 0);
  // and copies of points that are selected in other pieces
  c.Error("with few others", job.Largest(double((alone.array() > 0).count())), job.Size());
}

void CheckCancellation(MpiJob& job, Checks& c)
{
  const TestMesh mesh = Irregular(Icosphere(3), 0.02);
  const auto piece = TakePiece(MakePolyData(mesh), Sectors(mesh), job.Rank(), job.Size()).surface;
  vtkNew<Optimizer> filter;
  filter->SetMode(Optimizer::SMOOTH_GUIDED);
  filter->SetInputData(piece);
  if (job.Rank() == 0)
  {
    filter->AddObserver(vtkCommand::ProgressEvent, filter.Get(), &Optimizer::AbortExecuteOn);
  }
  const Messages messages = Update(filter);
  c.Error("process 0 stops all, without an error", job.Largest(!messages.errors.empty()), 0);
  c.Error("then no process has a result", job.Largest(!IsEmpty(filter->GetOutput())), 0);
}

void CheckEmpty(MpiJob& job, Checks& c)
{
  vtkNew<vtkPolyData> nothing;
  vtkNew<Optimizer> filter;
  filter->SetInputData(nothing);
  const Messages messages = Update(filter);
  c.Error("all pieces may be empty", job.Largest(!messages.errors.empty()), 0);
  const TestMesh mesh = Irregular(Icosphere(2), 0.02);
  const auto whole = MakePolyData(mesh);
  const auto piece = TakePiece(whole, AllInLast(), job.Rank(), job.Size());
  const SetUp constrained = [](Optimizer* each)
  {
    each->FeatureConstraintsOn();
    each->SetTolerance(1e-12);
  };
  const auto output = Optimized(piece.surface, constrained);
  const auto expected = OptimizedAlone(whole.Get(), constrained);
  const bool isEmpty = piece.points.empty();
  c.Error("all triangles may be in one process",
    job.Largest(isEmpty ? 0 : DifferenceFromWhole(piece, output, expected)), 1e-9);
  c.Error("the others have the metrics, too",
    job.Largest(
      std::abs(FieldValue(output, "MeanRadiusRatio") - FieldValue(expected, "MeanRadiusRatio"))),
    1e-9);
}
}

int TestGatheredModes(int argc, char* argv[])
{
  MpiJob job(argc, argv);
  Checks c;
  CheckDeviation(job, c);
  CheckReference(job, c);
  CheckSelection(job, c);
  CheckCancellation(job, c);
  CheckEmpty(job, c);
  if (job.Size() > 1)
  {
    CheckModes(job, c);
    CheckWhole(job, c);
  }
  return c.Result();
}
