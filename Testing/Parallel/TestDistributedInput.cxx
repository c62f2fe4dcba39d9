// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "MeshMeasures.h"
#include "ParallelTesting.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkLaplacianMeshOptimizer.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataNormals.h"

#include <cmath>

using namespace lmo;

namespace
{
using Optimizer = vtkLaplacianMeshOptimizer;

/// Weights, boundaries and neighbours of neighbours matter in it.
void Demanding(Optimizer* filter)
{
  filter->SetTolerance(1e-12);
  filter->SetPositionWeighting(Optimizer::LINEAR);
  filter->SetLaplacianWeighting(Optimizer::CDF_COMPLEMENT);
  filter->SetBoundaryCondition(Optimizer::SLIDING);
  filter->SetModulateByTriangleQuality(true);
}

/// Pieces, as \a change leaves them, against the whole surface.
double DifferenceOf(
  MpiJob& job, vtkPolyData* whole, const Cut& cut,
  const std::function<void(PieceOfMesh&)>& change = [](PieceOfMesh&) {})
{
  PieceOfMesh piece = TakePiece(whole, cut, job.Rank(), job.Size());
  change(piece);
  return job.Largest(DifferenceFromWhole(
    piece, Optimized(piece.surface, Demanding), OptimizedAlone(whole, Demanding)));
}

void CheckCuts(MpiJob& job, Checks& c)
{
  const TestMesh mesh = Irregular(HalfSphere(3), 0.02);
  const auto whole = MakePolyData(mesh);
  c.Error(
    "triangles dealt out one by one are one surface", DifferenceOf(job, whole, Scattered()), 1e-9);
  c.Error("all triangles may be in one process", DifferenceOf(job, whole, AllInLast()), 1e-9);
  c.Error("ghost cells do not count",
    DifferenceOf(
      job, whole, Sectors(mesh), [&](PieceOfMesh& piece) { AddGhostCells(piece, whole); }),
    1e-9);
  c.Error("ghost cells of triangles dealt out one by one do not count",
    DifferenceOf(job, whole, Scattered(), [&](PieceOfMesh& piece) { AddGhostCells(piece, whole); }),
    1e-9);
  c.Error("global ids of the input are used", DifferenceOf(job, whole, Sectors(mesh), AddGlobalIds),
    1e-9);
}

void CheckMeshes(MpiJob& job, Checks& c)
{
  for (const auto& [name, mesh] : AllTestMeshes())
  {
    c.Error(name + ": the pieces are those of the whole surface",
      DifferenceOf(job, MakePolyData(Irregular(mesh, 0.003)), Scattered()), 1e-9);
  }
  c.Error("float coordinates come out the same",
    DifferenceOf(job, MakePolyData(Irregular(Icosphere(3), 0.02), VTK_FLOAT), Scattered()), 1e-7);
}

/// Two sheets that touch in points with the same coordinates, which their global ids tell apart.
void CheckCoincidentPoints(MpiJob& job, Checks& c)
{
  TestMesh mesh = Irregular(Grid(8, 0.2), 0.02);
  const Index size = static_cast<Index>(mesh.V.rows());
  TestMesh sheets{ Points(2 * size, 3), Triangles(2 * mesh.T.rows(), 3) };
  sheets.V << mesh.V, mesh.V;
  sheets.V.bottomRows(size).col(2) += mesh.V.col(0);
  sheets.T << mesh.T, mesh.T.array() + size;
  c.Error("points that coincide are two if their global ids differ",
    DifferenceOf(job, MakePolyData(sheets), Sectors(sheets), AddGlobalIds), 1e-9);
}

void CheckNormals(MpiJob& job, Checks& c)
{
  const TestMesh mesh = Irregular(Icosphere(3), 0.02);
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(MakePolyData(mesh));
  normals->SplittingOff();
  normals->ConsistencyOff();
  normals->Update();
  c.Error("normals are computed over the boundaries",
    DifferenceOf(job, normals->GetOutput(), Sectors(mesh)), 1e-6);
}

void CheckPointData(MpiJob& job, Checks& c)
{
  const TestMesh mesh = WithThinTriangles(Irregular(Icosphere(4), 0.005));
  const auto surface = MakePolyData(mesh);
  AddPointArray(surface, "Scalar", (3 * mesh.V.col(0)).array().sin().matrix());
  Eigen::MatrixXd five(mesh.V.rows(), 5);
  five << mesh.V, mesh.V.leftCols(2).array().square().matrix();
  AddPointArray(surface, "Five", five);
  for (const Cut& cut : { Sectors(mesh), Scattered() })
  {
    c.Error("point data are interpolated over the borders of pieces",
      DifferenceOf(job, surface, cut), 1e-9);
  }
}

/// Texture coordinates that end at a seam, on both sides of which a point lies.
void CheckSeam(MpiJob& job, Checks& c)
{
  const auto soup = Soup(Irregular(Icosphere(2), 0.02));
  const auto surface = MakePolyData(soup);
  Vector side(soup.V.rows());
  for (Eigen::Index i = 0; i < side.size(); ++i)
  {
    side[i] = static_cast<double>(i % 7);
  }
  AddPointArray(surface, "Side", side);
  const auto piece = TakePiece(surface, Sectors(soup), job.Rank(), job.Size()).surface;
  vtkNew<Optimizer> filter;
  filter->SetMode(Optimizer::OPTIMIZE_TRIANGLES);
  filter->SetInputData(piece);
  const bool isSaid = Update(filter).warnings.find("stay with their points") != std::string::npos;
  c.Error("a warning says that values on the sides of seams stay with their points",
    job.Largest(isSaid != (job.Size() > 1)), 0);
  c.Error("and they do",
    job.Size() == 1 ? 0
                    : job.Largest(LargestMagnitude(
                        PointValues(filter->GetOutput(), "Side") - PointValues(piece, "Side"))),
    0);
}

void CheckEmpty(MpiJob& job, Checks& c)
{
  vtkNew<vtkPolyData> nothing;
  vtkNew<Optimizer> filter;
  filter->SetMode(Optimizer::OPTIMIZE_TRIANGLES);
  filter->SetInputData(nothing);
  const Messages messages = Update(filter);
  c.Error("all pieces may be empty", job.Largest(!messages.errors.empty()), 0);
  c.Error("an empty surface has no quality",
    job.Largest(std::abs(FieldValue(filter->GetOutput(), "MeanRadiusRatio") + 1)), 0);
}

void CheckGhosts(MpiJob& job, Checks& c)
{
  const TestMesh mesh = Irregular(Icosphere(3), 0.02);
  const auto whole = MakePolyData(mesh);
  const PieceOfMesh piece = TakePiece(whole, Scattered(), job.Rank(), job.Size());
  const Points moved = PointsOf(Optimized(piece.surface));
  double difference = 0;
  for (Index i = 0; i < whole->GetNumberOfPoints(); ++i)
  {
    const auto found = std::find(piece.points.begin(), piece.points.end(), i);
    for (int axis = 0; axis < 3; ++axis)
    {
      const bool isHere = found != piece.points.end();
      const double x = isHere ? moved(found - piece.points.begin(), axis) : -HUGE_VAL;
      const double y = isHere ? -x : -HUGE_VAL;
      difference = std::max(difference, job.Largest(x) + job.Largest(y));
    }
  }
  c.Error("the ghosts of a point are identical", difference, 0);
}

void CheckSecondExecution(MpiJob& job, Checks& c)
{
  const TestMesh mesh = Irregular(HalfSphere(3), 0.02);
  const auto whole = MakePolyData(mesh);
  PieceOfMesh piece = TakePiece(whole, Sectors(mesh), job.Rank(), job.Size());
  vtkNew<Optimizer> filter;
  filter->SetMode(Optimizer::OPTIMIZE_TRIANGLES);
  filter->SetInputData(piece.surface);
  filter->Update();
  Demanding(filter);
  filter->Update();
  c.Error("other properties take effect",
    job.Largest(DifferenceFromWhole(piece, filter->GetOutput(), OptimizedAlone(whole, Demanding))),
    1e-9);
  const auto larger = MakePolyData(Transformed(mesh, 2));
  if (job.Rank() == job.Size() - 1)
  {
    filter->SetInputData(TakePiece(larger, Sectors(mesh), job.Rank(), job.Size()).surface);
  }
  else
  {
    piece.surface->SetPoints(
      TakePiece(larger, Sectors(mesh), job.Rank(), job.Size()).surface->GetPoints());
  }
  filter->Update();
  c.Error("another input takes effect",
    job.Largest(DifferenceFromWhole(piece, filter->GetOutput(), OptimizedAlone(larger, Demanding))),
    1e-9);
}
}

int TestDistributedInput(int argc, char* argv[])
{
  MpiJob job(argc, argv);
  Checks c;
  CheckCuts(job, c);
  CheckMeshes(job, c);
  CheckCoincidentPoints(job, c);
  CheckNormals(job, c);
  CheckPointData(job, c);
  CheckSeam(job, c);
  CheckEmpty(job, c);
  CheckGhosts(job, c);
  CheckSecondExecution(job, c);
  return c.Result();
}
