// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "PointDataInterpolation.h"

#include "CellReading.h"
#include "Core/Base/Threading.h"
#include "Core/Mesh/MeshTopology.h"
#include "Core/Mesh/SurfaceWalk.h"
#include "Core/Mesh/TriangleBvh.h"
#include "Core/Mesh/TriangleGeometry.h"
#include "Core/Operators/VertexGradients.h"

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
#include <utility>
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

/// Where the output points lie on a surface.
struct PlacesOnSurface
{
  Points V;            ///< the points of the surface
  Triangles triangles; ///< connected where there is no seam
  AdjacencyLists cornersAt;
  VertexGradients gradients;
  std::vector<SurfaceLocation> locations; ///< no triangle for points that did not move

  PlacesOnSurface(vtkPolyData* surface, const std::vector<Index>& firstPoints)
    : V(PointsOf(surface->GetPoints()))
    , triangles(TrianglesOfSides(surface, firstPoints))
    , cornersAt(CornersAtVertices(static_cast<Index>(this->V.rows()), this->triangles))
    , gradients(this->V, this->triangles, this->cornersAt)
  {
  }
  PlacesOnSurface(const PlacesOnSurface&) = delete;
  void operator=(const PlacesOnSurface&) = delete;

  /// Of the surface's own points, from where they were.
  void Follow(const std::vector<Index>& firstPoints, const Points& positions)
  {
    this->locations.resize(positions.rows());
    ParallelFor(static_cast<Index>(positions.rows()),
      [&](Index i)
      {
        if (positions.row(i) != this->V.row(i))
        {
          this->locations[i] = WalkToClosestPoint(
            this->V, this->triangles, this->cornersAt, firstPoints[i], positions.row(i));
        }
      });
  }

  /// Of any points.
  void FindClosest(const Points& positions)
  {
    ProgressMonitor unwatched;
    const TriangleBvh tree(this->V, this->triangles, unwatched);
    this->locations.resize(positions.rows());
    ParallelFor(static_cast<Index>(positions.rows()),
      [&](Index i)
      {
        const Index closest = tree.FindClosest(positions.row(i)).triangle;
        this->locations[i] = WalkToClosestPoint(
          this->V, this->triangles, this->cornersAt, this->triangles(closest, 0), positions.row(i));
      });
  }

private:
  static Points PointsOf(vtkPoints* points)
  {
    Points V(points->GetNumberOfPoints(), 3);
    ParallelFor(
      static_cast<Index>(V.rows()), [&](Index i) { points->GetPoint(i, V.row(i).data()); });
    return V;
  }
};

/// The corner with the largest weight, the point itself where there is no triangle.
vtkSmartPointer<vtkIdList> NearestPoints(const PlacesOnSurface& places)
{
  const std::vector<SurfaceLocation>& locations = places.locations;
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
      point, locations[i].triangle >= 0 ? places.triangles(locations[i].triangle, corner) : point);
  }
  return nearest;
}

/// Barycentric interpolation, for floating-point arrays with half of what limited gradients at the
/// corners add, which makes the error of smooth fields smaller:
///   sum_k w_k (f_k + g_k . (x - x_k) / 2).
struct Interpolate
{
  const PlacesOnSurface& places;
  bool isRounded;

  template <typename Array>
  void operator()(Array* from, vtkDataArray* output) const
  {
    const auto input = vtk::DataArrayTupleRange(from);
    auto result = vtk::DataArrayTupleRange(Array::FastDownCast(output));
    for (int c = 0; c < from->GetNumberOfComponents(); ++c)
    {
      const auto field = [&](Index j) { return static_cast<double>(input[j][c]); };
      const Points gradients = this->GradientsOf(field);
      const std::pair<double, double> range = this->RangeOf(field);
      ParallelFor(static_cast<Index>(this->places.locations.size()),
        [&, this](Index i)
        {
          const SurfaceLocation& location = this->places.locations[i];
          if (location.triangle >= 0)
          {
            // Round-off must not lead out of the range.
            const double value =
              std::clamp(this->ValueAt(location, field, gradients), range.first, range.second);
            result[i][c] =
              static_cast<vtk::GetAPIType<Array>>(this->isRounded ? std::round(value) : value);
          }
        });
    }
  }

private:
  template <typename Field>
  Points GradientsOf(const Field& field) const
  {
    Points gradients(this->isRounded ? 0 : this->places.V.rows(), 3);
    ParallelFor(static_cast<Index>(gradients.rows()),
      [&, this](Index i) { gradients.row(i) = this->places.gradients.LimitedAt(i, field); });
    return gradients;
  }

