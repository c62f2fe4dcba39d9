// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "PointDataInterpolation.h"

#include "CellReading.h"
#include "Core/Base/Threading.h"
#include "Core/Mesh/MeshTopology.h"
#include "Core/Mesh/SurfaceWalk.h"

#include "vtkArrayDispatch.h"
#include "vtkDataArrayRange.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdList.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>
#include <unordered_map>
#include <vector>

namespace lmo
{
namespace
{
bool IsInterpolated(vtkAbstractArray* array)
{
  const int type = array->GetDataType();
  const int components = array->GetNumberOfComponents();
  const bool isColour = type == VTK_UNSIGNED_CHAR && (components == 3 || components == 4);
  return vtkDataArray::FastDownCast(array) && (type == VTK_FLOAT || type == VTK_DOUBLE || isColour);
}

bool HaveSameValues(vtkDataArray* array, Index i, Index j)
{
  bool isSame = true;
  for (int c = 0; c < array->GetNumberOfComponents(); ++c)
  {
    isSame = isSame && array->GetComponent(i, c) == array->GetComponent(j, c);
  }
  return isSame;
}

/// For each point the first point of the same vertex that is on the same side of all seams.
std::vector<Index> FirstPointsOfSides(vtkPointData* data, const MeshNumbering& numbering)
{
  const auto size = static_cast<Index>(numbering.GetNumberOfPoints());
  std::vector<vtkDataArray*> arrays;
  for (int k = 0; k < data->GetNumberOfArrays(); ++k)
  {
    vtkAbstractArray* array = data->GetAbstractArray(k);
    if (IsInterpolated(array) && array != data->GetNormals())
    {
      arrays.push_back(vtkDataArray::FastDownCast(array));
    }
  }
  std::vector<Index> first(size);
  std::iota(first.begin(), first.end(), Index(0));
  std::unordered_map<Index, std::vector<Index>> sides; // the first points of each vertex
  for (Index i = 0; i < size && numbering.HasMergedPoints(); ++i)
  {
    std::vector<Index>& candidates = sides[numbering.VertexOf(i)];
    const auto same = std::find_if(candidates.begin(), candidates.end(),
      [&](Index j)
      {
        return std::all_of(arrays.begin(), arrays.end(),
          [&](vtkDataArray* array) { return HaveSameValues(array, i, j); });
      });
    first[i] = same == candidates.end() ? i : *same;
    if (same == candidates.end())
    {
      candidates.push_back(i);
    }
  }
  return first;
}

/// The input's triangles, connected where there is no seam.
Triangles TrianglesOfSides(vtkPolyData* input, const std::vector<Index>& firstPoints)
{
  Triangles triangles = ReadTriangles(input).triangles;
  ParallelFor(static_cast<Index>(triangles.rows()),
    [&](Index t)
    {
      for (int k = 0; k < 3; ++k)
      {
        triangles(t, k) = firstPoints[triangles(t, k)];
      }
    });
  return triangles;
}

/// Where each output point lies on the input; no triangle for points that did not move.
std::vector<SurfaceLocation> Locate(vtkPoints* points, const std::vector<Index>& firstPoints,
  const Triangles& triangles, const Points& positions)
{
  const auto size = static_cast<Index>(positions.rows());
  Points V(size, 3);
  ParallelFor(size, [&](Index i) { points->GetPoint(i, V.row(i).data()); });
  const AdjacencyLists cornersAt = CornersAtVertices(size, triangles);
  std::vector<SurfaceLocation> locations(size);
  ParallelFor(size,
    [&](Index i)
    {
      if (positions.row(i) != V.row(i))
      {
        locations[i] =
          WalkToClosestPoint(V, triangles, cornersAt, firstPoints[i], positions.row(i));
      }
    });
  return locations;
}

/// The corner with the largest weight, the point itself where there is no triangle.
vtkSmartPointer<vtkIdList> NearestPoints(
  const std::vector<SurfaceLocation>& locations, const Triangles& triangles)
{
  auto nearest = vtkSmartPointer<vtkIdList>::New();
  nearest->SetNumberOfIds(static_cast<vtkIdType>(locations.size()));
  for (std::size_t i = 0; i < locations.size(); ++i)
  {
    Index corner = 0;
    if (locations[i].triangle >= 0)
    {
      locations[i].weights.maxCoeff(&corner);
    }
    const auto point = static_cast<vtkIdType>(i);
    nearest->SetId(
      point, locations[i].triangle >= 0 ? triangles(locations[i].triangle, corner) : point);
  }
  return nearest;
}

struct Interpolate
{
  const std::vector<SurfaceLocation>& locations;
  const Triangles& triangles;
  bool isRounded;

