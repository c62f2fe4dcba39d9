// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "FilterTesting.h"
#include "MeshMeasures.h"

#include "vtkCellArray.h"
#include "vtkMeshLaplacian.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <Eigen/Geometry>

using namespace lmo;

namespace
{
const std::pair<const char*, int> Arrays[] = { { "UniformLaplacian", 3 },
  { "CotangentLaplacian", 3 }, { "MeanCurvatureNormal", 3 }, { "MeanCurvature", 1 },
  { "GaussianCurvature", 1 }, { "VoronoiArea", 1 }, { "SignedMeanCurvature", 1 },
  { "PrincipalCurvature1", 1 }, { "PrincipalCurvature2", 1 }, { "PrincipalDirection1", 3 },
  { "PrincipalDirection2", 3 } };

vtkSmartPointer<vtkPolyData> WithLaplacians(vtkPolyData* input)
{
  vtkNew<vtkMeshLaplacian> filter;
  filter->SetInputData(input);
  filter->PrincipalCurvaturesOn();
  filter->Update();
  return filter->GetOutput();
}

void CheckSphere(Checks& c)
{
  const double radius = 5;
  const TestMesh sphere = Icosphere(3, radius);
  for (const int type : { VTK_FLOAT, VTK_DOUBLE })
  {
    const auto output = WithLaplacians(MakePolyData(sphere, type));
    c.Error("kappa n of a sphere points inward",
      MaximumDistance(PointValues(output, "MeanCurvatureNormal") * radius, -sphere.V / radius),
      0.02);
    c.Error("kappa of a sphere is 1 / R",
      LargestMagnitude(PointValues(output, "MeanCurvature").array() * radius - 1), 0.02);
    c.Error("Gaussian curvature of a sphere is 1 / R^2",
      LargestMagnitude(PointValues(output, "GaussianCurvature").array() * radius * radius - 1),
      0.02);
    c.Error("Voronoi areas sum to the area",
      std::abs(PointValues(output, "VoronoiArea").sum() / SurfaceArea(sphere) - 1), 1e-6);
    for (const auto& [name, components] : Arrays)
    {
      c.Equal(std::string("arrays are double: ") + name,
        output->GetPointData()->GetArray(name)->GetDataType(), VTK_DOUBLE);
    }
  }
}

void CheckHandDerivedValues(Checks& c)
{
  const auto cross = WithLaplacians(MakePolyData(CrossRing()));
  c.Error("delta_u of the cross is (1/4, -1/4)",
    (PointValues(cross, "UniformLaplacian").row(0) - Vector3(0.25, -0.25, 0)).norm(), 1e-15);
  c.Error(
    "delta_c of the cross is 0", PointValues(cross, "CotangentLaplacian").row(0).norm(), 1e-15);
  const auto cube = WithLaplacians(MakePolyData(Cube()));
  c.Error("delta_c of the cube's corner is (1/3, 1/3, 1/3)",
    (PointValues(cube, "CotangentLaplacian").row(0) - Vector3::Constant(1.0 / 3)).norm(), 1e-15);
  c.Error("kappa n of the cube's corner is (2/3, 2/3, 2/3)",
    (PointValues(cube, "MeanCurvatureNormal").row(0) - Vector3::Constant(2.0 / 3)).norm(), 1e-15);
}

TestMesh Reversed(TestMesh mesh)
{
  mesh.T.col(0).swap(mesh.T.col(1));
  return mesh;
}

/// \param sign 1 where the unit spheres around the origin are convex, else -1
void CheckSignsOnSphere(
  Checks& c, const std::string& name, const TestMesh& mesh, Index points, int sign)
{
  const auto output = WithLaplacians(MakePolyData(mesh));
  for (const char* array : { "SignedMeanCurvature", "PrincipalCurvature1", "PrincipalCurvature2" })
  {
    const Vector values = PointValues(output, array).topRows(points);
    c.Error(name + ": " + array, LargestMagnitude(values.array() - sign), 0.02);
  }
  const Points first = PointValues(output, "PrincipalDirection1");
  const Points second = PointValues(output, "PrincipalDirection2");
  double error = 0;
  for (Index i = 0; i < points; ++i)
  {
    const Vector3 across = Vector3(first.row(i)).cross(Vector3(second.row(i)));
    error = Larger(error, (across - sign * mesh.V.row(i)).norm());
  }
  c.Error(name + ": directions and normal are right-handed", error, 0.02);
}

void CheckSignedCurvatures(Checks& c)
{
  const TestMesh sphere = Icosphere(3);
  const Index size = static_cast<Index>(sphere.V.rows());
  CheckSignsOnSphere(c, "a ball is convex", sphere, size, 1);
  CheckSignsOnSphere(c, "a ball inside out is convex", Reversed(sphere), size, 1);
  const TestMesh bowl = HalfSphere(4);
  const Index bowlSize = static_cast<Index>(bowl.V.rows());
  CheckSignsOnSphere(c, "an open surface is convex seen from outside", bowl, bowlSize, 1);
  CheckSignsOnSphere(
    c, "an open surface is concave seen from inside", Reversed(bowl), bowlSize, -1);
  TestMesh shell{ Points(2 * size, 3), Triangles(2 * sphere.T.rows(), 3) };
  shell.V << sphere.V, 2 * sphere.V;
  shell.T << Reversed(sphere).T, (sphere.T.array() + size).matrix();
  CheckSignsOnSphere(c, "the inner side of a shell is concave", shell, size, -1);
  const auto output = WithLaplacians(MakePolyData(sphere));
  c.Error("the magnitude is the mean curvature",
    LargestMagnitude(
      PointValues(output, "SignedMeanCurvature").cwiseAbs() - PointValues(output, "MeanCurvature")),
    0);
}

void CheckSwitch(Checks& c)
{
  vtkNew<vtkMeshLaplacian> filter;
  filter->SetInputData(MakePolyData(Icosphere(2)));
  filter->Update();
  vtkPointData* data = filter->GetOutput()->GetPointData();
  c.True("without the switch there are no principal curvatures",
    !data->HasArray("PrincipalCurvature1") && !data->HasArray("PrincipalCurvature2") &&
      !data->HasArray("PrincipalDirection1") && !data->HasArray("PrincipalDirection2"));
  c.True("the signed mean curvature is always there", data->HasArray("SignedMeanCurvature"));
}

void CheckMixedCells(Checks& c)
{
  const auto input = MakeMixedPolyData();
  const auto output = WithLaplacians(input);
  const auto withoutStrips = WithLaplacians(MakeMixedPolyDataWithoutStrips());
  c.True("points and cells pass through", AreEqual(output->GetPolys(), input->GetPolys()) &&
                                            AreEqual(output->GetStrips(), input->GetStrips()) &&
                                            PointsOf(output) == PointsOf(input));
  c.True("point data pass through", Contains(output->GetPointData(), input->GetPointData()));
  for (const auto& [name, components] : Arrays)
  {
    const Eigen::MatrixXd values = PointValues(output, name);
    c.True(std::string("there is an array ") + name,
      values.rows() == input->GetNumberOfPoints() && values.cols() == components);
    c.Error(std::string("unused points have 0: ") + name, values.row(169).norm(), 0);
    c.Error(std::string("strips and triangles give the same: ") + name,
      LargestMagnitude(values - PointValues(withoutStrips, name)), 1e-12);
  }
}

void CheckOtherInput(Checks& c)
{
  vtkNew<vtkMeshLaplacian> filter;
  vtkNew<vtkPolyData> nothing;
  filter->SetInputData(nothing);
  c.Equal("an empty input is no error", Update(filter).errors, "");
  c.Equal("an empty input gives an empty output", filter->GetOutput()->GetNumberOfPoints(), 0);

  const auto edges = MakePolyData(Cube());
  edges->GetPolys()->InsertNextCell({ 0, 1 });
  filter->SetInputData(edges);
  c.Says("polygons of two points are an error which names vtkCleanPolyData", Update(filter).errors,
    "vtkCleanPolyData");
  c.True("after an error the output is empty", IsEmpty(filter->GetOutput()));
}
}

int TestMeshLaplacian(int argc, char* argv[])
{
  Groups groups(argc, argv);
  groups.Run("Sphere", CheckSphere);
  groups.Run("HandDerivedValues", CheckHandDerivedValues);
  groups.Run("SignedCurvatures", CheckSignedCurvatures);
  groups.Run("Switch", CheckSwitch);
  groups.Run("MixedCells", CheckMixedCells);
  groups.Run("OtherInput", CheckOtherInput);
  return groups.Result();
}