  template <typename Field>
  std::pair<double, double> RangeOf(const Field& field) const
  {
    std::pair<double, double> range(HUGE_VAL, -HUGE_VAL);
    for (Index i = 0; i < static_cast<Index>(this->places.V.rows()); ++i)
    {
      range.first = std::min(range.first, field(i));
      range.second = std::max(range.second, field(i));
    }
    return range;
  }

  template <typename Field>
  double ValueAt(const SurfaceLocation& location, const Field& field, const Points& gradients) const
  {
    const auto corners = this->places.triangles.row(location.triangle);
    const TriangleCorners x = CornersOf(this->places.V, this->places.triangles, location.triangle);
    const Vector3 position = location.weights * x;
    const double first = field(corners[0]);
    double value = first; // what is added to it vanishes exactly where the field is constant
    double correction = 0;
    bool isDefined = gradients.rows() > 0;
    for (int k = 0; k < 3; ++k)
    {
      const double weight = location.weights[k];
      value += weight * (field(corners[k]) - first);
      isDefined = isDefined && (weight == 0 || this->places.gradients.IsDefined(corners[k]));
      correction += isDefined ? weight * gradients.row(corners[k]).dot(position - x.row(k)) / 2 : 0;
    }
    return isDefined ? value + correction : value;
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

/// The values of the surface's array at the locations.
vtkSmartPointer<vtkAbstractArray> Transfer(
  vtkAbstractArray* array, const PlacesOnSurface& places, vtkIdList* nearest)
{
  const auto size = static_cast<vtkIdType>(places.locations.size());
  auto result = vtk::TakeSmartPointer(array->NewInstance());
  result->DeepCopy(array);
  if (result->GetNumberOfTuples() != size)
  {
    result->SetNumberOfTuples(size);
  }
  if (!IsInterpolated(array))
  {
    array->GetTuples(nearest, result);
    return result;
  }
  const Interpolate interpolate{ places, array->GetDataType() == VTK_UNSIGNED_CHAR };
  vtkDataArray* from = vtkDataArray::FastDownCast(array);
  vtkDataArray* to = vtkDataArray::FastDownCast(result);
  if (!vtkArrayDispatch::DispatchByValueType<vtkArrayDispatch::Reals>::Execute(
        from, interpolate, to))
  {
    interpolate(from, to);
  }
  return result;
}

/// Adds the values of an array, which keeps its role.
void AddArray(vtkPointData* from, int k, vtkAbstractArray* values, vtkPointData* to)
{
  const int attribute = from->IsArrayAnAttribute(k);
  const int index = to->AddArray(values);
  if (attribute >= 0)
  {
    to->SetActiveAttribute(index, attribute);
  }
}

/// The values of the surface's k-th array at the locations, normals of unit length.
vtkSmartPointer<vtkAbstractArray> TransferArray(
  vtkPointData* data, int k, const PlacesOnSurface& places, vtkIdList* nearest)
{
  vtkAbstractArray* array = data->GetAbstractArray(k);
  vtkSmartPointer<vtkAbstractArray> values = Transfer(array, places, nearest);
  if (data->IsArrayAnAttribute(k) == vtkDataSetAttributes::NORMALS && IsInterpolated(array))
  {
    Normalise(vtkDataArray::FastDownCast(values), places.locations);
  }
  return values;
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
  PlacesOnSurface places(input, firstPoints);
  places.Follow(firstPoints, positions);
  const vtkSmartPointer<vtkIdList> nearest = NearestPoints(places);
  for (int k = 0; k < data->GetNumberOfArrays(); ++k)
  {
    vtkAbstractArray* array = data->GetAbstractArray(k);
    const bool stays =
      StaysWithPoint(data, array) || array->GetNumberOfTuples() != positions.rows();
    AddArray(data, k, stays ? array : TransferArray(data, k, places, nearest).Get(), result);
  }
  return result;
}

vtkSmartPointer<vtkPointData> PointDataAt(
  vtkPolyData* surface, const MeshNumbering& numbering, const Points& positions)
{
  vtkPointData* data = surface->GetPointData();
  auto result = vtkSmartPointer<vtkPointData>::New();
  if (data->GetNumberOfArrays() == 0 || positions.rows() == 0)
  {
    return result;
  }
  PlacesOnSurface places(surface, FirstPointsOfSides(data, numbering));
  places.FindClosest(positions);
  const vtkSmartPointer<vtkIdList> nearest = NearestPoints(places);
  for (int k = 0; k < data->GetNumberOfArrays(); ++k)
  {
    vtkAbstractArray* array = data->GetAbstractArray(k);
    if (!StaysWithPoint(data, array) && array->GetNumberOfTuples() == places.V.rows())
    {
      AddArray(data, k, TransferArray(data, k, places, nearest), result);
    }
  }
  return result;
}
}
