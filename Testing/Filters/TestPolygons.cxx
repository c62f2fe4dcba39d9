// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "FilterTesting.h"
#include "MeshMeasures.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdList.h"
#include "vtkIntArray.h"
#include "vtkLaplacianMeshOptimizer.h"
#include "vtkMeshLaplacian.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSurfaceDeviation.h"
#include "vtkTriangleRadiusRatio.h"

#include <cmath>

using namespace lmo;

namespace
{
using Polygon = std::vector<vtkIdType>;

vtkSmartPointer<vtkPolyData> MakePolygons(
  const std::vector<Vector3>& points, const std::vector<Polygon>& polygons)
{
  TestMesh mesh{ Points(points.size(), 3), Triangles(0, 3) };
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    mesh.V.row(i) = points[i];
  }
  auto result = MakePolyData(mesh);
  vtkNew<vtkCellArray> cells;
  for (const Polygon& polygon : polygons)
  {
    cells->InsertNextCell(static_cast<vtkIdType>(polygon.size()), polygon.data());
  }
  result->SetPolys(cells);
  return result;
}

template <typename Filter>
vtkSmartPointer<vtkPolyData> Filtered(vtkPolyData* input)
{
  vtkNew<Filter> filter;
  filter->SetInputData(input);
  filter->Update();
  return filter->GetOutput();
}

/// An L of three unit squares, whose corner 0 is opposite to the notch at (1, 1).
vtkSmartPointer<vtkPolyData> MakeL(const Polygon& corners = { 0, 1, 2, 3, 4, 5 })
{
  return MakePolygons(
    { { 0, 0, 0 }, { 2, 0, 0 }, { 2, 1, 0 }, { 1, 1, 0 }, { 1, 2, 0 }, { 0, 2, 0 } }, { corners });
}

void CheckRadiusRatios(Checks& c)
{
  const double turn = 4 * std::acos(0.0);
  std::vector<Vector3> corners;
  for (int k = 0; k < 5; ++k)
  {
    corners.emplace_back(std::cos(k * turn / 5), std::sin(k * turn / 5), 0);
  }
  corners.emplace_back(2, 0, 0);
  const auto pentagon =
    Filtered<vtkTriangleRadiusRatio>(MakePolygons(corners, { { 0, 1, 2, 3, 4 }, { 0, 5, 1 } }));
  const Eigen::MatrixXd ratios = CellValues(pentagon, "RadiusRatio");
  c.Error("a regular pentagon has the quality 1", std::abs(ratios(0) - 1), 1e-14);
  c.Error("the mean counts a polygon once",
    std::abs(FieldValue(pentagon, "MeanRadiusRatio") - (1 + ratios(1)) / 2), 1e-14);
  c.Error("a point has the minimum over its cells",
    std::abs(PointValues(pentagon, "RadiusRatio")(0) - ratios(1)), 0);

  const auto rectangle = Filtered<vtkTriangleRadiusRatio>(
    MakePolygons({ { 0, 0, 0 }, { 2, 0, 0 }, { 2, 1, 0 }, { 0, 1, 0 } }, { { 0, 1, 2, 3 } }));
  c.Error("a rectangle of 1 x 2 has the quality 4/5",
    std::abs(CellValues(rectangle, "RadiusRatio")(0) - 0.8), 1e-14);
}

void CheckConcavePolygons(Checks& c)
{
  for (vtkIdType first = 0; first < 6; ++first)
  {
    Polygon corners;
    for (vtkIdType k = 0; k < 6; ++k)
    {
      corners.push_back((first + k) % 6);
    }
    const auto output = Filtered<vtkMeshLaplacian>(MakeL(corners));
    c.Error("the triangles of a concave polygon cover it once",
      std::abs(PointValues(output, "VoronoiArea").sum() - 3), 1e-14);
  }
}

void CheckPrincipalCurvatures(Checks& c)
{
  // The saddle z = 0.4 x y has the curvatures 0.4 and -0.4 in its middle, along the diagonals.
  const int cells = 20;
  std::vector<Vector3> corners;
  std::vector<Polygon> quads;
  for (int k = 0; k < (cells + 1) * (cells + 1); ++k)
  {
    const int row = k / (cells + 1), column = k % (cells + 1);
    const double x = 2.0 * column / cells - 1, y = 2.0 * row / cells - 1;
    corners.emplace_back(x, y, 0.4 * x * y);
    if (row < cells && column < cells)
    {
      quads.push_back({ k, k + 1, k + cells + 2, k + cells + 1 });
    }
  }
  vtkNew<vtkMeshLaplacian> filter;
  filter->SetInputData(MakePolygons(corners, quads));
  filter->PrincipalCurvaturesOn();
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  const Index middle = (cells + 2) * cells / 2;
  const double k1 = PointValues(output, "PrincipalCurvature1")(middle);
  const double k2 = PointValues(output, "PrincipalCurvature2")(middle);
  c.Error("quads have the principal curvatures of their surface",
    std::abs(k1 - 0.4) + std::abs(k2 + 0.4), 0.004);
  const Vector3 direction = PointValues(output, "PrincipalDirection1").row(middle);
  c.Error("quads have the principal directions of their surface",
    std::abs(direction.dot(Vector3(1, 1, 0))), 0.01);
}

