// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "FilterTesting.h"
#include "MeshFixtures.h"
#include "MeshMeasures.h"

#include "vtkLaplacianMeshOptimizer.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <vector>

using namespace lmo;

namespace
{
using Optimizer = vtkLaplacianMeshOptimizer;

/// A sphere with uneven triangles.
TestMesh UnevenSphere()
{
  TestMesh mesh = Icosphere(3);
  mesh.V += 0.04 * Random().Displacements(mesh.V.rows());
  mesh.V.rowwise().normalize();
  return mesh;
}

/// The sphere at a time, twisted and with a wave that runs over it.
TestMesh Deformed(TestMesh mesh, double time)
{
  for (Eigen::Index i = 0; i < mesh.V.rows(); ++i)
  {
    const Vector3 x = mesh.V.row(i);
    const double angle = 0.5 * std::sin(time) * x[2];
    mesh.V.row(i) << std::cos(angle) * x[0] - std::sin(angle) * x[1],
      std::sin(angle) * x[0] + std::cos(angle) * x[1], x[2] + 0.05 * std::sin(3 * x[0] + time);
  }
  return mesh;
}

constexpr int Steps = 8;
constexpr double TimeStep = 0.4;

/// The largest |x(t + 1) - 2 x(t) + x(t - 1)|.
double LargestAcceleration(const std::vector<Points>& steps)
{
  double largest = 0;
  for (std::size_t k = 1; k + 1 < steps.size(); ++k)
  {
    const Points acceleration = steps[k + 1] - 2 * steps[k] + steps[k - 1];
    largest = std::max(largest, acceleration.rowwise().norm().maxCoeff());
  }
  return largest;
}

/// What the filter makes of the deforming sphere.
struct Animation
{
  std::vector<Points> inputs;
  std::vector<Points> outputs;
  double bound = 0;          ///< the largest RelativeHausdorffBound
  std::vector<double> gains; ///< of the mean radius ratio
};

Animation Animate(bool startFromPrevious)
{
  vtkNew<Optimizer> filter;
  filter->SetStartFromPreviousTimeStep(startFromPrevious);
  Animation animation;
  const TestMesh sphere = UnevenSphere();
  for (int step = 0; step < Steps; ++step)
  {
    const TestMesh mesh = Deformed(sphere, TimeStep * step);
    filter->SetInputData(MakePolyData(mesh));
    filter->Update();
    animation.inputs.push_back(mesh.V);
    animation.outputs.push_back(PointsOf(filter->GetOutput()));
    animation.bound = std::max(animation.bound, filter->GetRelativeHausdorffBound());
    animation.gains.push_back(filter->GetMeanRadiusRatio() - filter->GetInputMeanRadiusRatio());
  }
  return animation;
}

void CheckMotion(Checks& c)
{
  const Animation followed = Animate(true);
  const Animation alone = Animate(false);
  const double ofInput = LargestAcceleration(followed.inputs);
  c.Less("points accelerate at most twice as much as those of the input",
    LargestAcceleration(followed.outputs), 2 * ofInput);
  c.Less("steps that start anew accelerate more", 2 * LargestAcceleration(followed.outputs),
    LargestAcceleration(alone.outputs));
  c.Less("the distance stays guaranteed", followed.bound, 0.002 * (1 + 1e-9));
  c.AtLeast("the triangles keep half of what the first step gained",
    *std::min_element(followed.gains.begin(), followed.gains.end()), followed.gains[0] / 2);
}

Points ResultOf(Optimizer* filter, const TestMesh& mesh)
{
  filter->SetInputData(MakePolyData(mesh));
  filter->Update();
  return PointsOf(filter->GetOutput());
}

void CheckOrder(Checks& c)
{
  const TestMesh sphere = UnevenSphere();
  const TestMesh later = Deformed(sphere, TimeStep);
  vtkNew<Optimizer> alone;
  vtkNew<Optimizer> filter;
  filter->StartFromPreviousTimeStepOn();
  c.True("the first step is as without a previous one",
    ResultOf(filter, sphere) == ResultOf(alone, sphere));
  const Points second = ResultOf(filter, later);
  c.True("a step depends on the previous one", second != ResultOf(alone, later));
  filter->Modified();
  c.True("a step that is executed again is the same", second == ResultOf(filter, later));
  const TestMesh other = Icosphere(2);
  c.True("other triangles start anew", ResultOf(filter, other) == ResultOf(alone, other));
}

/// Two spheres, of which one rests.
vtkSmartPointer<vtkMultiBlockDataSet> Blocks(const TestMesh& sphere, double time)
{
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  blocks->SetBlock(0, MakePolyData(sphere));
  blocks->SetBlock(1, MakePolyData(Deformed(sphere, time)));
  return blocks;
}

void CheckBlocks(Checks& c)
{
  const TestMesh sphere = UnevenSphere();
  vtkNew<Optimizer> filter;
  filter->StartFromPreviousTimeStepOn();
  std::vector<Points> resting;
  for (const double time : { 0.0, TimeStep })
  {
    filter->SetInputDataObject(Blocks(sphere, time));
    filter->Update();
    auto* output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
    resting.push_back(PointsOf(vtkPolyData::SafeDownCast(output->GetBlock(0))));
  }
  c.True("a block follows itself, not the block before", resting[0] == resting[1]);
}
}

int TestOptimizerTimeSteps(int argc, char* argv[])
{
  Groups groups(argc, argv);
  groups.Run("Motion", CheckMotion);
  groups.Run("Order", CheckOrder);
  groups.Run("Blocks", CheckBlocks);
  return groups.Result();
}
