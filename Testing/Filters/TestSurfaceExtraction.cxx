// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause

// Surfaces in data sets of other types than vtkPolyData.
#include "Checks.h"
#include "FilterTesting.h"
#include "MeshMeasures.h"

#include "vtkAppendFilter.h"
#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkLaplacianMeshOptimizer.h"
#include "vtkMeshLaplacian.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkSurfaceDeviation.h"
#include "vtkTriangleRadiusRatio.h"
#include "vtkUnstructuredGrid.h"

using namespace lmo;

namespace
{
using Optimizer = vtkLaplacianMeshOptimizer;

TestMesh Mesh()
{
  return WithThinTriangles(Icosphere(2), 7, 0.7);
}

vtkSmartPointer<vtkUnstructuredGrid> AsGrid(const TestMesh& mesh)
{
  const auto surface = MakePolyData(mesh);
  AddPointArray(surface, "Field", mesh.V.col(0));
  vtkNew<vtkAppendFilter> append;
  append->AddInputData(surface);
  append->Update();
  return append->GetOutput();
}

/// The points of the surface of a grid in the order of the grid's.
Points InOrderOfGrid(vtkPolyData* surface)
{
  auto* ids =
    vtkIdTypeArray::SafeDownCast(surface->GetPointData()->GetArray("vtkOriginalPointIds"));
  const Points V = PointsOf(surface);
  Points ordered(V.rows(), 3);
  for (Eigen::Index i = 0; i < V.rows(); ++i)
  {
    ordered.row(ids->GetValue(i)) = V.row(i);
  }
  return ordered;
}

void CheckGrid(Checks& c)
{
  const auto grid = AsGrid(Mesh());
  vtkNew<Optimizer> filter;
  filter->SetMode(Optimizer::SMOOTH);
  filter->SetInputData(grid);
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  const auto expected =
    Optimized(MakePolyData(Mesh()), [](Optimizer* other) { other->SetMode(Optimizer::SMOOTH); });
  c.Error("a surface in a grid moves as one in a vtkPolyData",
    MaximumDistance(InOrderOfGrid(output), PointsOf(expected)), 1e-5);
  c.True("its point data come with it", output->GetPointData()->HasArray("Field"));
  c.True("so do the ids of its cells", output->GetCellData()->HasArray("vtkOriginalCellIds"));
  filter->SetScaleFactor(0.5);
  filter->Update();
  c.Equal("it is extracted once", filter->GetOutput()->GetNumberOfPoints(), 162);
}

void CheckSelection(Checks& c)
{
  const auto selection = Selection({ SelectionNode(vtkSelectionNode::POINT, { 17 }) });
  vtkNew<Optimizer> filter;
  filter->SetMode(Optimizer::SMOOTH);
  filter->SetInputData(AsGrid(Mesh()));
  filter->SetSelectionData(selection);
  filter->Update();
  const Points moved = InOrderOfGrid(filter->GetOutput());
  c.Equal("a selected point of a grid stays", moved.row(17), Mesh().V.row(17));
  c.Different("others do not", moved.row(18), Mesh().V.row(18));
}

void CheckVolume(Checks& c)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(4, 4, 4);
  vtkNew<vtkTriangleRadiusRatio> quality;
  quality->SetInputData(image);
  quality->Update();
  c.Equal("a volume has its outer surface", quality->GetOutput()->GetNumberOfCells(), 54);
  c.Equal("whose quads are square", FieldValue(quality->GetOutput(), "MinimumRadiusRatio"), 1);
}

void CheckOtherFilters(Checks& c)
{
  const auto grid = AsGrid(Mesh());
  vtkNew<vtkMeshLaplacian> laplacian;
  laplacian->SetInputData(grid);
  laplacian->Update();
  c.Equal("the Laplacians of a surface in a grid",
    PointValues(laplacian->GetOutput(), "UniformLaplacian").rows(), 162);
  vtkNew<vtkSurfaceDeviation> deviation;
  deviation->SetInputData(grid);
  deviation->SetReferenceData(grid);
  deviation->Update();
  c.Error("a grid's distance to itself is 0", deviation->GetHausdorffDistance(), 1e-12);
}
}

int TestSurfaceExtraction(int argc, char* argv[])
{
  Groups groups(argc, argv);
  groups.Run("Grid", CheckGrid);
  groups.Run("Selection", CheckSelection);
  groups.Run("Volume", CheckVolume);
  groups.Run("OtherFilters", CheckOtherFilters);
  return groups.Result();
}
