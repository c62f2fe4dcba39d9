// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CellTriangulation.h"

#include "Core/Base/Threading.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolygon.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace lmo
{
namespace
{
/// Room for n - 2 triangles of each cell with n points, with the cells entered.
CellTriangles MakeTriangles(vtkCellArray* cells)
{
  CellTriangles result;
  result.cells.reserve(cells->GetNumberOfConnectivityIds());
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
  {
    const vtkIdType triangles = std::max<vtkIdType>(cells->GetCellSize(cell) - 2, 0);
    result.cells.insert(result.cells.end(), triangles, cell);
  }
  result.triangles.resize(static_cast<Eigen::Index>(result.cells.size()), 3);
  return result;
}

/// Calls triangulate(ids, triangle) for each cell with the points of the cell and the row of its
/// first triangle.
/// \param makeTriangulate called once for each thread
template <typename MakeTriangulate>
void ForEachCell(
  vtkCellArray* cells, const CellTriangles& result, const MakeTriangulate& makeTriangulate)
{
  ParallelRanges(static_cast<Index>(result.cells.size()),
    [&](std::ptrdiff_t begin, std::ptrdiff_t end)
    {
      vtkNew<vtkIdList> ids;
      const auto triangulate = makeTriangulate();
      for (std::ptrdiff_t t = begin; t < end; ++t)
      {
        const vtkIdType cell = result.cells[t];
        if (t == 0 || result.cells[t - 1] != cell)
        {
          cells->GetCellAtId(cell, ids);
          triangulate(ids.Get(), static_cast<Eigen::Index>(t));
        }
      }
    });
}

/// Cuts one polygon after the other.
class PolygonCutter
{
public:
  PolygonCutter(vtkPoints* points, Triangles& triangles)
    : Points(points)
    , Result(triangles)
  {
  }

  void operator()(vtkIdList* ids, Eigen::Index firstTriangle) const
  {
    const vtkIdType size = ids->GetNumberOfIds();
    if (size == 4)
    {
      this->CutQuad(ids);
    }
    else if (size == 3 || !this->CutEars(ids))
    {
      this->Fan(ids, 0);
    }
    for (Eigen::Index corner = 0; corner < 3 * (size - 2); ++corner)
    {
      this->Result.data()[3 * firstTriangle + corner] =
        static_cast<Index>(this->Corners->GetId(corner));
    }
  }

private:
  Vector3 Point(vtkIdType id) const
  {
    Vector3 point;
    this->Points->GetPoint(id, point.data());
    return point;
  }

  void CutQuad(vtkIdList* ids) const
  {
    Vector3 diagonals[2];
    bool isInside[2];
    for (vtkIdType k : { 0, 1 })
    {
      const Vector3 start = this->Point(ids->GetId(k));
      diagonals[k] = this->Point(ids->GetId(k + 2)) - start;
      const Vector3 right = (this->Point(ids->GetId(k + 1)) - start).cross(diagonals[k]);
      const Vector3 left = diagonals[k].cross(this->Point(ids->GetId((k + 3) % 4)) - start);
      isInside[k] = right.dot(left) > 0;
    }
    const bool isSecondShorter = diagonals[1].squaredNorm() < diagonals[0].squaredNorm();
    this->Fan(ids, isInside[0] == isInside[1] ? isSecondShorter : isInside[1]);
  }

  bool CutEars(vtkIdList* ids) const
  {
    const vtkIdType size = ids->GetNumberOfIds();
    this->Polygon->GetPointIds()->DeepCopy(ids);
    this->Polygon->GetPoints()->SetNumberOfPoints(size);
    for (vtkIdType k = 0; k < size; ++k)
    {
      this->Polygon->GetPoints()->SetPoint(k, this->Point(ids->GetId(k)).data());
    }
    return this->Polygon->Triangulate(0, this->Corners, this->CornerPoints) &&
           this->Corners->GetNumberOfIds() == 3 * (size - 2);
  }

  /// Triangles around one corner.
  void Fan(vtkIdList* ids, vtkIdType corner) const
  {
    const vtkIdType size = ids->GetNumberOfIds();
    this->Corners->Reset();
    for (vtkIdType k = corner + 1; k + 1 < corner + size; ++k)
    {
      for (const vtkIdType place : { corner, k, k + 1 })
      {
        this->Corners->InsertNextId(ids->GetId(place % size));
      }
    }
  }

  vtkPoints* Points;
  Triangles& Result;
  vtkNew<vtkPolygon> Polygon;
  vtkNew<vtkIdList> Corners;
  vtkNew<vtkPoints> CornerPoints;
};
}

CellTriangles TriangulatePolygons(vtkCellArray* polygons, vtkPoints* points)
{
  CellTriangles result = MakeTriangles(polygons);
  ForEachCell(polygons, result, [&] { return PolygonCutter(points, result.triangles); });
  return result;
}

CellTriangles TriangulateStrips(vtkCellArray* strips)
{
  CellTriangles result = MakeTriangles(strips);
  const auto takeApart = [&result](vtkIdList* ids, Eigen::Index firstTriangle)
  {
    for (vtkIdType k = 0; k + 2 < ids->GetNumberOfIds(); ++k)
    {
      // Every second triangle of a strip is stored clockwise.
      const vtkIdType odd = k % 2;
      result.triangles.row(firstTriangle + k) << static_cast<Index>(ids->GetId(k)),
        static_cast<Index>(ids->GetId(k + 1 + odd)), static_cast<Index>(ids->GetId(k + 2 - odd));
    }
  };
  ForEachCell(strips, result, [&] { return takeApart; });
  return result;
}
}
