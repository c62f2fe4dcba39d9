// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef BenchmarkMeasurement_h
#define BenchmarkMeasurement_h

#include <array>
#include <functional>
#include <limits>
#include <vector>

class vtkPolyData;
class vtkPolyDataAlgorithm;

constexpr double NoValue = std::numeric_limits<double>::quiet_NaN();

/// What the names that vtkLaplacianMeshOptimizer reports begin with, and short.
struct Stage
{
  const char* name;
  const char* title;
};
constexpr std::array<Stage, 9> Stages = { { { "Reading the mesh", "reading" },
  { "Setting up the equations", "setup" }, { "Solving", "solving" },
  { "Filtering normals", "filtering" }, { "Following normals", "following" }, { "Pass ", "passes" },
  { "Improving the worst triangles", "worst" }, { "Comparing the surfaces", "comparing" },
  { "Writing the result", "writing" } } };

/// One Update(). What is no vtkLaplacianMeshOptimizer has NoValue everywhere but in seconds.
struct Measurement
{
  double seconds = NoValue;
  std::array<double, Stages.size()> stagePercents;
  double iterations = NoValue;
  double inputMeanRadiusRatio = NoValue;
  double meanRadiusRatio = NoValue;

  Measurement() { this->stagePercents.fill(NoValue); }
};

/// \throw std::runtime_error if the filter names an unknown stage
Measurement MeasureTime(vtkPolyDataAlgorithm* filter);

/// The measurement with the median time; of an even number, the slower of the two in the middle.
Measurement Median(std::vector<Measurement> measurements);

/// Memory that update(), which updates \a filter, takes at its peak beyond input and output, in
/// bytes; the mesh is the input. NoValue where the system does not tell.
double MeasureMemory(
  vtkPolyDataAlgorithm* filter, vtkPolyData* mesh, const std::function<void()>& update);

#endif
