// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "MeshMeasures.h"

#include "Core/Mesh/TriangleGeometry.h"
#include "Core/Operators/NormalFilter.h"
#include "Core/Optimizer/Optimizer.h"

#include <cmath>

using namespace lmo;

namespace
{
OptimizerOptions Smoothing(double scaleFactor)
{
  OptimizerOptions options;
  options.mode = Mode::SMOOTH;
  options.positionWeighting = PositionWeighting::CONSTANT;
  options.scaleFactor = scaleFactor;
  options.solver.tolerance = 1e-12;
  return options;
}

Points Run(const TestMesh& mesh, const OptimizerOptions& options, const VertexArrays& arrays = {})
{
  ProgressMonitor monitor;
  return Optimize(mesh.V, mesh.T, options, arrays, monitor).positions;
}

double VolumeError(const TestMesh& mesh, const Points& moved)
{
  const double volume = EnclosedVolume(mesh.V, mesh.T);
  return std::abs(EnclosedVolume(moved, mesh.T) - volume) / volume;
}

/// Root of the mean square of the vertices' distances to a surface.
double DistanceTo(const TestMesh& clean, const Points& V)
{
  double sum = 0;
  for (Index i = 0; i < V.rows(); ++i)
  {
    const double distance = DistanceToSurface(V.row(i), clean);
    sum += distance * distance;
  }
  return std::sqrt(sum / V.rows());
}

/// Mean angle, in degrees, between the normals of triangles.
double NormalError(const TestMesh& clean, const Points& V)
{
  double sum = 0;
  for (Index t = 0; t < clean.T.rows(); ++t)
  {
    const Vector3 a = ScaledNormal(clean.V, clean.T, t).normalized();
    const Vector3 b = ScaledNormal(V, clean.T, t).normalized();
    sum += std::acos(std::min(1.0, std::max(-1.0, a.dot(b)))) * 180 / Pi;
  }
  return sum / clean.T.rows();
}

TestMesh Noisy(TestMesh mesh, double amplitude)
{
  mesh.V += amplitude * Random().Displacements(mesh.V.rows());
  return mesh;
}

void CheckVolume(Checks& c)
{
  const TestMesh sphere = Irregular(Icosphere(3), 0.05);
  OptimizerOptions options = Smoothing(0.1);
  c.Greater("smoothing shrinks a sphere", VolumeError(sphere, Run(sphere, options)), 1e-3);
  options.preserveVolume = true;
  c.Error("a sphere keeps its volume", VolumeError(sphere, Run(sphere, options)), 1e-12);
  options.mode = Mode::SMOOTH_GUIDED;
  c.Error("a guided sphere keeps its volume", VolumeError(sphere, Run(sphere, options)), 1e-12);
}

void CheckVolumesOfComponents(Checks& c)
{
  const TestMesh small = Irregular(Icosphere(2, 0.5), 0.05);
  TestMesh large = Irregular(Icosphere(3), 0.05);
  large.V.col(0).array() += 10;
  const TestMesh both = Joined(small, large);
  OptimizerOptions options = Smoothing(0.1);
  options.preserveVolume = true;
  VertexArrays arrays;
  arrays.fixedPoints = Vector::Zero(both.V.rows());
  (*arrays.fixedPoints)[7] = 1;
  const Points moved = Run(both, options, arrays);
  c.Error(
    "a small component keeps its volume", VolumeError(small, moved.topRows(small.V.rows())), 1e-12);
  c.Error("a large component keeps its volume",
    VolumeError(large, moved.bottomRows(large.V.rows())), 1e-12);
  c.Error("a fixed point does not move with the volume", (moved.row(7) - both.V.row(7)).norm(), 0);
}

/// S (2 I - S) V by the matrix S, column by column of the identity.
void CheckTwicing(Checks& c)
{
  const TestMesh mesh = Irregular(Icosphere(1), 0.1);
  OptimizerOptions options = Smoothing(0.5);
  const auto smooth = [&](const Points& x)
  {
    Points y(x.rows(), 3);
    const TestMesh field{ x, mesh.T };
    y = Run(field, options); // L_u and constant weights do not depend on the positions
    return y;
  };
  const Points expected = smooth(Points(2 * mesh.V - smooth(mesh.V)));
  options.twicing = true;
  const Points twice = Run(mesh, options);
  c.Error("twicing is S (2 I - S)", MaximumDistance(twice, expected), 1e-9);
}

void CheckGuided(Checks& c)
{
  const TestMesh clean = DoublePyramid(4);
  const TestMesh noisy = Noisy(clean, 0.02);
  OptimizerOptions guided = Smoothing(1);
  guided.mode = Mode::SMOOTH_GUIDED;
  guided.guide.normalIterations = 20;
  const Points along = Run(noisy, guided);
  const Points plain = Run(noisy, Smoothing(0.3));
  c.Error("guided smoothing halves the plain error of normals", NormalError(clean, along),
    0.5 * NormalError(clean, plain));
  c.Error("guided smoothing is closer to the clean pyramid", DistanceTo(clean, along),
    0.8 * DistanceTo(clean, plain));
  guided.guide.detailWeight = 1e6;
  c.Error("a heavy weight of detail holds every point",
    MaximumDistance(Run(noisy, guided), noisy.V), 1e-9);
}

void CheckNormalFilter(Checks& c)
{
  const TestMesh pyramid = DoublePyramid(3);
  const MeshTopology topology = BuildTopology(static_cast<Index>(pyramid.V.rows()), pyramid.T);
  ProgressMonitor monitor;
  const Points filtered = FilterNormals(pyramid.V, pyramid.T, topology, 5, 0.25, monitor);
  double error = 0;
  for (Index t = 0; t < pyramid.T.rows(); ++t)
  {
    const Vector3 normal = ScaledNormal(pyramid.V, pyramid.T, t).normalized();
    error = Larger(error, (filtered.row(t) - normal).norm());
  }
  // Across an edge normals differ by at least 1.15: the Gaussian of that is 3e-5.
  c.Error("the filter leaves the normals of flat faces", error, 1e-3);
}

void CheckFeatureConstraints(Checks& c)
{
  const TestMesh cube = Cube(3);
  OptimizerOptions options = Smoothing(0.1);
  options.mode = Mode::OPTIMIZE_TRIANGLES;
  options.featureConstraints = true;
  const auto leaveEdges = [&](const Points& moved)
  {
    double error = 0;
    for (Index i = 0; i < moved.rows(); ++i)
    {
      int walls = 0;
      for (int k = 0; k < 3; ++k)
      {
        walls += cube.V(i, k) == 0 || cube.V(i, k) == 1;
      }
      for (int k = 0; k < 3 && walls > 1; ++k)
      {
        const bool isOnWall = cube.V(i, k) == 0 || cube.V(i, k) == 1;
        error = isOnWall ? Larger(error, std::abs(moved(i, k) - cube.V(i, k))) : error;
      }
    }
    return error;
  };
  c.Error("edge points of a cube stay on their edges", leaveEdges(Run(cube, options)), 1e-12);
  options.detectFeatures = false;
  c.Greater("without features they leave them", leaveEdges(Run(cube, options)), 1e-3);

  VertexArrays byPoints;
  byPoints.featurePoints = Vector::Zero(cube.V.rows());
  VertexArrays byLabels;
  byLabels.labels = TriangleLabels::Zero(cube.T.rows(), 1);
  for (Index i = 0; i < cube.V.rows(); ++i)
  {
    const int walls = ((cube.V.row(i).array() == 0) || (cube.V.row(i).array() == 1)).count();
    (*byPoints.featurePoints)[i] = walls > 1;
  }
  for (Index t = 0; t < cube.T.rows(); ++t)
  {
    const Vector3 normal = ScaledNormal(cube.V, cube.T, t).normalized();
    (*byLabels.labels)(t, 0) = std::round(normal.dot(Vector3(1, 2, 3)));
  }
  c.Error("with tagged points they stay", leaveEdges(Run(cube, options, byPoints)), 1e-12);
  c.Error("between regions they stay", leaveEdges(Run(cube, options, byLabels)), 1e-12);
}
}

int TestSmoothing(int argc, char* argv[])
{
  Groups groups(argc, argv);
  groups.Run("Volume", CheckVolume);
  groups.Run("VolumesOfComponents", CheckVolumesOfComponents);
  groups.Run("Twicing", CheckTwicing);
  groups.Run("Guided", CheckGuided);
  groups.Run("NormalFilter", CheckNormalFilter);
  groups.Run("FeatureConstraints", CheckFeatureConstraints);
  return groups.Result();
}
