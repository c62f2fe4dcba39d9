// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "PointDataInterpolation.h"

#include "ArrayTransfer.h"
#include "CellReading.h"
#include "Core/Base/Threading.h"
#include "Core/Mesh/MeshTopology.h"
#include "Core/Mesh/SurfaceWalk.h"
#include "Core/Mesh/TriangleBvh.h"
#include "Core/Operators/MeshQuantities.h"

#include "vtkDataSetAttributes.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cstring>
#include <map>
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

/// The interpolated arrays but the normals.
std::vector<vtkDataArray*> InterpolatedArrays(vtkPointData* data)
{
  std::vector<vtkDataArray*> arrays;
  for (int k = 0; k < data->GetNumberOfArrays(); ++k)
  {
    vtkAbstractArray* array = data->GetAbstractArray(k);
    if (IsInterpolated(array) && array != data->GetNormals())
    {
      arrays.push_back(vtkDataArray::FastDownCast(array));
    }
  }
  return arrays;
}

/// For each point the first point of the same vertex that is on the same side of all seams.
std::vector<Index> FirstPointsOfSides(vtkPointData* data, const MeshNumbering& numbering)
{
  const auto size = static_cast<Index>(numbering.GetNumberOfPoints());
  const std::vector<vtkDataArray*> arrays = InterpolatedArrays(data);
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

Points PositionsOf(vtkPolyData* surface)
{
  Points positions(surface->GetNumberOfPoints(), 3);
  ParallelFor(static_cast<Index>(positions.rows()),
    [&](Index i) { surface->GetPoint(i, positions.row(i).data()); });
  return positions;
}

/// A surface whose vertices are its points, connected where there is no seam.
struct SurfaceOfSides
{
  std::vector<Index> firstPoints; ///< FirstPointsOfSides()
  Points V;
  Triangles triangles;
  AdjacencyLists cornersAt;

  SurfaceOfSides(vtkPolyData* surface, vtkPointData* data, const MeshNumbering& numbering)
    : firstPoints(FirstPointsOfSides(data, numbering))
    , V(PositionsOf(surface))
    , triangles(TrianglesOfSides(surface, this->firstPoints))
    , cornersAt(CornersAtVertices(static_cast<Index>(this->V.rows()), this->triangles))
  {
  }

  WalkableSurface View() const { return { this->V, this->triangles, this->cornersAt }; }
};

/// The places of vertices that moved along the surface.
/// \param start start(i): a vertex at which triangles begin that are where vertex i was
template <typename Start>
std::vector<SurfaceLocation> PlacesOfMoved(
  const WalkableSurface& surface, const Points& positions, const Start& start)
{
  std::vector<SurfaceLocation> places(positions.rows());
  ParallelFor(static_cast<Index>(positions.rows()),
    [&](Index i)
    {
      if (positions.row(i) != surface.V.row(i))
      {
        places[i] = WalkToClosestPoint(surface, start(i), positions.row(i));
      }
    });
  return places;
}

/// The places on the surface that are closest to any positions.
std::vector<SurfaceLocation> ClosestPlaces(const WalkableSurface& surface, const Points& positions)
{
  ProgressMonitor unwatched;
  const TriangleBvh tree(surface.V, surface.triangles, unwatched);
  std::vector<SurfaceLocation> places(positions.rows());
  ParallelFor(static_cast<Index>(positions.rows()),
    [&](Index i)
    {
      const Index closest = tree.FindClosest(positions.row(i)).triangle;
      places[i] = WalkToClosestPoint(surface, surface.triangles(closest, 0), positions.row(i));
    });
  return places;
}

bool StaysWithPoint(vtkPointData* data, vtkAbstractArray* array)
{
  const char* name = array->GetName() ? array->GetName() : "";
  return array == data->GetAbstractAttribute(vtkDataSetAttributes::GLOBALIDS) ||
         array == data->GetAbstractAttribute(vtkDataSetAttributes::PEDIGREEIDS) ||
         std::strcmp(name, "vtkOriginalPointIds") == 0 ||
         std::strcmp(name, vtkDataSetAttributes::GhostArrayName()) == 0;
}

/// Gives the normals at places unit length.
void Normalise(
  vtkDataArray* normals, const MeshNumbering& numbering, const std::vector<SurfaceLocation>& places)
{
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    if (places[i].triangle >= 0)
    {
      const Index point = numbering.FirstPointOf(static_cast<Index>(i));
      Vector3 normal;
      normals->GetTuple(point, normal.data());
      normals->SetTuple(point, Vector3(normal.stableNormalized()).data());
    }
  }
}

