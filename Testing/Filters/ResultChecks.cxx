// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ResultChecks.h"

#include "MeshMeasures.h"

#include "vtkLaplacianMeshOptimizer.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <sstream>

using namespace lmo;

namespace
{
bool IsWithin(const Eigen::MatrixXd& values, double least, double most)
{
  return ((values.array() >= least) && (values.array() <= most)).all();
}

/// The largest weight that a filter may give: s, 1 or the largest in the array "Weights".
double LargestWeightOf(vtkLaplacianMeshOptimizer* filter, vtkPolyData* input)
{
  const double largest = std::max(1.0, filter->GetScaleFactor());
  const Eigen::MatrixXd weights = PointValues(input, "Weights");
  return weights.size() > 0 ? std::max(largest, weights.maxCoeff()) : largest;
}

/// Of OPTIMIZE_WITHIN_DEVIATION.
std::string FaultOfLimits(vtkLaplacianMeshOptimizer* filter)
{
  std::ostringstream text;
  if (!(filter->GetRelativeHausdorffBound() <= filter->GetMaximumDeviation()))
  {
    text << "a deviation of up to " << filter->GetRelativeHausdorffBound() << " instead of "
         << filter->GetMaximumDeviation();
  }
  else if (!(filter->GetMinimumRadiusRatio() >= filter->GetInputMinimumRadiusRatio()))
  {
    text << "a radius ratio of " << filter->GetMinimumRadiusRatio() << " instead of at least "
         << filter->GetInputMinimumRadiusRatio();
  }
  return text.str();
}
}

std::string FaultOfResult(
  vtkPolyDataAlgorithm* filter, const Messages& messages, std::initializer_list<const char*> arrays)
{
  vtkPolyData* input = vtkPolyData::SafeDownCast(filter->GetInput());
  vtkPolyData* output = filter->GetOutput();
  if (!messages.errors.empty())
  {
    return messages.errors;
  }
  if (output->GetNumberOfPoints() != input->GetNumberOfPoints() ||
      output->GetNumberOfCells() != input->GetNumberOfCells())
  {
    return "points or cells are missing";
  }
  for (const char* array : arrays)
  {
    const Eigen::MatrixXd values = PointValues(output, array);
    if (values.rows() != input->GetNumberOfPoints() || !values.allFinite())
    {
      return std::string(array) + " is missing or not finite";
    }
  }
  return PointsOf(output).allFinite() ? "" : "points are not finite";
}

std::string FaultOfResult(vtkLaplacianMeshOptimizer* filter, const Messages& messages)
{
  const std::string fault = FaultOfResult(filter, messages,
    { "MeanCurvature", "PositionWeight", "LaplacianWeight", "Displacement", "RadiusRatio",
      "InputRadiusRatio" });
  if (!fault.empty())
  {
    return fault;
  }
  vtkPolyData* input = vtkPolyData::SafeDownCast(filter->GetInput());
  vtkPolyData* output = filter->GetOutput();
  const bool hasPasses = filter->GetMode() == vtkLaplacianMeshOptimizer::OPTIMIZE_WITHIN_DEVIATION;
  const double largestWeight = hasPasses ? 1e40 : LargestWeightOf(filter, input);
  if (!IsWithin(PointValues(output, "PositionWeight"), 0, largestWeight) ||
      !IsWithin(PointValues(output, "LaplacianWeight"), 0, largestWeight) ||
      !IsWithin(PointValues(output, "RadiusRatio"), -1, 1) ||
      !IsWithin(CellValues(output, "RadiusRatio"), -1, 1))
  {
    return "weights or radius ratios are out of range";
  }
  const double displacement = MaximumDistance(PointsOf(output), PointsOf(input));
  if (std::abs(displacement - filter->GetMaximumDisplacement()) > 1e-12 * displacement ||
      !std::isfinite(filter->GetRelativeVolumeChange()))
  {
    return "the metrics do not fit the points";
  }
  if (hasPasses)
  {
    const std::string limit = FaultOfLimits(filter);
    if (!limit.empty())
    {
      return limit;
    }
  }
  // The passes correct each other, and the bound above is what counts.
  const bool isSolved = hasPasses || filter->GetRelativeResidual() <= filter->GetTolerance();
  const bool isWarnedOf = messages.warnings.find("The solver stopped") != std::string::npos;
  return isSolved != isWarnedOf ? "" : "warning: '" + messages.warnings + "'";
}

std::string FaultOfRefusal(
  vtkPolyDataAlgorithm* filter, const Messages& messages, const std::vector<std::string>& texts)
{
  if (messages.errors.empty())
  {
    return "there is no error";
  }
  const bool holdsAll = std::all_of(texts.begin(), texts.end(),
    [&](const std::string& text) { return messages.errors.find(text) != std::string::npos; });
  if (!holdsAll)
  {
    return messages.errors;
  }
  return IsEmpty(filter->GetOutput()) ? "" : "the output is not empty";
}

vtkSmartPointer<vtkPolyData> CopyOf(vtkPolyData* data)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->DeepCopy(data);
  return copy;
}
