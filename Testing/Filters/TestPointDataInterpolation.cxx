// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "FilterTesting.h"
#include "MeshMeasures.h"

#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkLaplacianMeshOptimizer.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <string>

using namespace lmo;

namespace
{
using Optimizer = vtkLaplacianMeshOptimizer;

constexpr int Modes[] = { Optimizer::OPTIMIZE_TRIANGLES, Optimizer::OPTIMIZE_WITHIN_DEVIATION };

std::string InMode(int mode)
{
  return mode == Optimizer::OPTIMIZE_TRIANGLES ? ", with OPTIMIZE_TRIANGLES"
                                               : ", within a deviation";
}

vtkSmartPointer<vtkPolyData> Optimized(
  vtkPolyData* input, int mode, int boundary = Optimizer::FIXED, bool isInterpolated = true)
{
  vtkNew<Optimizer> filter;
  filter->SetInputData(input);
  filter->SetMode(mode);
  filter->SetMaximumDeviation(0.05);
  filter->SetBoundaryCondition(boundary);
  filter->SetInterpolatePointData(isInterpolated);
  filter->Update();
  return filter->GetOutput();
}

/// 2 x - 3 y + z + 1
Vector LinearField(const Points& V)
{
  return (V * Eigen::Vector3d(2, -3, 1)).array() + 1;
}

/// A flat square whose points move far, with the linear field.
vtkSmartPointer<vtkPolyData> FlatInput()
{
  const TestMesh mesh = WithThinTriangles(Grid(16, 0.4), 5, 0.8);
  auto input = MakePolyData(mesh);
  AddPointArray(input, "Field", LinearField(mesh.V));
  return input;
}

double LinearFieldError(int mode, int boundary)
{
  const auto output = Optimized(FlatInput(), mode, boundary);
  return LargestMagnitude(PointValues(output, "Field") - LinearField(PointsOf(output)));
}

/// Error of a quadratic field on the flat square, in terms of that of the values before.
double QuadraticFieldError(int mode)
{
  const auto quadratic = [](const Points& V) -> Vector
  { return V.col(0).array() * V.col(0).array() - 2 * V.col(0).array() * V.col(1).array(); };
  auto input = FlatInput();
  AddPointArray(input, "Quadratic", quadratic(PointsOf(input)));
  const auto output = Optimized(input, mode);
  const Vector expected = quadratic(PointsOf(output));
  const double error = (PointValues(output, "Quadratic") - expected).cwiseAbs().mean();
  return error / (PointValues(input, "Quadratic") - expected).cwiseAbs().mean();
}

/// How far the points of FlatInput() move.
double FlatDisplacement(int mode)
{
  return LargestMagnitude(PointValues(Optimized(FlatInput(), mode), "Displacement"));
}

/// How far the field's values leave the range that they had.
double RangeError(int mode)
{
  const TestMesh mesh = WithThinTriangles(Icosphere(3), 7, 0.8);
  auto input = MakePolyData(mesh);
  const Vector values = 0.1 * (mesh.V.col(0).array() > 0.3).cast<double>() + 0.1;
  AddPointArray(input, "Field", values);
  const Eigen::MatrixXd result = PointValues(Optimized(input, mode), "Field");
  return Larger(result.maxCoeff() - values.maxCoeff(), values.minCoeff() - result.minCoeff());
}

/// Largest deviation of the result's normals from those of the unit sphere.
double NormalError(int mode)
{
  const TestMesh mesh = WithThinTriangles(Icosphere(3), 7, 0.8);
  auto input = MakePolyData(mesh);
  AddPointArray(input, "Normals", mesh.V.rowwise().normalized());
  input->GetPointData()->SetActiveNormals("Normals");
  const auto output = Optimized(input, mode);
  const Points V = PointsOf(output);
  return LargestMagnitude(PointValues(output, "Normals") - V.rowwise().normalized());
}

double NormalLengthError(int mode)
{
  const TestMesh mesh = WithThinTriangles(Icosphere(2), 7, 0.8);
  auto input = MakePolyData(mesh);
  AddPointArray(input, "Normals", mesh.V.rowwise().normalized());
  input->GetPointData()->SetActiveNormals("Normals");
  const Eigen::MatrixXd normals = PointValues(Optimized(input, mode), "Normals");
  return LargestMagnitude(normals.rowwise().norm().array() - 1);
}

/// Integers that say which half of the square a point lies in: the number of points whose value is
/// not that of the corner closest to them in their triangle.
vtkSmartPointer<vtkPolyData> WithAllKinds()
{
  auto input = FlatInput();
  const vtkIdType points = input->GetNumberOfPoints();
  vtkNew<vtkIntArray> label;
  label->SetName("Label");
  vtkNew<vtkStringArray> text;
  text->SetName("Text");
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("Ids");
  vtkNew<vtkIdTypeArray> original;
  original->SetName("vtkOriginalPointIds");
  vtkNew<vtkUnsignedCharArray> colour;
  colour->SetName("Colour");
  colour->SetNumberOfComponents(3);
  const Points V = PointsOf(input);
  for (vtkIdType i = 0; i < points; ++i)
  {
    label->InsertNextValue(V(i, 0) < 8 ? 10 : 20);
    text->InsertNextValue(V(i, 0) < 8 ? "left" : "right");
    ids->InsertNextValue(100 + i);
    original->InsertNextValue(200 + i);
    colour->InsertNextTuple3(std::round(10 * V(i, 0)), std::round(10 * V(i, 1)), 7);
  }
  vtkPointData* data = input->GetPointData();
  data->AddArray(label);
  data->AddArray(text);
  data->SetGlobalIds(ids);
  data->AddArray(original);
  data->AddArray(colour);
  return input;
}

/// The number of points more than an edge away from the boundary between the halves that have the
/// label of the other one.
int WrongLabels(vtkPolyData* output)
{
  const Points V = PointsOf(output);
  const Eigen::MatrixXd labels = PointValues(output, "Label");
  auto* text = vtkStringArray::SafeDownCast(output->GetPointData()->GetAbstractArray("Text"));
  int wrong = 0;
  for (Index i = 0; i < V.rows(); ++i)
  {
    const bool isLeft = V(i, 0) < 8;
    const bool isRight =
      labels(i, 0) == (isLeft ? 10 : 20) && text->GetValue(i) == (isLeft ? "left" : "right");
    wrong += std::abs(V(i, 0) - 8) > 2 && !isRight;
  }
  return wrong;
}

/// The number of values that are neither label.
int MixedLabels(vtkPolyData* output)
{
  const Eigen::MatrixXd labels = PointValues(output, "Label");
  return static_cast<int>((labels.array() != 10 && labels.array() != 20).count());
}

double IdError(vtkPolyData* input, vtkPolyData* output)
{
  return Larger(LargestMagnitude(PointValues(output, "Ids") - PointValues(input, "Ids")),
    LargestMagnitude(
      PointValues(output, "vtkOriginalPointIds") - PointValues(input, "vtkOriginalPointIds")));
}

double ColourError(vtkPolyData* output)
{
  const Points V = PointsOf(output);
  const Eigen::MatrixXd colour = PointValues(output, "Colour");
  return Larger(LargestMagnitude(colour.leftCols(2) - 10 * V.leftCols(2)),
    LargestMagnitude(colour.col(2).array() - 7));
}

/// Two halves of a square with points of their own where they meet, and a coordinate that jumps
/// there from 0 to 1: the largest distance of a value from both.
double SeamError(int mode)
{
  const TestMesh left = Grid(8, 0);
  const auto size = static_cast<Index>(left.V.rows());
  TestMesh both;
  both.V.resize(2 * size, 3);
  both.V << left.V, left.V.rowwise() + Vector3(8, 0, 0);
  both.T.resize(2 * left.T.rows(), 3);
  both.T << left.T, (left.T.array() + size).matrix();
  const Points noise = Random().Displacements(2 * size);
  for (Index i = 0; i < 2 * size; ++i)
  {
    const Vector3 x = both.V.row(i);
    const bool isInside = x[0] > 0 && x[0] < 16 && x[1] > 0 && x[1] < 8 && x[0] != 8;
    both.V.row(i) += isInside ? Vector3(0.4 * noise(i, 0), 0.4 * noise(i, 1), 0) : Vector3(0, 0, 0);
    if (x[0] == 8 && x[1] > 0 && x[1] < 8)
    {
      both.V.row(i) += Vector3(0.3 * std::sin(5 * x[1]), 0.3 * std::cos(3 * x[1]), 0);
    }
  }
  auto input = MakePolyData(both);
  Vector side = Vector::Zero(2 * size);
  side.tail(size).setOnes();
  AddPointArray(input, "Side", side);
  return LargestMagnitude(PointValues(Optimized(input, mode), "Side") - side);
}

void CheckFields(Checks& c, int mode)
{
  const std::string inMode = InMode(mode);
  c.Error("points move so that a field would be torn" + inMode, -FlatDisplacement(mode), -0.2);
  c.Error("a linear field on a plane stays linear" + inMode,
    LinearFieldError(mode, Optimizer::FIXED), 1e-12);
  c.Error("a linear field stays linear with a sliding boundary" + inMode,
    LinearFieldError(mode, Optimizer::SLIDING), 1e-12);
  c.Error(
    "a quadratic field on a plane is off by a small part of what it would be off by" + InMode(mode),
    QuadraticFieldError(mode), 0.05);
  c.Error("a field stays in its range" + inMode, RangeError(mode), 0);
  c.Error("normals are interpolated" + inMode, NormalError(mode), 0.02);
  c.Error("normals have unit length" + inMode, NormalLengthError(mode), 1e-12);
  c.Error("values stay on their side of a seam" + inMode, SeamError(mode), 0);
}
}

int TestPointDataInterpolation(int, char*[])
{
  Checks c;
  for (const int mode : Modes)
  {
    CheckFields(c, mode);
    const auto input = WithAllKinds();
    const auto output = Optimized(input, mode);
    const std::string inMode = InMode(mode);
    c.Error("labels and texts are those of the place" + inMode, WrongLabels(output), 0);
    c.Error("labels are not mixed" + inMode, MixedLabels(output), 0);
    c.Error("ids stay with their points" + inMode, IdError(input, output), 0);
    c.Error("colours are interpolated" + inMode, ColourError(output), 1);
  }
  const auto input = FlatInput();
  const auto output = Optimized(input, Optimizer::OPTIMIZE_TRIANGLES, Optimizer::FIXED, false);
  c.Error("without InterpolatePointData the values stay with their points",
    LargestMagnitude(PointValues(output, "Field") - PointValues(input, "Field")), 0);
  return c.Result();
}
