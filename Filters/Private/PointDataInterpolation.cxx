// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "PointDataInterpolation.h"

#include "ArrayTransfer.h"
#include "CellReading.h"
#include "Core/Base/Threading.h"
#include "Core/Mesh/MeshTopology.h"
#include "Core/Mesh/SurfaceWalk.h"
#include "Core/Mesh/TriangleBvh.h"
#include "Core/Mesh/TriangleGeometry.h"

#include "vtkDataSetAttributes.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cstring>
#include <numeric>
#include <unordered_map>
#include <vector>

namespace lmo
{
namespace
{
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
  std::vector<SurfaceLocation> locations; ///< no triangle for points that did not move

  PlacesOnSurface(vtkPolyData* surface, const std::vector<Index>& firstPoints)
    : V(PointsOf(surface->GetPoints()))
    , triangles(TrianglesOfSides(surface, firstPoints))
    , cornersAt(CornersAtVertices(static_cast<Index>(this->V.rows()), this->triangles))
  {
  }

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

/// Point data of a surface at the locations.
/// \param stays stays(array) for arrays that are passed as they are
template <typename Stays>
vtkSmartPointer<vtkPointData> TransferAll(
  vtkPointData* data, const PlacesOnSurface& places, const Stays& stays)
{
  auto result = vtkSmartPointer<vtkPointData>::New();
  ArrayTransfer transfer;
  for (int k = 0; k < data->GetNumberOfArrays(); ++k)
  {
    vtkSmartPointer<vtkAbstractArray> values = data->GetAbstractArray(k);
    if (!stays(values))
    {
      values = transfer.Add(values, places.locations.size());
    }
    AddArray(data, k, values, result);
  }
  transfer.Run(places.V, places.triangles, places.cornersAt, places.locations);
  vtkDataArray* normals = result->GetNormals();
  if (normals && normals != data->GetNormals() && IsInterpolated(normals))
  {
    Normalise(normals, places.locations);
  }
  return result;
}
}

vtkSmartPointer<vtkPointData> InterpolatePointData(
  vtkPolyData* input, const MeshNumbering& numbering, const Points& positions)
{
  vtkPointData* data = input->GetPointData();
  const auto stays = [&](vtkAbstractArray* array)
  { return StaysWithPoint(data, array) || array->GetNumberOfTuples() != positions.rows(); };
  bool areAllStaying = true;
  for (int k = 0; k < data->GetNumberOfArrays(); ++k)
  {
    areAllStaying = areAllStaying && stays(data->GetAbstractArray(k));
  }
  if (areAllStaying || positions.rows() == 0)
  {
    auto result = vtkSmartPointer<vtkPointData>::New();
    result->ShallowCopy(data);
    return result;
  }
  const std::vector<Index> firstPoints = FirstPointsOfSides(data, numbering);
  PlacesOnSurface places(input, firstPoints);
  places.Follow(firstPoints, positions);
  return TransferAll(data, places, stays);
}

vtkSmartPointer<vtkPointData> PointDataAt(
  vtkPolyData* surface, const MeshNumbering& numbering, const Points& positions)
{
  vtkNew<vtkPointData> data;
  data->ShallowCopy(surface->GetPointData());
  for (int k = data->GetNumberOfArrays() - 1; k >= 0; --k)
  {
    vtkAbstractArray* array = data->GetAbstractArray(k);
    if (StaysWithPoint(data, array) || array->GetNumberOfTuples() != surface->GetNumberOfPoints())
    {
      data->RemoveArray(k);
    }
  }
  if (data->GetNumberOfArrays() == 0 || positions.rows() == 0)
  {
    return vtkSmartPointer<vtkPointData>::New();
  }
  PlacesOnSurface places(surface, FirstPointsOfSides(data, numbering));
  places.FindClosest(positions);
  return TransferAll(data, places, [](vtkAbstractArray*) { return false; });
}
}
