// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FuzzInput.h"

#include "../Filters/FilterTesting.h"

#include "vtkCellArray.h"
#include "vtkDataObject.h"
#include "vtkIdList.h"
#include "vtkLaplacianMeshOptimizer.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <cmath>
#include <limits>

using namespace lmo;

namespace
{
TestMesh BaseMesh(FuzzBytes& bytes)
{
  switch (bytes.Take(10))
  {
    case 0:
      return { Points(0, 3), Triangles(0, 3) };
    case 1:
      return { Random().Displacements(bytes.Take(12)), Triangles(0, 3) };
    case 2:
      return EquilateralTriangle();
    case 3:
      return Tetrahedron();
    case 4:
      return Cube();
    case 5:
      return Grid(4, 0.3);
    case 6:
      return ThreeWings();
    case 7:
      return TwoComponents();
    case 8:
      return HalfSphere(1);
    default:
      return Icosphere(1);
  }
}

vtkIdType TakeId(FuzzBytes& bytes, vtkIdType points)
{
  const int id = bytes.Take(256);
  if (id == 255)
  {
    return vtkIdType(1) << 32;
  }
  return id % (points + 2) - (id == 254 ? 1 : 0);
}

void AddCells(FuzzBytes& bytes, vtkPolyData* mesh)
{
  vtkNew<vtkCellArray> extra[3];
  for (int k = bytes.Take(8); k > 0; --k)
  {
    const int kind = bytes.Take(4);
    vtkNew<vtkIdList> ids;
    for (int size = kind == 0 ? 3 : bytes.Take(7); size > 0; --size)
    {
      ids->InsertNextId(TakeId(bytes, mesh->GetNumberOfPoints()));
    }
    (kind <= 1 ? mesh->GetPolys() : extra[kind - 1].Get())->InsertNextCell(ids);
  }
  mesh->SetLines(extra[1]);
  mesh->SetStrips(extra[2]);
}

/// Most often of the right size.
void AddArray(FuzzBytes& bytes, vtkPolyData* mesh, const char* name, int components)
{
  const int fault = bytes.Take(64);
  const Eigen::Index rows = mesh->GetNumberOfPoints() + (fault == 1);
  Eigen::MatrixXd values(rows, components + (fault == 2));
  for (Eigen::Index k = 0; k < values.size(); ++k)
  {
    const double number = bytes.Number();
    values.data()[k] = components == 1 && fault > 3 ? std::abs(number) : number;
  }
  if (fault != 3)
  {
    AddPointArray(mesh, name, values);
  }
}
}

double FuzzBytes::Number()
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr double rare[] = { std::numeric_limits<double>::quiet_NaN(), infinity, -infinity, 1e300,
    -1e300, 1e80, 1e69, 1e30, 1e20, -1e8, 1e-8, 1e-30, 1e-80, 1e-300 };
  const int byte = this->Byte();
  if (byte < 250)
  {
    return (byte - 125) / 32.0;
  }
  return byte == 250 ? rare[this->Take(14)]
                     : (this->Byte() - 128) * std::pow(2.0, 4 * (byte - 255));
}

vtkSmartPointer<vtkPolyData> MakeFuzzMesh(FuzzBytes& bytes)
{
  const TestMesh base = BaseMesh(bytes);
  const int types[] = { VTK_DOUBLE, VTK_FLOAT, VTK_INT };
  auto mesh = MakePolyData(base, types[bytes.Take(3)]);
  for (int k = base.V.rows() > 0 ? bytes.Take(8) : 0; k > 0; --k)
  {
    const int point = bytes.Take(static_cast<int>(base.V.rows()));
    const double x = bytes.Number();
    const double y = bytes.Number();
    mesh->GetPoints()->SetPoint(point, x, y, bytes.Number());
  }
  AddCells(bytes, mesh);
  AddArray(bytes, mesh, "Weights", 1);
  AddArray(bytes, mesh, "Vectors", 3);
  return mesh;
}

namespace
{
/// The modes with several steps and what belongs to them; off when the bytes are used up.
void SetUpSteps(vtkLaplacianMeshOptimizer* filter, FuzzBytes& bytes)
{
  const int mode = bytes.Take(8);
  if (mode > 4)
  {
    filter->SetMode(mode == 7 ? vtkLaplacianMeshOptimizer::SMOOTH_GUIDED
                              : vtkLaplacianMeshOptimizer::OPTIMIZE_WITHIN_DEVIATION);
  }
  filter->SetMaximumDeviation(std::pow(10.0, -bytes.Take(16)));
  filter->SetNumberOfPasses(1 + bytes.Take(8));
  filter->SetImproveWorstTriangles(bytes.Take(2));
  filter->SetFeatureConstraints(bytes.Take(2));
  filter->SetDetectFeatures(bytes.Take(2));
  filter->SetFeatureAngle(bytes.Take(182));
  filter->SetNormalIterations(bytes.Take(32));
  filter->SetNormalWidth(std::abs(bytes.Number()));
  filter->SetDetailWeight(std::abs(bytes.Number()));
  filter->SetPreserveVolume(bytes.Take(2));
  filter->SetTwicing(bytes.Take(2));
}
}

void SetUp(vtkLaplacianMeshOptimizer* filter, FuzzBytes& bytes)
{
  // One of many values is out of range.
  const auto take = [&](int count)
  {
    const int byte = bytes.Take(256);
    return byte == 255 ? -1 : byte == 254 ? count : byte % count;
  };
  filter->SetMode(take(3));
  filter->SetLaplacianType(take(3));
  filter->SetRobustLaplacian(bytes.Take(2));
  filter->SetPositionWeighting(take(5));
  filter->SetLaplacianWeighting(take(5));
  filter->SetBoundaryCondition(take(3));
  filter->SetSolverType(take(3));
  filter->SetModulateByTriangleQuality(bytes.Take(2));
  filter->SetTangentPlaneConstraints(bytes.Take(2));
  filter->SetComputeNormals(bytes.Take(2));
  filter->SetScaleFactor(std::abs(bytes.Number()));
  filter->SetGaussianWidth(std::abs(bytes.Number()));
  filter->SetTangentPlaneWeight(std::abs(bytes.Number()));
  filter->SetTolerance(std::pow(10.0, -bytes.Take(16)) / 2);
  filter->SetMaximumNumberOfIterations(4 * bytes.Take(256));
  const auto choose = [&](int index, const char* name)
  {
    filter->SetInputArrayToProcess(
      index, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, bytes.Take(16) == 0 ? "None" : name);
  };
  choose(vtkLaplacianMeshOptimizer::POSITION_WEIGHT_ARRAY, "Weights");
  choose(vtkLaplacianMeshOptimizer::LAPLACIAN_WEIGHT_ARRAY, "Weights");
  choose(vtkLaplacianMeshOptimizer::PRESCRIBED_LAPLACIAN_ARRAY, "Vectors");
  if (bytes.Take(4) == 0)
  {
    choose(vtkLaplacianMeshOptimizer::FIXED_POINT_ARRAY, "Weights");
  }
  if (bytes.Take(4) == 1)
  {
    choose(vtkLaplacianMeshOptimizer::FEATURE_ARRAY, "Weights");
  }
  SetUpSteps(filter, bytes);
}