void CheckDeviation(Checks& c)
{
  vtkNew<vtkSurfaceDeviation> deviation;
  deviation->SetReferenceData(MakeL());
  deviation->SetInputData(MakePolygons(
    { { 1.5, 1.5, 0 }, { 1.5, 1.25, 0 }, { 0.5, 0.5, 2 }, { 0.5, 1.75, 1 } }, { { 1, 2, 3, 0 } }));
  deviation->Update();
  c.Error("the notch of a concave polygon is not part of the surface",
    LargestMagnitude(
      PointValues(deviation->GetOutput(), "Distance") - Eigen::Vector4d(0.5, 0.25, 2, 1)),
    1e-12);
}

/// Sheared quads on a curved patch, or their halves along the shorter diagonals.
vtkSmartPointer<vtkPolyData> MakePatch(bool hasQuads)
{
  constexpr int cells = 10;
  Random random;
  std::vector<Vector3> points;
  std::vector<Polygon> polygons;
  for (int j = 0; j <= cells; ++j)
  {
    for (int i = 0; i <= cells; ++i)
    {
      points.emplace_back(i + 0.5 * j + 0.1 * random(), j + 0.1 * random(), 0.02 * i * i);
      if (i < cells && j < cells)
      {
        const vtkIdType a = j * (cells + 1) + i, b = a + 1, d = a + cells + 1, e = d + 1;
        hasQuads ? polygons.push_back({ a, b, e, d })
                 : (polygons.push_back({ a, b, d }), polygons.push_back({ b, e, d }));
      }
    }
  }
  return MakePolygons(points, polygons);
}

/// The quads of MakePatch() from other first corners.
vtkSmartPointer<vtkPolyData> MakeRotatedPatch()
{
  const auto patch = MakePatch(true);
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < patch->GetNumberOfPolys(); ++cell)
  {
    patch->GetPolys()->GetCellAtId(cell, ids);
    cells->InsertNextCell({ ids->GetId(1), ids->GetId(2), ids->GetId(3), ids->GetId(0) });
  }
  patch->SetPolys(cells);
  return patch;
}

void CheckOptimizer(Checks& c)
{
  const auto quads = MakePatch(true);
  vtkNew<vtkIntArray> numbers;
  numbers->SetName("Number");
  for (int cell = 0; cell < 100; ++cell)
  {
    numbers->InsertNextValue(7 * cell);
  }
  quads->GetCellData()->SetScalars(numbers);
  const auto output = Optimized(quads);
  c.True("quads come out as they came in", AreEqual(output->GetPolys(), quads->GetPolys()));
  c.Equal("cell data come out as they came in", output->GetCellData()->GetScalars(), numbers);
  c.Greater("points of quads move", MaximumDistance(PointsOf(output), PointsOf(quads)), 0.01);
  c.Greater("quads give something else than their triangles",
    MaximumDistance(PointsOf(output), PointsOf(Optimized(MakePatch(false)))), 0.01);
  c.Error("it does not matter with which corner a quad begins",
    MaximumDistance(PointsOf(output), PointsOf(Optimized(MakeRotatedPatch()))), 1e-9);
}

void CheckMixture(Checks& c)
{
  const auto input = MakeMixedPolyData();
  input->GetPolys()->InsertNextCell({ 0, 1, 14, 13 });
  input->GetPointData()->Initialize();
  input->GetCellData()->Initialize();
  const auto output = Filtered<vtkTriangleRadiusRatio>(input);
  const Eigen::MatrixXd ratios = CellValues(output, "RadiusRatio");
  const Eigen::MatrixXd before =
    CellValues(Filtered<vtkTriangleRadiusRatio>(MakeMixedPolyData()), "RadiusRatio");
  c.True("a quad between triangles and strips has a value of its own",
    ratios.rows() == before.rows() + 1 && ratios(147) > 0.5);
  c.Error("triangles and strips around a quad keep theirs",
    Larger(LargestMagnitude(ratios.topRows(147) - before.topRows(147)),
      LargestMagnitude(ratios.bottomRows(6) - before.bottomRows(6))),
    0);
}

void CheckDegeneratePolygons(Checks& c)
{
  const auto flat =
    MakePolygons({ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 3, 0, 0 }, { 4, 0, 0 } },
      { { 0, 1, 2, 3, 4 }, { 0, 1, 0, 1 }, { 2, 2, 2, 2, 2 } });
  vtkNew<vtkLaplacianMeshOptimizer> filter;
  filter->SetMode(vtkLaplacianMeshOptimizer::OPTIMIZE_TRIANGLES);
  filter->SetInputData(flat);
  c.Equal("polygons without area are no error", Update(filter).errors, "");
  c.Error("polygons without area have the radius ratio 0",
    LargestMagnitude(CellValues(filter->GetOutput(), "RadiusRatio")), 0);
  c.True("polygons without area give finite points", PointsOf(filter->GetOutput()).allFinite());
}
}

int TestPolygons(int argc, char* argv[])
{
  Groups groups(argc, argv);
  groups.Run("RadiusRatios", CheckRadiusRatios);
  groups.Run("ConcavePolygons", CheckConcavePolygons);
  groups.Run("PrincipalCurvatures", CheckPrincipalCurvatures);
  groups.Run("Deviation", CheckDeviation);
  groups.Run("Optimizer", CheckOptimizer);
  groups.Run("Mixture", CheckMixture);
  groups.Run("DegeneratePolygons", CheckDegeneratePolygons);
  return groups.Result();
}