void Normalise(vtkDataArray* normals)
{
  for (vtkIdType i = 0; i < normals->GetNumberOfTuples(); ++i)
  {
    Vector3 normal;
    normals->GetTuple(i, normal.data());
    normals->SetTuple(i, Vector3(normal.stableNormalized()).data());
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

/// Point data of a surface at places on it.
/// \param numbering of the surface's vertices and of the places
/// \param stays stays(array) for arrays that are passed as they are
template <typename Stays>
vtkSmartPointer<vtkPointData> TransferAll(vtkPointData* data, const WalkableSurface& surface,
  const MeshNumbering& numbering, const std::vector<SurfaceLocation>& places, const Stays& stays)
{
  auto result = vtkSmartPointer<vtkPointData>::New();
  ArrayTransfer transfer;
  for (int k = 0; k < data->GetNumberOfArrays(); ++k)
  {
    vtkSmartPointer<vtkAbstractArray> values = data->GetAbstractArray(k);
    if (!stays(values))
    {
      values = transfer.Add(values, places.size());
    }
    AddArray(data, k, values, result);
  }
  transfer.Run(surface, numbering, places);
  vtkDataArray* normals = result->GetNormals();
  if (normals && normals != data->GetNormals() && IsInterpolated(normals))
  {
    Normalise(normals, numbering, places);
  }
  return result;
}
}

std::vector<MovingArray> FindMovingArrays(vtkPolyData* input)
{
  vtkPointData* data = input->GetPointData();
  std::vector<MovingArray> arrays;
  for (int k = 0; k < data->GetNumberOfArrays(); ++k)
  {
    vtkDataArray* array = data->GetArray(k);
    if (array && array->GetName() && !StaysWithPoint(data, array) &&
        array->GetNumberOfTuples() == input->GetNumberOfPoints())
    {
      arrays.push_back(
        { array->GetName(), array->GetNumberOfComponents(), HowToInterpolate(array) });
    }
  }
  return arrays;
}

vtkSmartPointer<vtkPointData> MoveArrays(vtkPolyData* input, const MeshNumbering& numbering,
  const std::vector<MovingArray>& arrays, const MoveFieldsAs& move)
{
  vtkPointData* data = input->GetPointData();
  std::map<std::string, vtkSmartPointer<vtkDataArray>> moved;
  for (const auto& [name, components, how] : arrays)
  {
    moved[name] = ArrayAtPlaces(data->GetArray(name.c_str()), components, numbering,
      [&move, how = how](const Fields& fields) { return move(fields, how); });
  }
  auto result = vtkSmartPointer<vtkPointData>::New();
  for (int k = 0; k < data->GetNumberOfArrays(); ++k)
  {
    vtkAbstractArray* array = data->GetAbstractArray(k);
    const auto found = moved.find(array->GetName() ? array->GetName() : "");
    AddArray(data, k, found == moved.end() ? array : found->second, result);
  }
  vtkDataArray* normals = result->GetNormals();
  if (normals && normals != data->GetNormals() && IsInterpolated(normals))
  {
    Normalise(normals);
  }
  return result;
}

vtkSmartPointer<vtkPointData> InterpolatePointData(vtkPolyData* input, const MeshQuantities& mesh,
  const MeshNumbering& numbering, const Points& positions)
{
  vtkPointData* data = input->GetPointData();
  const auto stays = [&](vtkAbstractArray* array) {
    return StaysWithPoint(data, array) || array->GetNumberOfTuples() != input->GetNumberOfPoints();
  };
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
  if (!numbering.HasMergedPoints())
  {
    const WalkableSurface surface{ mesh.GetPoints(), mesh.GetTriangles(),
      mesh.GetTopology().cornersAt };
    const auto places = PlacesOfMoved(surface, positions, [](Index i) { return i; });
    return TransferAll(data, surface, numbering, places, stays);
  }
  const SurfaceOfSides sides(input, data, numbering);
  const auto places = PlacesOfMoved(
    sides.View(), numbering.ToPoints(positions), [&](Index i) { return sides.firstPoints[i]; });
  return TransferAll(data, sides.View(), MeshNumbering(), places, stays);
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
  const SurfaceOfSides sides(surface, data, numbering);
  return TransferAll(data, sides.View(), MeshNumbering(), ClosestPlaces(sides.View(), positions),
    [](vtkAbstractArray*) { return false; });
}
}
