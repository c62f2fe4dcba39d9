// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "OptimizerSession.h"
#include "OptimizerTables.h"
#include "PointSelection.h"
#include "PolyDataConversion.h"

#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSelection.h"

#include <cstring>
#include <sstream>
#include <type_traits>
#include <utility>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

namespace
{
void CheckValue(const char*, int, lmo::Switch) {}

void CheckValue(const char* name, int value, lmo::Choices choices)
{
  if (value < 0 || value > choices.last)
  {
    throw lmo::InputError(std::string(name) + " is " + std::to_string(value) +
                          "; choose a value from 0 to " + std::to_string(choices.last) + ".");
  }
}

void CheckValue(const char* name, double value, lmo::Range range)
{
  if (!(value >= range.least && value <= range.largest)) // NaN is not in a range
  {
    std::ostringstream text;
    text << name << " is " << value << "; it must be " << range.text << ".";
    throw lmo::InputError(text.str());
  }
}
}

lmo::OptimizerOptions vtkLaplacianMeshOptimizer::Session::ReadOptions(vtkPolyData* input) const
{
  lmo::OptimizerOptions options;
  Tables::VisitProperties(*this->Filter, options,
    [](const char* name, auto value, auto validValues, auto&... option)
    {
      CheckValue(name, value, validValues);
      ((option = static_cast<std::decay_t<decltype(option)>>(value)), ...);
    });
  if (options.freeAxes.isZero(0))
  {
    throw lmo::InputError("FreeAxes is 0 0 0, and no point can move. Set at least one to 1.");
  }
  const bool hasNormals = input->GetPointData()->GetNormals() != nullptr;
  options.computeNormals =
    this->Filter->ComputeNormals && hasNormals && !this->InterpolatesPointData();
  options.roundToFloat = input->GetPoints() && input->GetPoints()->GetDataType() == VTK_FLOAT;
  return options;
}

vtkDataArray* vtkLaplacianMeshOptimizer::Session::FindArray(int index, vtkPolyData* input) const
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

lmo::Vector vtkLaplacianMeshOptimizer::Session::SelectedPointsOf(
  const lmo::SurfacePart& part, vtkSelection* selection, vtkPolyData* surface) const
{
  lmo::Vector isSelected = lmo::SelectedPoints(part.data, selection, part.flatIndex);
  auto* originalIds = vtkIdTypeArray::SafeDownCast(
    surface == part.data ? nullptr : surface->GetPointData()->GetArray("vtkOriginalPointIds"));
  if (originalIds)
  {
    lmo::Vector ofSurface(surface->GetNumberOfPoints());
    for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
    {
      ofSurface[i] = isSelected[originalIds->GetValue(i)];
    }
    return ofSurface;
  }
  return isSelected;
}

lmo::VertexArrays vtkLaplacianMeshOptimizer::Session::ReadArrays(
  vtkPolyData* input, std::optional<lmo::Vector> isSelected) const
{
  const vtkLaplacianMeshOptimizer& filter = *this->Filter;
  const lmo::MeshNumbering& numbering = this->Numbering;
  const int weighting = filter.PositionWeighting;
  lmo::VertexArrays arrays;
  vtkDataArray* array = nullptr;
  if ((weighting == ARRAY || weighting == ANCHORS) &&
      (array = this->FindArray(POSITION_WEIGHT_ARRAY, input)))
  {
    arrays.positionWeights =
      weighting == ARRAY ? lmo::ReadWeights(array, numbering) : lmo::ReadScalars(array, numbering);
  }
  if (filter.LaplacianWeighting == ARRAY &&
      (array = this->FindArray(LAPLACIAN_WEIGHT_ARRAY, input)))
  {
    arrays.laplacianWeights = lmo::ReadWeights(array, numbering);
  }
  if (filter.Mode == PRESCRIBED_LAPLACIANS &&
      (array = this->FindArray(PRESCRIBED_LAPLACIAN_ARRAY, input)))
  {
    arrays.prescribedLaplacians = lmo::ReadVectors(array, numbering);
  }
  if ((array = this->FindArray(FIXED_POINT_ARRAY, input)))
  {
    arrays.fixedPoints = lmo::ReadFlags(array, numbering);
  }
  const bool usesFeatures = filter.Mode == OPTIMIZE_WITHIN_DEVIATION || filter.FeatureConstraints ||
                            filter.FeatureSmoothing || filter.PreserveVolume;
  if (usesFeatures && (array = this->FindArray(FEATURE_ARRAY, input)))
  {
    const bool isOfPoints = input->GetPointData()->HasArray(array->GetName()) &&
                            input->GetPointData()->GetArray(array->GetName()) == array;
    if (isOfPoints)
    {
      arrays.featurePoints = lmo::ReadScalars(array, numbering);
    }
    else
    {
      arrays.labels = lmo::ReadLabels(array, numbering);
    }
  }
  if (isSelected)
  {
    lmo::Vector isFixed = numbering.AnyOfPoints(*isSelected);
    if (filter.SelectionUse == ONLY_SELECTED_POINTS_MOVE)
    {
      isFixed = 1 - isFixed.array();
    }
    arrays.fixedPoints =
      arrays.fixedPoints ? lmo::Vector(*arrays.fixedPoints + isFixed) : std::move(isFixed);
  }
  return arrays;
}

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
