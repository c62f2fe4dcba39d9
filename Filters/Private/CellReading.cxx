// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CellReading.h"

#include "CellTriangulation.h"
#include "Core/Base/Threading.h"
#include "InputFaults.h"

#include "vtkArrayDispatch.h"
#include "vtkCellArray.h"
#include "vtkDataArrayRange.h"
#include "vtkPolyData.h"

#include <algorithm>

namespace lmo
{
namespace
{
/// \throw InputError if the offsets do not fit the connectivity, which only hand-made cells have.
void CheckOffsets(vtkCellArray* cells, const char* what)
{
  if (cells->GetNumberOfCells() > 0 && !cells->IsValid())
  {
    throw InputError("The offsets of the " + std::to_string(cells->GetNumberOfCells()) + " " +
                     what + " do not fit their connectivity. Repair the cells of the input.");
  }
}

constexpr const char* NamesNoPoint = "cell names a point that does not exist";
constexpr const char* NameNoPoint = "cells name a point that does not exist";
constexpr const char* RepairCells = "Repair the cells of the input.";

/// Copies the connectivity of a vtkCellArray that holds nothing but triangles.
struct CopyTriangles
{
  template <typename Array>
  void operator()(
    Array* connectivity, vtkIdType points, Triangles& triangles, Faults& outOfRange) const
  {
    const auto ids = vtk::DataArrayValueRange<1>(connectivity);
    const auto count = static_cast<Index>(triangles.rows());
    const auto isOutOfRange = [&](Index t)
    {
      const vtkIdType first = 3 * vtkIdType(t);
      const auto [least, most] = std::minmax(
        { vtkIdType(ids[first]), vtkIdType(ids[first + 1]), vtkIdType(ids[first + 2]) });
      return least < 0 || most >= points;
    };
    const Index faults = ParallelSum(count, Index(0),
      [&](Index& sum, Index t)
      {
        for (int corner = 0; corner < 3; ++corner)
        {
          triangles(t, corner) = static_cast<Index>(ids[3 * vtkIdType(t) + corner]);
        }
        sum += isOutOfRange(t);
      });
    for (Index t = 0; faults > 0 && t < count; ++t)
    {
      if (isOutOfRange(t))
      {
        outOfRange.Add(t);
      }
    }
  }
};

/// \throw InputError for cells with fewer points than \a leastSize and for ids of no point.
void CheckCells(vtkCellArray* cells, vtkIdType firstCell, vtkIdType leastSize, vtkIdType points)
{
  Faults tooSmall;
  Faults outOfRange;
  vtkIdType size = 0;
  const vtkIdType* ids = nullptr;
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
  {
    cells->GetCellAtId(cell, size, ids);
    if (size < leastSize)
    {
      tooSmall.Add(firstCell + cell);
    }
    if (std::any_of(ids, ids + size, [&](vtkIdType id) { return id < 0 || id >= points; }))
    {
      outOfRange.Add(firstCell + cell);
    }
  }
  tooSmall.ThrowIfAny("polygon has fewer than three corners",
    "polygons have fewer than three corners", "cell",
    "Remove them, for example with vtkCleanPolyData.");
  outOfRange.ThrowIfAny(NamesNoPoint, NameNoPoint, "cell", RepairCells);
}

/// The polygons if they are triangles.
/// \throw InputError for ids of no point.
Triangles CopyPolygons(vtkCellArray* polygons, vtkIdType firstCell, vtkIdType points)
{
  Triangles triangles(polygons->GetNumberOfCells(), 3);
  Faults outOfRange;
  vtkDataArray* connectivity = polygons->GetConnectivityArray();
  if (!vtkArrayDispatch::DispatchByValueType<vtkArrayDispatch::Integrals>::Execute(
        connectivity, CopyTriangles{}, points, triangles, outOfRange))
  {
    CopyTriangles{}(connectivity, points, triangles, outOfRange);
  }
  outOfRange.first += outOfRange.count > 0 ? firstCell : 0;
  outOfRange.ThrowIfAny(NamesNoPoint, NameNoPoint, "cell", RepairCells);
  return triangles;
}

/// Appends triangles and their cells; the cells of those that are there become explicit.
void Append(const CellTriangles& more, vtkIdType firstCell, SurfaceTriangles& mesh)
{
  std::vector<vtkIdType>& cells = mesh.triangleCells.cells;
  const Eigen::Index count = mesh.triangles.rows();
  for (auto t = static_cast<Eigen::Index>(cells.size()); t < count; ++t)
  {
    cells.push_back(mesh.triangleCells.firstPolygon + t);
  }
  for (const vtkIdType cell : more.cells)
  {
    cells.push_back(firstCell + cell);
  }
  mesh.triangles.conservativeResize(count + more.triangles.rows(), 3);
  mesh.triangles.bottomRows(more.triangles.rows()) = more.triangles;
}

/// The polygons, and the triangles that follow those of the polygons, as cells.
Polygons ReadPolygons(vtkCellArray* polygons, const Triangles& triangles)
{
  AdjacencyLists corners;
  corners.offsets.reserve(polygons->GetNumberOfCells() + 1);
  corners.offsets.push_back(0);
  corners.ids.reserve(polygons->GetNumberOfConnectivityIds());
  const auto endCell = [&] { corners.offsets.push_back(static_cast<Index>(corners.ids.size())); };
  vtkIdType size = 0;
  const vtkIdType* ids = nullptr;
  for (vtkIdType cell = 0; cell < polygons->GetNumberOfCells(); ++cell)
  {
    polygons->GetCellAtId(cell, size, ids);
    std::transform(ids, ids + size, std::back_inserter(corners.ids),
      [](vtkIdType id) { return static_cast<Index>(id); });
    endCell();
  }
  const vtkIdType ofPolygons =
    polygons->GetNumberOfConnectivityIds() - 2 * polygons->GetNumberOfCells();
  for (auto t = static_cast<Eigen::Index>(ofPolygons); t < triangles.rows(); ++t)
  {
    corners.ids.insert(corners.ids.end(), triangles.row(t).begin(), triangles.row(t).end());
    endCell();
  }
  return Polygons(std::move(corners));
}
}

SurfaceTriangles ReadTriangles(vtkPolyData* input)
{
  CheckOffsets(input->GetPolys(), "polygons");
  CheckOffsets(input->GetStrips(), "strips");
  SurfaceTriangles mesh;
  const vtkIdType points = input->GetNumberOfPoints();
  const vtkIdType firstPolygon = input->GetNumberOfVerts() + input->GetNumberOfLines();
  const vtkIdType firstStrip = firstPolygon + input->GetNumberOfPolys();
  vtkCellArray* polygons = input->GetPolys();
  mesh.triangleCells.firstPolygon = firstPolygon;
  if (polygons->IsHomogeneous() == 3)
  {
    mesh.triangles = CopyPolygons(polygons, firstPolygon, points);
  }
  else if (polygons->GetNumberOfCells() > 0)
  {
    CheckCells(polygons, firstPolygon, 3, points);
    Append(TriangulatePolygons(polygons, input->GetPoints()), firstPolygon, mesh);
  }
  if (input->GetNumberOfStrips() > 0)
  {
    CheckCells(input->GetStrips(), firstStrip, 0, points);
    Append(TriangulateStrips(input->GetStrips()), firstStrip, mesh);
  }
  if (polygons->GetNumberOfConnectivityIds() > 3 * polygons->GetNumberOfCells())
  {
    mesh.polygons = ReadPolygons(polygons, mesh.triangles);
  }
  return mesh;
}
}
