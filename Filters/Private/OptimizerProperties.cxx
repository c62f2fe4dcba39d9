// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "OptimizerInternals.h"
#include "PointSelection.h"
#include "PolyDataConversion.h"

#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSelection.h"

#include <cmath>
#include <cstring>
#include <sstream>
#include <utility>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

namespace
{
void CheckEnumeration(const char* name, int value, int count)
{
  if (value < 0 || value >= count)
  {
    throw lmo::InputError(std::string(name) + " is " + std::to_string(value) +
                          "; choose a value from 0 to " + std::to_string(count - 1) + ".");
  }
}

void CheckNumber(const char* name, double value, bool isValid, const char* range)
{
  if (!isValid || !std::isfinite(value))
  {
    std::ostringstream text;
    text << name << " is " << value << "; it must be " << range << ".";
    throw lmo::InputError(text.str());
  }
}
}

void vtkLaplacianMeshOptimizer::Internals::CheckProperties() const
{
  const vtkLaplacianMeshOptimizer& filter = *this->Filter;
  CheckEnumeration("Mode", filter.Mode, 5);
  CheckEnumeration("LaplacianType", filter.LaplacianType, 3);
  CheckEnumeration("PositionWeighting", filter.PositionWeighting, 5);
  CheckEnumeration("LaplacianWeighting", filter.LaplacianWeighting, 5);
  CheckEnumeration("BoundaryCondition", filter.BoundaryCondition, 3);
  CheckEnumeration("SelectionUse", filter.SelectionUse, 2);
  CheckEnumeration("SolverType", filter.SolverType, 3);
  CheckNumber("ScaleFactor", filter.ScaleFactor,
    filter.ScaleFactor >= lmo::SmallestScaleFactor && filter.ScaleFactor <= lmo::LargestWeight,
    "more than 0, from 1e-40 to 1e40");
  CheckNumber("GaussianWidth", filter.GaussianWidth, filter.GaussianWidth > 0, "more than 0");
  CheckNumber("TangentPlaneWeight", filter.TangentPlaneWeight,
    filter.TangentPlaneWeight >= 0 && filter.TangentPlaneWeight <= lmo::LargestWeight,
    "0 or more, up to 1e40");
  CheckNumber(
    "Tolerance", filter.Tolerance, filter.Tolerance > 0 && filter.Tolerance < 1, "between 0 and 1");
  CheckNumber("MaximumNumberOfIterations", filter.MaximumNumberOfIterations,
    filter.MaximumNumberOfIterations > 0, "more than 0");
  CheckNumber("MaximumDeviation", filter.MaximumDeviation,
    filter.MaximumDeviation > 0 && filter.MaximumDeviation <= 1, "more than 0, up to 1");
  CheckNumber("NumberOfPasses", filter.NumberOfPasses, filter.NumberOfPasses > 0, "more than 0");
  CheckNumber("FeatureAngle", filter.FeatureAngle,
    filter.FeatureAngle >= 0 && filter.FeatureAngle <= 180, "from 0 to 180");
  CheckNumber(
    "NormalIterations", filter.NormalIterations, filter.NormalIterations >= 0, "0 or more");
  CheckNumber("NormalWidth", filter.NormalWidth, filter.NormalWidth > 0, "more than 0");
  CheckNumber("DetailWeight", filter.DetailWeight,
    filter.DetailWeight > 0 && filter.DetailWeight <= lmo::LargestWeight,
    "more than 0, up to 1e40");
}

lmo::OptimizerOptions vtkLaplacianMeshOptimizer::Internals::ReadOptions() const
{
  const vtkLaplacianMeshOptimizer& filter = *this->Filter;
  lmo::OptimizerOptions options;
  options.mode = static_cast<lmo::Mode>(filter.Mode);
  options.laplacianType = static_cast<lmo::LaplacianType>(filter.LaplacianType);
  options.robustLaplacian = filter.RobustLaplacian;
  options.positionWeighting = static_cast<lmo::PositionWeighting>(filter.PositionWeighting);
  options.scaleFactor = filter.ScaleFactor;
  options.laplacianWeighting = static_cast<lmo::LaplacianWeighting>(filter.LaplacianWeighting);
  options.gaussianWidth = filter.GaussianWidth;
  options.modulateByTriangleQuality = filter.ModulateByTriangleQuality;
  options.tangentPlaneConstraints = filter.TangentPlaneConstraints;
  options.tangentPlaneWeight = filter.TangentPlaneWeight;
  options.boundaryCondition = static_cast<lmo::BoundaryCondition>(filter.BoundaryCondition);
  options.solverType = static_cast<lmo::SolverType>(filter.SolverType);
  options.solver.tolerance = filter.Tolerance;
  options.solver.maximumIterations = filter.MaximumNumberOfIterations;
  options.deviation.maximum = filter.MaximumDeviation;
  options.deviation.passes = filter.NumberOfPasses;
  options.deviation.improveWorstTriangles = filter.ImproveWorstTriangles;
  options.guide.normalIterations = filter.NormalIterations;
  options.guide.normalWidth = filter.NormalWidth;
  options.guide.detailWeight = filter.DetailWeight;
  options.featureConstraints = filter.FeatureConstraints;
  options.detectFeatures = filter.DetectFeatures;
  options.featureAngle = filter.FeatureAngle;
  options.preserveVolume = filter.PreserveVolume;
  options.twicing = filter.Twicing;
  return options;
}

