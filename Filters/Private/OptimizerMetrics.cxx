// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "OptimizerSession.h"
#include "OptimizerTables.h"
#include "PolyDataOutput.h"
#include "ResultArrays.h"
#include "SurfaceBlocks.h"

#include "vtkBoundingBox.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

namespace
{
/// Adds the bounding box of the points that cells use.
void AddBounds(vtkDataSet* surface, vtkBoundingBox& box)
{
  if (surface->GetNumberOfCells() == 0)
  {
    return;
  }
  double bounds[6];
  if (auto* polygons = vtkPolyData::SafeDownCast(surface))
  {
    polygons->GetCellsBounds(bounds);
  }
  else
  {
    surface->GetBounds(bounds);
  }
  box.AddBounds(bounds);
}
}

void vtkLaplacianMeshOptimizer::Session::SetMetrics(
  vtkLaplacianMeshOptimizer* filter, const lmo::OptimizerResult& result)
{
  Tables::VisitMetrics(*filter, result,
    [](const char*, auto& value, auto newValue, auto...)
    { value = static_cast<std::decay_t<decltype(value)>>(newValue); });
  filter->IsClosed = result.comparison.isClosed;
}

void vtkLaplacianMeshOptimizer::Session::AddMetrics(const lmo::OptimizerResult& result)
{
  const auto triangles = static_cast<double>(result.comparison.triangles);
  const bool isFirst = this->Totals.empty();
  bool& isClosed = this->Filter->IsClosed;
  isClosed = result.comparison.isClosed || (isClosed && !isFirst);
  std::size_t row = 0;
  Tables::VisitMetrics(*this->Filter, result,
    [&](const char*, auto& value, auto newValue, Combination combination, bool = true)
    {
      const auto added = static_cast<double>(newValue);
      if (isFirst)
      {
        this->Totals.push_back(added);
      }
      else if (combination == SUM)
      {
        this->Totals[row] += added;
      }
      else if (combination == LARGEST)
      {
        this->Totals[row] =
          std::abs(added) > std::abs(this->Totals[row]) ? added : this->Totals[row];
      }
      else if (triangles > 0)
      {
        const double before = this->TotalTriangles > 0 ? this->Totals[row] : added;
        const double share = triangles / (triangles + this->TotalTriangles);
        this->Totals[row] =
          combination == MEAN ? before + share * (added - before) : std::min(before, added);
      }
      value = static_cast<std::decay_t<decltype(value)>>(this->Totals[row++]);
    });
  this->TotalTriangles += triangles;
}

double vtkLaplacianMeshOptimizer::GetDeviationLength()
{
  double diagonal = -1; // the largest one of all surfaces
  for (const lmo::SurfaceBlock& block : lmo::FindBlocks(this->GetInputDataObject(0, 0)))
  {
    vtkBoundingBox box;
    for (const lmo::SurfacePart& part : block.parts)
    {
      AddBounds(part.data, box);
    }
    diagonal = std::max(diagonal, box.IsValid() ? box.GetDiagonalLength() : -1);
  }
  const double unit = this->DeviationIsAbsolute ? 1 : diagonal;
  return diagonal < 0 ? -1 : this->MaximumDeviation * unit;
}

void vtkLaplacianMeshOptimizer::Session::WriteMetrics(
  const lmo::OptimizerResult& result, lmo::ResultArrays& results, vtkFieldData* fieldData) const
{
  Tables::VisitMetrics(*this->Filter, result,
    [&](const char* name, auto value, auto newValue, Combination, bool isOfMode = true)
    {
      if (isOfMode)
      {
        // In the type of the filter's value: what the getter of one block would return.
        const auto held = static_cast<decltype(value)>(newValue);
        results.Add(fieldData, lmo::MakeArray(name, static_cast<double>(held)));
      }
      else
      {
        // An earlier filter may have written it, for another surface.
        lmo::ResultArrays::Remove(fieldData, name);
      }
    });
}

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
