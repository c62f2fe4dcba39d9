// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause

// OPTIMIZE_WITHIN_DEVIATION on pieces that stay where they are.
#include "Checks.h"
#include "MeshMeasures.h"
#include "ParallelTesting.h"

#include "Core/Deviation/SelfIntersections.h"

#include "vtkLaplacianMeshOptimizer.h"
#include "vtkPolyData.h"
#include "vtkSurfaceDeviation.h"

#include <algorithm>
#include <cmath>

using namespace lmo;

namespace
{
using Optimizer = vtkLaplacianMeshOptimizer;

void WithinDeviation(Optimizer* filter)
{
  filter->SetMode(Optimizer::OPTIMIZE_WITHIN_DEVIATION);
}

/// A grid of points that position(u, v) places, u and v from 0 to 1, with uneven parameters, but
/// for u = 0.5 in the middle column.
template <typename Position>
TestMesh UnevenGrid(Index columns, Index rows, const Position& position)
{
  Random random;
  TestMesh mesh{ Points(columns * rows, 3), Triangles(2 * (columns - 1) * (rows - 1), 3) };
  for (Index i = 0; i < columns; ++i)
  {
    for (Index j = 0; j < rows; ++j)
    {
      const bool isInside = i > 0 && j > 0 && i < columns - 1 && j < rows - 1;
      const double shift = isInside ? 0.25 : 0;
      const double u = (i + (2 * i == columns - 1 ? 0 : shift) * random()) / (columns - 1);
      const double v = (j + shift * random()) / (rows - 1);
      mesh.V.row(i * rows + j) = position(u, v);
      if (i > 0 && j > 0)
      {
        const Index t = 2 * ((i - 1) * (rows - 1) + j - 1);
        const Index a = (i - 1) * rows + j - 1;
        mesh.T.row(t) << a, a + rows, a + rows + 1;
        mesh.T.row(t + 1) << a, a + rows + 1, a + 1;
      }
    }
  }
  return mesh;
}

/// Enough points for four processes to work on their pieces.
constexpr Index Columns = 321;
constexpr Index Rows = 260;

/// A wavy sheet with a sharp fold along x = 0.5.
TestMesh FoldedSheet()
{
  return UnevenGrid(Columns, Rows,
    [](double u, double v)
    { return Vector3(u, v, std::abs(u - 0.5) + 0.02 * std::sin(9 * v) * std::cos(7 * u)); });
}

/// Two sheets, one above the other, with waves that are higher than the gap.
TestMesh ThinWall(double gap)
{
  const auto sheet = [&](double z)
  {
    return UnevenGrid(Columns, Rows / 2,
      [z](double u, double v)
      { return Vector3(u, v, z + 0.02 * std::sin(25 * u) * std::cos(25 * v)); });
  };
  const TestMesh below = sheet(0);
  const TestMesh above = sheet(gap);
  TestMesh wall{ Points(2 * below.V.rows(), 3), Triangles(2 * below.T.rows(), 3) };
  wall.V << below.V, above.V;
  wall.T << below.T, above.T.array() + static_cast<Index>(below.V.rows());
  return wall;
}

/// Strips across x.
Cut Strips(const TestMesh& mesh)
{
  return [mesh](Index t, int processes)
  {
    const double x = mesh.V(mesh.T.row(t).transpose(), Eigen::indexing::all).col(0).mean();
    return std::min(static_cast<int>(x * processes), processes - 1);
  };
}

/// One sheet of a wall goes to the first process, the other one to the last.
Cut Sheets(const TestMesh& mesh)
{
  const auto half = static_cast<Index>(mesh.T.rows()) / 2;
  return [half](Index t, int processes) { return t < half ? 0 : processes - 1; };
}

/// A mesh that was optimised in pieces.
struct Outcome
{
  vtkSmartPointer<vtkPolyData> piece; ///< of this process
  TestMesh mesh;                      ///< all pieces together
  double differenceOfCopies = 0;      ///< of points that several pieces have
};

Outcome OptimizeInPieces(MpiJob& job, const TestMesh& mesh, const Cut& cut)
{
  const auto whole = MakePolyData(mesh);
  AddPointArray(whole, "X", mesh.V.col(0));
  const PieceOfMesh piece = TakePiece(whole, cut, job.Rank(), job.Size());
  Outcome outcome;
  outcome.piece = Optimized(piece.surface, WithinDeviation);
  const Points own = PointsOf(outcome.piece);
  Points positions = Points::Constant(mesh.V.rows(), 3, -HUGE_VAL);
  for (std::size_t k = 0; k < piece.points.size(); ++k)
  {
    positions.row(piece.points[k]) = own.row(static_cast<Eigen::Index>(k));
  }
  outcome.mesh = { job.Largest(positions), mesh.T };
  for (const Index i : piece.points)
  {
    outcome.differenceOfCopies =
      std::max(outcome.differenceOfCopies, (positions.row(i) - outcome.mesh.V.row(i)).norm());
  }
  outcome.differenceOfCopies = job.Largest(outcome.differenceOfCopies);
  return outcome;
}

double HausdorffDistance(const TestMesh& a, const TestMesh& b)
{
  vtkNew<vtkSurfaceDeviation> measure;
  measure->SetInputData(MakePolyData(a));
  measure->SetReferenceData(MakePolyData(b));
  measure->Update();
  return measure->GetRelativeHausdorffDistance();
}

/// How far the points of the fold are from where it was.
double DistanceFromFold(const TestMesh& sheet, const Points& positions)
{
  constexpr Index first = (Columns - 1) / 2 * Rows;
  double largest = 0;
  for (Index i = first; i < first + Rows; ++i)
  {
    double distance = HUGE_VAL;
    for (Index k = first; k + 1 < first + Rows; ++k)
    {
      distance =
        std::min(distance, DistanceToSegment(positions.row(i), sheet.V.row(k), sheet.V.row(k + 1)));
    }
    largest = std::max(largest, distance);
  }
  return largest;
}

/// What measure() returns in process 0, in every process; >= 0.
template <typename Measure>
double InFirst(MpiJob& job, const Measure& measure)
{
  return job.Largest(job.Rank() == 0 ? measure() : 0);
}

void CheckSheet(MpiJob& job, const TestMesh& mesh, Checks& c)
{
  vtkSmartPointer<vtkPolyData> alone;
  const auto figureAlone = [&](const char* name)
  {
    return InFirst(job,
      [&]
      {
        alone = alone ? alone : OptimizedAlone(MakePolyData(mesh), WithinDeviation);
        return FieldValue(alone, name);
      });
  };
  const Outcome outcome = OptimizeInPieces(job, mesh, Strips(mesh));
  vtkPolyData* output = outcome.piece;
  const double mean = figureAlone("MeanRadiusRatio");
  const double least = figureAlone("MinimumRadiusRatio");
  c.Error("copies of points have the same bits", outcome.differenceOfCopies, 0);
  c.Error("the mean radius ratio is that of one process",
    std::abs(FieldValue(output, "MeanRadiusRatio") - mean), 0.002);
  c.Error("so is the least one", std::abs(FieldValue(output, "MinimumRadiusRatio") - least), 0.02);
  c.Error("no triangle turns over", FieldValue(output, "FlippedTriangles"), 0);
  c.Error("the bound is within the deviation", FieldValue(output, "RelativeHausdorffBound"), 0.002);
  c.Error("the distance is within the bound",
    InFirst(job, [&] { return HausdorffDistance(outcome.mesh, mesh); }),
    FieldValue(output, "RelativeHausdorffBound") + 1e-12);
  c.Error("points of the fold stay on it", DistanceFromFold(mesh, outcome.mesh.V), 1e-9);
  c.Error("a field stays where it is",
    job.Largest(LargestMagnitude(PointValues(output, "X") - PointsOf(output).col(0))), 3e-4);
  const auto difference = [&](const Cut& cut) {
    return std::abs(FieldValue(OptimizeInPieces(job, mesh, cut).piece, "MeanRadiusRatio") - mean);
  };
  c.Error("all triangles may be in one process", difference(AllInLast()), 0.002);
  c.Error("pieces may be nothing but seams", difference(Scattered()), 0.002);
}

void CheckWall(MpiJob& job, Checks& c)
{
  const TestMesh wall = ThinWall(0.001);
  const Outcome outcome = OptimizeInPieces(job, wall, Sheets(wall));
  IntersectionReport report;
  if (job.Rank() == 0)
  {
    ProgressMonitor unwatched;
    report = CompareIntersections(wall.V, outcome.mesh.V, wall.T,
      BuildTopology(static_cast<Index>(wall.V.rows()), wall.T), unwatched);
  }
  c.Error("sheets of different processes do not meet", double(report.added), 0);
  c.Error("and the filter says so", FieldValue(outcome.piece, "SelfIntersections"), 0);
  c.AtLeast("triangles become better nevertheless", FieldValue(outcome.piece, "MeanRadiusRatio"),
    FieldValue(outcome.piece, "InputMeanRadiusRatio") + 0.02);
}
}

int TestDistributedDeviation(int argc, char* argv[])
{
  MpiJob job(argc, argv);
  Checks c;
  CheckSheet(job, FoldedSheet(), c);
  CheckWall(job, c);
  return c.Result();
}