vtkDataArray* vtkLaplacianMeshOptimizer::Internals::FindArray(int index, vtkPolyData* input) const
{
  vtkInformation* choice = this->Filter->GetInputArrayInformation(index);
  const char* name = choice->Get(vtkDataObject::FIELD_NAME());
  // ParaView's choice of no array is the name "None".
  const bool isNamed = name && *name && std::strcmp(name, "None") != 0;
  if (input->GetNumberOfPoints() == 0)
  {
    return nullptr; // an empty piece has no arrays
  }
  if (!isNamed && !choice->Has(vtkDataObject::FIELD_ATTRIBUTE_TYPE()))
  {
    return nullptr;
  }
  int association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  vtkDataArray* array = this->Filter->GetInputArrayToProcess(index, input, association);
  const bool isOfCells =
    index == FEATURE_ARRAY && association == vtkDataObject::FIELD_ASSOCIATION_CELLS;
  if (!array || !(isOfCells || association == vtkDataObject::FIELD_ASSOCIATION_POINTS))
  {
    throw lmo::InputError(std::string("There is no numeric point ") +
                          (index == FEATURE_ARRAY ? "or cell " : "") + "array '" +
                          std::string(isNamed ? name : "of the chosen attribute") +
                          "'. Choose one that the input has.");
  }
  return array;
}

lmo::VertexArrays vtkLaplacianMeshOptimizer::Internals::ReadArrays(
  vtkPolyData* input, vtkSelection* selection) const
{
  const vtkLaplacianMeshOptimizer& filter = *this->Filter;
  const vtkIdType points = input->GetNumberOfPoints();
  const int weighting = filter.PositionWeighting;
  lmo::VertexArrays arrays;
  vtkDataArray* array = nullptr;
  if ((weighting == ARRAY || weighting == ANCHORS) &&
      (array = this->FindArray(POSITION_WEIGHT_ARRAY, input)))
  {
    arrays.positionWeights =
      weighting == ARRAY ? lmo::ReadWeights(array, points) : lmo::ReadScalars(array, points);
  }
  if (filter.LaplacianWeighting == ARRAY &&
      (array = this->FindArray(LAPLACIAN_WEIGHT_ARRAY, input)))
  {
    arrays.laplacianWeights = lmo::ReadWeights(array, points);
  }
  if (filter.Mode == PRESCRIBED_LAPLACIANS &&
      (array = this->FindArray(PRESCRIBED_LAPLACIAN_ARRAY, input)))
  {
    arrays.prescribedLaplacians = lmo::ReadVectors(array, points);
  }
  if ((array = this->FindArray(FIXED_POINT_ARRAY, input)))
  {
    arrays.fixedPoints = lmo::ReadScalars(array, points);
  }
  const bool hasFeatures = filter.Mode == OPTIMIZE_WITHIN_DEVIATION || filter.FeatureConstraints;
  if (hasFeatures && (array = this->FindArray(FEATURE_ARRAY, input)))
  {
    const bool isOfPoints = input->GetPointData()->HasArray(array->GetName()) &&
                            input->GetPointData()->GetArray(array->GetName()) == array;
    isOfPoints ? arrays.featurePoints = lmo::ReadScalars(array, points)
               : arrays.regions = lmo::ReadScalars(array, input->GetNumberOfCells());
  }
  if (selection)
  {
    lmo::Vector isFixed = lmo::SelectedPoints(input, selection);
    if (filter.SelectionUse == ONLY_SELECTED_POINTS_MOVE)
    {
      isFixed = 1 - isFixed.array();
    }
    arrays.fixedPoints = arrays.fixedPoints ? lmo::Vector(arrays.fixedPoints->cwiseAbs() + isFixed)
                                            : std::move(isFixed);
  }
  return arrays;
}

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
