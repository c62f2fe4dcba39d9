// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause

// OPTIMIZE_WITHIN_DEVIATION on pieces that stay where they are.
#include "Checks.h"
#include "MeshMeasures.h"
#include "ParallelTesting.h"

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
      const double shift = isInside ? 0.4 : 0;
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

/// The sheets of a wall, each of which goes to half of the processes.
Cut Sheets(const TestMesh& mesh)
{
  const auto half = static_cast<Index>(mesh.T.rows()) / 2;
  return [half](Index t, int processes)
  { return t * 2L * processes / (4L * half) >= processes / 2 ? processes - 1 : 0; };
}

/// What the pieces of all processes become, as the whole mesh; the piece's points alone are set.
Points OptimizedPiece(MpiJob& job, const TestMesh& mesh, const Cut& cut, vtkPolyData*& output,
  vtkSmartPointer<vtkPolyData>& keep)
{
  const auto whole = MakePolyData(mesh);
  const PieceOfMesh piece = TakePiece(whole, cut, job.Rank(), job.Size());
  keep = Optimized(piece.surface, WithinDeviation);
  output = keep;
  Points positions = Points::Constant(mesh.V.rows(), 3, -HUGE_VAL);
  const Points own = PointsOf(keep);
  for (std::size_t k = 0; k < piece.points.size(); ++k)
  {
    positions.row(piece.points[k]) = own.row(static_cast<Eigen::Index>(k));
  }
  return positions;
}

/// The whole mesh after the optimisation, in every process, and whether copies agree.
struct Merged
{
  TestMesh mesh;
  double differenceOfCopies;
};

Merged Merge(MpiJob& job, const TestMesh& mesh, const Points& positions)
{
  Merged merged{ { job.Largest(positions), mesh.T }, 0 };
  const auto isSet = (positions.col(0).array() > -HUGE_VAL);
  const Vector difference = (merged.mesh.V - positions).rowwise().norm();
  merged.differenceOfCopies = job.Largest(isSet.select(difference, 0).maxCoeff());
  return merged;
}

double HausdorffDistance(const TestMesh& a, const TestMesh& b)
{
  vtkNew<vtkSurfaceDeviation> measure;
  measure->SetInputData(MakePolyData(a));
  measure->SetReferenceData(MakePolyData(b));
  measure->Update();
  return measure->GetRelativeHausdorffDistance();
}

void CheckSheet(MpiJob& job, Checks& c)
{
  const TestMesh mesh = FoldedSheet();
  vtkPolyData* output = nullptr;
  vtkSmartPointer<vtkPolyData> keep;
  const Merged merged = Merge(job, mesh, OptimizedPiece(job, mesh, Strips(mesh), output, keep));
  const auto expected = OptimizedAlone(MakePolyData(mesh), WithinDeviation);
  const auto difference = [&](const char* name)
  { return job.Largest(std::abs(FieldValue(output, name) - FieldValue(expected, name))); };
  c.Error("copies of points have the same bits", merged.differenceOfCopies, 0);
  c.Error("the mean radius ratio is that of one process", difference("MeanRadiusRatio"), 0.002);
  c.Error("so is the least one", difference("MinimumRadiusRatio"), 0.02);
  c.Error("no triangle turns over", FieldValue(output, "FlippedTriangles"), 0);
  c.Error("the bound is within the deviation", FieldValue(output, "RelativeHausdorffBound"), 0.002);
  c.Error("the distance is within the bound", HausdorffDistance(merged.mesh, mesh),
    FieldValue(output, "RelativeHausdorffBound") + 1e-12);
  double fromFold = 0;
  for (Eigen::Index i = 0; i < mesh.V.rows(); ++i)
  {
    if (mesh.V(i, 0) == 0.5)
    {
      fromFold = std::max(fromFold, std::abs(merged.mesh.V(i, 0) - 0.5));
    }
  }
  c.Error("points of the fold stay on it", fromFold, 1e-9);
}
}

int TestDistributedDeviation(int argc, char* argv[])
{
  MpiJob job(argc, argv);
  Checks c;
  CheckSheet(job, c);
  return c.Result();
}
