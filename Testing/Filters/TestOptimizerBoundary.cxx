// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "FilterTesting.h"
#include "MeshMeasures.h"

#include "vtkCellArray.h"
#include "vtkFeatureEdges.h"
#include "vtkIdList.h"
#include "vtkLaplacianMeshOptimizer.h"
#include "vtkLine.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <cmath>
#include <limits>

using namespace lmo;

namespace
{
using Optimizer = vtkLaplacianMeshOptimizer;

vtkSmartPointer<vtkPolyData> BoundaryOf(vtkPolyData* mesh)
{
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(mesh);
  edges->FeatureEdgesOff();
  edges->NonManifoldEdgesOff();
  edges->ManifoldEdgesOff();
  edges->BoundaryEdgesOn();
  edges->Update();
  return edges->GetOutput();
}

double DistanceToEdges(vtkPolyData* edges, const Vector3& point)
{
  double least = std::numeric_limits<double>::infinity();
  vtkNew<vtkIdList> ends;
  for (vtkIdType k = 0; k < edges->GetNumberOfLines(); ++k)
  {
    edges->GetLines()->GetCellAtId(k, ends);
    double a[3], b[3], closest[3], t = 0;
    edges->GetPoint(ends->GetId(0), a);
    edges->GetPoint(ends->GetId(1), b);
    least = std::min(least, vtkLine::DistanceToLine(point.data(), a, b, t, closest));
  }
  return std::sqrt(least);
}

/// How far the points on the boundary are from it afterwards, and how far they moved.
struct BoundaryDisplacement
{
  double offBoundary = 0;
  double moved = 0;
};

BoundaryDisplacement MeasureBoundary(vtkPolyData* input, vtkPolyData* output)
{
  const auto boundary = BoundaryOf(input);
  const Points before = PointsOf(input);
  const Points after = PointsOf(output);
  BoundaryDisplacement displacement;
  for (Eigen::Index i = 0; i < before.rows(); ++i)
  {
    if (DistanceToEdges(boundary, before.row(i)) == 0)
    {
      displacement.offBoundary =
        Larger(displacement.offBoundary, DistanceToEdges(boundary, after.row(i)));
      displacement.moved = Larger(displacement.moved, (after.row(i) - before.row(i)).norm());
    }
  }
  return displacement;
}

vtkSmartPointer<vtkPolyData> Smoothed(vtkPolyData* input, int boundaryCondition)
{
  return Optimized(input,
    [=](Optimizer* filter)
    {
      filter->SetMode(Optimizer::SMOOTH);
      filter->SetPositionWeighting(Optimizer::CONSTANT);
      filter->SetScaleFactor(0.3);
      filter->SetBoundaryCondition(boundaryCondition);
    });
}

void CheckConditions(Checks& c)
{
  const auto input = MakePolyData(Irregular(CylinderPatch(2), 0.05));
  const auto fixed = Smoothed(input, Optimizer::FIXED);
  c.Error("FIXED: the boundary does not move", MeasureBoundary(input, fixed).moved, 0);
  c.Greater("FIXED: inner points move", MaximumDistance(PointsOf(fixed), PointsOf(input)), 0.01);

  const auto sliding = Smoothed(input, Optimizer::SLIDING);
  c.Error("SLIDING: boundary points stay on the boundary",
    MeasureBoundary(input, sliding).offBoundary, 1e-6);
  c.Greater("SLIDING: boundary points move", MeasureBoundary(input, sliding).moved, 0.01);
  double cornerDisplacement = 0;
  for (const int corner : { 0, 12, 156, 168 })
  {
    cornerDisplacement =
      Larger(cornerDisplacement, (PointsOf(sliding) - PointsOf(input)).row(corner).norm());
  }
  c.Error("SLIDING: corners of the boundary do not move", cornerDisplacement, 0);

  const auto free = Smoothed(input, Optimizer::FREE);
  c.Greater(
    "FREE: boundary points leave the boundary", MeasureBoundary(input, free).offBoundary, 0.01);
}

/// The triangles whose centre is above, or is not above, z = 0.2; the points stay all.
TestMesh Half(const TestMesh& mesh, bool isUpper)
{
  TestMesh half{ mesh.V, Triangles(mesh.T.rows(), 3) };
  Eigen::Index count = 0;
  for (const auto& T : mesh.T.rowwise())
  {
    const double z = mesh.V(T, 2).mean();
    if ((z > 0.2) == isUpper)
    {
      half.T.row(count++) = T;
    }
  }
  half.T.conservativeResize(count, 3);
  return half;
}

/// The largest distance between what two pieces make of a point that both of them use.
double Gap(int boundaryCondition)
{
  const TestMesh mesh = Irregular(Icosphere(3), 0.02);
  const TestMesh pieces[] = { Half(mesh, false), Half(mesh, true) };
  Points after[2];
  Eigen::VectorXi uses = Eigen::VectorXi::Zero(mesh.V.rows());
  for (int k = 0; k < 2; ++k)
  {
    after[k] = PointsOf(Smoothed(MakePolyData(pieces[k]), boundaryCondition));
    for (Eigen::Index corner = 0; corner < pieces[k].T.size(); ++corner)
    {
      uses[pieces[k].T.data()[corner]] |= k + 1;
    }
  }
  double gap = 0;
  for (Eigen::Index i = 0; i < uses.size(); ++i)
  {
    gap = uses[i] == 3 ? Larger(gap, (after[0] - after[1]).row(i).norm()) : gap;
  }
  return gap;
}

void CheckPieces(Checks& c)
{
  c.Error("FIXED: two pieces of a cut surface still match", Gap(Optimizer::FIXED), 0);
  c.Greater("FREE: two pieces of a cut surface come apart", Gap(Optimizer::FREE), 0.01);
}
}

int TestOptimizerBoundary(int argc, char* argv[])
{
  Groups groups(argc, argv);
  groups.Run("Conditions", CheckConditions);
  groups.Run("Pieces", CheckPieces);
  return groups.Result();
}
