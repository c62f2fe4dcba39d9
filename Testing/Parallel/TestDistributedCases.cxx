// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "ParallelTesting.h"

#include "vtkDataObject.h"
#include "vtkLaplacianMeshOptimizer.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

using namespace lmo;

namespace
{
using Optimizer = vtkLaplacianMeshOptimizer;

struct Case
{
  std::string name;
  SetUp setUp;
};

void Choose(Optimizer* filter, int index, const char* array)
{
  filter->SetInputArrayToProcess(index, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, array);
}

std::vector<Case> PositionWeightingCases()
{
  std::vector<Case> cases;
  for (const int weighting : { Optimizer::CONSTANT, Optimizer::LINEAR, Optimizer::CDF })
  {
    cases.push_back({ "position weighting " + std::to_string(weighting),
      [=](Optimizer* filter) { filter->SetPositionWeighting(weighting); } });
  }
  for (const int weighting : { Optimizer::ANCHORS, Optimizer::ARRAY })
  {
    cases.push_back({ "position weighting " + std::to_string(weighting), [=](Optimizer* filter)
      {
        filter->SetPositionWeighting(weighting);
        Choose(filter, Optimizer::POSITION_WEIGHT_ARRAY,
          weighting == Optimizer::ANCHORS ? "Anchor" : "Weight");
      } });
  }
  cases.push_back({ "weights that leave components unconstrained", [](Optimizer* filter)
    {
      filter->SetPositionWeighting(Optimizer::ARRAY);
      Choose(filter, Optimizer::POSITION_WEIGHT_ARRAY, "Zero");
    } });
  cases.push_back({ "modulation by triangle quality",
    [](Optimizer* filter) { filter->SetModulateByTriangleQuality(true); } });
  return cases;
}

std::vector<Case> LaplacianCases()
{
  std::vector<Case> cases;
  for (int weighting = Optimizer::LINEAR_COMPLEMENT; weighting <= Optimizer::ARRAY; ++weighting)
  {
    cases.push_back({ "Laplacian weighting " + std::to_string(weighting), [=](Optimizer* filter)
      {
        filter->SetLaplacianWeighting(weighting);
        Choose(filter, Optimizer::LAPLACIAN_WEIGHT_ARRAY, "Weight");
      } });
  }
  for (const int type : { Optimizer::UNIFORM, Optimizer::COTANGENT, Optimizer::MEAN_CURVATURE })
  {
    cases.push_back({ "smoothing with the Laplacian " + std::to_string(type), [=](Optimizer* filter)
      {
        filter->SetMode(Optimizer::SMOOTH);
        filter->SetLaplacianType(type);
        filter->SetScaleFactor(0.3);
      } });
    cases.push_back({ "prescribed Laplacians " + std::to_string(type), [=](Optimizer* filter)
      {
        filter->SetMode(Optimizer::PRESCRIBED_LAPLACIANS);
        filter->SetLaplacianType(type);
        Choose(filter, Optimizer::PRESCRIBED_LAPLACIAN_ARRAY, "Laplacian");
      } });
  }
  return cases;
}

std::vector<Case> ConstraintCases()
{
  std::vector<Case> cases;
  for (const int condition : { Optimizer::FIXED, Optimizer::SLIDING, Optimizer::FREE })
  {
    for (const bool hasPlanes : { false, true })
    {
      cases.push_back({ "boundary condition " + std::to_string(condition) +
                          (hasPlanes ? " with tangent planes" : ""),
        [=](Optimizer* filter)
        {
          filter->SetBoundaryCondition(condition);
          filter->SetTangentPlaneConstraints(hasPlanes);
        } });
    }
  }
  cases.push_back(
    { "feature constraints", [](Optimizer* filter) { filter->FeatureConstraintsOn(); } });
  cases.push_back({ "fixed points",
    [](Optimizer* filter) { Choose(filter, Optimizer::FIXED_POINT_ARRAY, "Anchor"); } });
  return cases;
}

std::vector<Case> SolverCases()
{
  std::vector<Case> cases;
  for (const int type : { Optimizer::DIRECT, Optimizer::ITERATIVE })
  {
    cases.push_back({ "solver " + std::to_string(type),
      [=](Optimizer* filter) { filter->SetSolverType(type); } });
    cases.push_back(
      { "solver " + std::to_string(type) + " with coupled coordinates", [=](Optimizer* filter)
        {
          filter->SetSolverType(type);
          filter->SetTangentPlaneConstraints(true);
          filter->SetBoundaryCondition(Optimizer::SLIDING);
        } });
  }
  cases.push_back({ "smoothing twice", [](Optimizer* filter)
    {
      filter->SetMode(Optimizer::SMOOTH);
      filter->SetTwicing(true);
      filter->SetBoundaryCondition(Optimizer::SLIDING);
    } });
  cases.push_back({ "strong smoothing", [](Optimizer* filter)
    {
      filter->SetMode(Optimizer::SMOOTH);
      filter->SetScaleFactor(0.01);
      filter->SetPositionWeighting(Optimizer::CONSTANT);
    } });
  return cases;
}

std::vector<Case> AllCases()
{
  std::vector<Case> all;
  for (const std::vector<Case>& cases :
    { PositionWeightingCases(), LaplacianCases(), ConstraintCases(), SolverCases() })
  {
    all.insert(all.end(), cases.begin(), cases.end());
  }
  return all;
}

/// The mesh with the arrays that the cases name.
vtkSmartPointer<vtkPolyData> WithArrays(const TestMesh& mesh)
{
  auto surface = MakePolyData(mesh);
  const Eigen::Index size = mesh.V.rows();
  Eigen::VectorXd anchor = Eigen::VectorXd::Zero(size);
  anchor(Eigen::seq(0, Eigen::indexing::last, 5)).setOnes();
  AddPointArray(surface, "Anchor", anchor);
  AddPointArray(surface, "Zero", Eigen::VectorXd::Zero(size));
  AddPointArray(surface, "Weight", (mesh.V.col(0).array().sin() + 1.1).matrix());
  AddPointArray(surface, "Laplacian", 0.01 * Random().Displacements(size));
  return surface;
}

double DifferenceOf(MpiJob& job, vtkPolyData* whole, const Cut& cut, const SetUp& setUp)
{
  const auto precise = [&](Optimizer* filter)
  {
    filter->SetTolerance(1e-12);
    filter->InterpolatePointDataOff(); // closest places are not always unique
    setUp(filter);
  };
  const PieceOfMesh piece = TakePiece(whole, cut, job.Rank(), job.Size());
  return job.Largest(
    DifferenceFromWhole(piece, Optimized(piece.surface, precise), OptimizedAlone(whole, precise)));
}

/// A square with a ridge of 16 edges along y that ends inside it on both sides.
TestMesh Ridge()
{
  TestMesh mesh = Grid(24, 0);
  for (Eigen::Index i = 0; i < mesh.V.rows(); ++i)
  {
    const double x = mesh.V(i, 0) / 12 - 1;
    const double y = mesh.V(i, 1) / 12 - 1;
    const double slope = std::clamp((0.8 - std::abs(y)) / 0.35, 0.0, 1.0);
    mesh.V.row(i) << x, y, -slope * std::abs(x);
  }
  return Irregular(mesh, 0.002);
}

/// A line that ends inside a surface is noise if it is short: no process has enough of its edges.
void CheckLine(MpiJob& job, Checks& c)
{
  const TestMesh mesh = Ridge();
  const auto whole = MakePolyData(mesh);
  const auto setUp = [](Optimizer* filter) { filter->FeatureConstraintsOn(); };
  c.AtLeast("a ridge is a feature",
    double((PointValues(OptimizedAlone(whole, setUp), "FeatureClass").array() == 1).count()), 10);
  c.Error("a ridge through several pieces is one, too",
    DifferenceOf(job, whole, Sectors(mesh), setUp), 1e-9);
}

/// Where the first solver fails another one follows: the result would not tell.
void CheckIterations(MpiJob& job, Checks& c)
{
  const TestMesh mesh = Irregular(HalfSphere(4), 0.02);
  const auto whole = MakePolyData(mesh);
  const PieceOfMesh piece = TakePiece(whole, Sectors(mesh), job.Rank(), job.Size());
  for (const bool hasPlanes : { false, true })
  {
    const auto setUp = [=](Optimizer* filter)
    {
      filter->SetTolerance(1e-12);
      filter->SetBoundaryCondition(Optimizer::SLIDING);
      filter->SetTangentPlaneConstraints(hasPlanes);
    };
    const double expected = FieldValue(OptimizedAlone(whole, setUp), "Iterations");
    const double iterations = FieldValue(Optimized(piece.surface, setUp), "Iterations");
    c.Error(std::string("iterations of one process") + (hasPlanes ? " with tangent planes" : ""),
      job.Largest(std::abs(iterations / expected - 1)), 0.1);
  }
}
}

int TestDistributedCases(int argc, char* argv[])
{
  MpiJob job(argc, argv);
  Checks c;
  const std::pair<std::string, TestMesh> meshes[] = {
    { "a closed surface", Irregular(Icosphere(3), 0.02) },
    { "an open surface", Irregular(HalfSphere(3), 0.02) },
    { "two components and a point", WithIsolatedPoint(Irregular(TwoComponents(), 0.02)) },
    { "a cube", Irregular(Cube(3), 0.01) },
    { "thin triangles", WithThinTriangles(Irregular(CylinderPatch(2), 0.02)) },
  };
  for (const auto& [meshName, mesh] : meshes)
  {
    const auto whole = WithArrays(mesh);
    for (const Case& each : AllCases())
    {
      c.Error(each.name + " on " + meshName + ": the pieces are those of the whole surface",
        DifferenceOf(job, whole, Sectors(mesh), each.setUp), 1e-9);
    }
  }
  CheckIterations(job, c);
  CheckLine(job, c);
  return c.Result();
}
