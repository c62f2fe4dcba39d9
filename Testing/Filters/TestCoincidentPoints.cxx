// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "FilterTesting.h"
#include "MeshMeasures.h"

#include "vtkLaplacianMeshOptimizer.h"
#include "vtkMeshLaplacian.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTriangleRadiusRatio.h"

#include <Eigen/Geometry>

#include <cmath>
#include <vector>

using namespace lmo;

namespace
{
using Optimizer = vtkLaplacianMeshOptimizer;

/// The mesh with its vertices in the order of the triangles' corners, in which the points of a soup
/// become vertices: solutions depend on the order by as much as the solver's tolerance.
TestMesh InOrderOfCorners(const TestMesh& mesh)
{
  TestMesh result = mesh;
  std::vector<Index> numbers(mesh.V.rows(), -1);
  Index next = 0;
  for (Eigen::Index corner = 0; corner < mesh.T.size(); ++corner)
  {
    const Index i = mesh.T.data()[corner];
    if (numbers[i] < 0)
    {
      numbers[i] = next++;
      result.V.row(numbers[i]) = mesh.V.row(i);
    }
    result.T.data()[corner] = numbers[i];
  }
  return result;
}

/// Rows at the points of Soup() from rows at the vertices.
Eigen::MatrixXd AtCorners(const TestMesh& mesh, const Eigen::MatrixXd& rows)
{
  Eigen::MatrixXd result(3 * mesh.T.rows(), rows.cols());
  for (Index corner = 0; corner < result.rows(); ++corner)
  {
    result.row(corner) = rows.row(mesh.T.data()[corner]);
  }
  return result;
}

vtkSmartPointer<vtkPolyData> Optimized(
  vtkPolyData* input, int mode, bool isWelded = true, int boundary = Optimizer::FIXED)
{
  vtkNew<Optimizer> filter;
  filter->SetInputData(input);
  filter->SetMode(mode);
  filter->SetPositionWeighting(Optimizer::CONSTANT);
  filter->SetScaleFactor(0.1);
  filter->SetBoundaryCondition(boundary);
  filter->SetWeldCoincidentPoints(isWelded);
  filter->ImproveWorstTrianglesOff(); // its choices follow from round-off
  filter->Update();
  return filter->GetOutput();
}

double LeastRadiusRatio(vtkPolyData* input)
{
  vtkNew<Optimizer> filter;
  filter->SetInputData(input);
  filter->Update();
  return filter->GetMinimumRadiusRatio();
}

/// The largest distance of a soup's points from those of the mesh, both optimized.
double SoupError(const TestMesh& mesh, int mode)
{
  const Points expected = PointsOf(Optimized(MakePolyData(mesh), mode));
  const Points found = PointsOf(Optimized(MakePolyData(Soup(mesh)), mode));
  return MaximumDistance(found, AtCorners(mesh, expected));
}

/// The largest change of a soup's points if none are welded.
double UnweldedChange(const TestMesh& mesh)
{
  const TestMesh soup = Soup(mesh);
  return MaximumDistance(PointsOf(Optimized(MakePolyData(soup), Optimizer::SMOOTH, false)), soup.V);
}

/// Two spheres that touch with a point of the first at a point of the second.
TestMesh TouchingSpheres()
{
  const TestMesh sphere = Icosphere(2);
  const auto size = static_cast<Index>(sphere.V.rows());
  Index left = 0;
  Index right = 0;
  sphere.V.col(0).minCoeff(&left);
  sphere.V.col(0).maxCoeff(&right);
  TestMesh both;
  both.V.resize(2 * size, 3);
  both.V << sphere.V, sphere.V.rowwise() + (sphere.V.row(right) - sphere.V.row(left));
  both.V.row(size + left) = both.V.row(right);
  both.T.resize(2 * sphere.T.rows(), 3);
  both.T << sphere.T, (sphere.T.array() + size).matrix();
  return both;
}

/// How far welding changes the result for a surface without boundary.
double ClosedSurfaceError(const TestMesh& mesh)
{
  const auto input = MakePolyData(mesh);
  return MaximumDistance(PointsOf(Optimized(input, Optimizer::SMOOTH, true)),
    PointsOf(Optimized(input, Optimizer::SMOOTH, false)));
}

/// Difference of an array of vtkMeshLaplacian between a soup and the mesh.
double LaplacianError(const TestMesh& mesh, const char* name)
{
  const auto values = [&](const TestMesh& input)
  {
    vtkNew<vtkMeshLaplacian> filter;
    filter->SetInputData(MakePolyData(input));
    filter->PrincipalCurvaturesOn();
    filter->Update();
    return PointValues(filter->GetOutput(), name);
  };
  return LargestMagnitude(values(Soup(mesh)) - AtCorners(mesh, values(mesh)));
}

/// Difference of the radius ratios at the points between a soup and the mesh.
double RadiusRatioError(const TestMesh& mesh)
{
  const auto values = [&](const TestMesh& input)
  {
    vtkNew<vtkTriangleRadiusRatio> filter;
    filter->SetInputData(MakePolyData(input));
    filter->Update();
    return PointValues(filter->GetOutput(), "RadiusRatio");
  };
  return LargestMagnitude(values(Soup(mesh)) - AtCorners(mesh, values(mesh)));
}

/// A soup of which one point of one triangle is fixed: the displacement of the points there.
double FixedCornerError(const TestMesh& mesh)
{
  const TestMesh soup = Soup(mesh);
  const auto input = MakePolyData(soup);
  Vector isFixed = Vector::Zero(soup.V.rows());
  isFixed[7] = 1;
  AddPointArray(input, "Fixed", isFixed);
  vtkNew<Optimizer> filter;
  filter->SetInputData(input);
  filter->SetMode(Optimizer::SMOOTH);
  filter->SetInputArrayToProcess(Optimizer::FIXED_POINT_ARRAY, 0, 0, 0, "Fixed");
  filter->Update();
  const Points V = PointsOf(filter->GetOutput());
  double error = 0;
  for (Index i = 0; i < V.rows(); ++i)
  {
    if (soup.V.row(i) == soup.V.row(7))
    {
      error = Larger(error, (V.row(i) - soup.V.row(i)).norm());
    }
  }
  return error;
}

/// A cube whose triangles have points of their own with the normals of the faces, which stay flat:
/// how far the normals of the points are from those of the faces afterwards.
double SharpNormalError()
{
  const TestMesh cube = Cube(3);
  const TestMesh soup = Soup(cube);
  Points normals(soup.V.rows(), 3);
  for (Index t = 0; t < soup.T.rows(); ++t)
  {
    const Vector3 a = soup.V.row(3 * t);
    const Vector3 normal =
      (Vector3(soup.V.row(3 * t + 1)) - a).cross(Vector3(soup.V.row(3 * t + 2)) - a).normalized();
    normals.middleRows(3 * t, 3).rowwise() = normal;
  }
  const auto input = MakePolyData(soup);
  AddPointArray(input, "Normals", normals);
  input->GetPointData()->SetActiveNormals("Normals");
  vtkNew<Optimizer> filter;
  filter->SetInputData(input);
  filter->SetMode(Optimizer::OPTIMIZE_TRIANGLES);
  filter->SetInterpolatePointData(false);
  filter->SetFeatureConstraints(true);
  filter->Update();
  return LargestMagnitude(PointValues(filter->GetOutput(), "Normals") - normals);
}
}