  template <typename Array>
  void operator()(Array* from, vtkDataArray* output) const
  {
    const auto input = vtk::DataArrayTupleRange(from);
    auto result = vtk::DataArrayTupleRange(Array::FastDownCast(output));
    ParallelFor(static_cast<Index>(this->locations.size()),
      [&, this](Index i)
      {
        const SurfaceLocation& location = this->locations[i];
        if (location.triangle < 0)
        {
          return;
        }
        const auto corners = this->triangles.row(location.triangle);
        for (int c = 0; c < from->GetNumberOfComponents(); ++c)
        {
          const Vector3 values(input[corners[0]][c], input[corners[1]][c], input[corners[2]][c]);
          // Round-off must not lead out of the range.
          const double value =
            std::clamp(location.weights.dot(values), values.minCoeff(), values.maxCoeff());
          result[i][c] =
            static_cast<vtk::GetAPIType<Array>>(this->isRounded ? std::round(value) : value);
        }
      });
  }
};

bool StaysWithPoint(vtkPointData* data, vtkAbstractArray* array)
{
  const char* name = array->GetName() ? array->GetName() : "";
  return array == data->GetAbstractAttribute(vtkDataSetAttributes::GLOBALIDS) ||
         array == data->GetAbstractAttribute(vtkDataSetAttributes::PEDIGREEIDS) ||
         std::strcmp(name, "vtkOriginalPointIds") == 0 ||
         std::strcmp(name, vtkDataSetAttributes::GhostArrayName()) == 0;
}

/// Gives the normals that were interpolated unit length.
void Normalise(vtkDataArray* normals, const std::vector<SurfaceLocation>& locations)
{
  for (std::size_t i = 0; i < locations.size(); ++i)
  {
    if (locations[i].triangle >= 0)
    {
      const auto point = static_cast<vtkIdType>(i);
      Vector3 normal;
      normals->GetTuple(point, normal.data());
      normals->SetTuple(point, Vector3(normal.stableNormalized()).data());
    }
  }
}

/// The values of the input's array at the locations.
vtkSmartPointer<vtkAbstractArray> Transfer(vtkAbstractArray* array,
  const std::vector<SurfaceLocation>& locations, const Triangles& triangles, vtkIdList* nearest)
{
  auto result = vtk::TakeSmartPointer(array->NewInstance());
  result->DeepCopy(array);
  if (!IsInterpolated(array))
  {
    array->GetTuples(nearest, result);
    return result;
  }
  const Interpolate interpolate{ locations, triangles, array->GetDataType() == VTK_UNSIGNED_CHAR };
  vtkDataArray* from = vtkDataArray::FastDownCast(array);
  vtkDataArray* to = vtkDataArray::FastDownCast(result);
  if (!vtkArrayDispatch::DispatchByValueType<vtkArrayDispatch::Reals>::Execute(
        from, interpolate, to))
  {
    interpolate(from, to);
  }
  return result;
}
}

vtkSmartPointer<vtkPointData> InterpolatePointData(
  vtkPolyData* input, const MeshNumbering& numbering, const Points& positions)
{
  vtkPointData* data = input->GetPointData();
  auto result = vtkSmartPointer<vtkPointData>::New();
  if (data->GetNumberOfArrays() == 0 || positions.rows() == 0)
  {
    result->ShallowCopy(data);
    return result;
  }
  const std::vector<Index> firstPoints = FirstPointsOfSides(data, numbering);
  const Triangles triangles = TrianglesOfSides(input, firstPoints);
  const std::vector<SurfaceLocation> locations =
    Locate(input->GetPoints(), firstPoints, triangles, positions);
  const vtkSmartPointer<vtkIdList> nearest = NearestPoints(locations, triangles);
  for (int k = 0; k < data->GetNumberOfArrays(); ++k)
  {
    vtkAbstractArray* array = data->GetAbstractArray(k);
    const int attribute = data->IsArrayAnAttribute(k);
    vtkSmartPointer<vtkAbstractArray> values = array;
    if (!StaysWithPoint(data, array) && array->GetNumberOfTuples() == positions.rows())
    {
      values = Transfer(array, locations, triangles, nearest);
    }
    if (attribute == vtkDataSetAttributes::NORMALS && values != array && IsInterpolated(array))
    {
      Normalise(vtkDataArray::FastDownCast(values), locations);
    }
    const int index = result->AddArray(values);
    if (attribute >= 0)
    {
      result->SetActiveAttribute(index, attribute);
    }
  }
  return result;
}
}