int TestCoincidentPoints(int, char*[])
{
  Checks c;
  const TestMesh mesh = InOrderOfCorners(Irregular(Icosphere(2), 0.05));
  const std::pair<const char*, int> modes[] = { { "optimized", Optimizer::OPTIMIZE_TRIANGLES },
    { "smoothed", Optimizer::SMOOTH }, { "guided", Optimizer::SMOOTH_GUIDED },
    { "optimized within a deviation", Optimizer::OPTIMIZE_WITHIN_DEVIATION } };
  for (const auto& [name, mode] : modes)
  {
    c.Error(
      std::string("a soup is ") + name + " as the connected mesh is", SoupError(mesh, mode), 1e-6);
  }
  c.Error("the worst triangles of a soup become as good as those of the connected mesh",
    std::abs(LeastRadiusRatio(MakePolyData(Soup(mesh))) - LeastRadiusRatio(MakePolyData(mesh))),
    0.02);
  c.Error("without welding a soup is all boundary", UnweldedChange(mesh), 0);
  c.Error("closed surfaces that touch stay two", ClosedSurfaceError(TouchingSpheres()), 0);
  for (const char* name : { "UniformLaplacian", "CotangentLaplacian", "MeanCurvature",
         "VoronoiArea", "SignedMeanCurvature", "PrincipalCurvature1", "PrincipalCurvature2" })
  {
    c.Error(std::string("a soup has the mesh's ") + name, LaplacianError(mesh, name), 1e-9);
  }
  c.Error("a soup has the mesh's radius ratios at its points", RadiusRatioError(mesh), 1e-12);
  c.Error("a vertex is fixed if one of its points is", FixedCornerError(mesh), 0);
  c.Error("normals beside a sharp edge stay those of their faces", SharpNormalError(), 1e-6);
  return c.Result();
}
