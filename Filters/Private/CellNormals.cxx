// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CellNormals.h"

#include "vtkCellArray.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <Eigen/Geometry>

namespace lmo
{
namespace
{
/// Sum of the vector areas of the triangles of a fan, which is that of its polygon, or of a strip,
/// every other triangle of which is turned.
Vector3 VectorArea(vtkPoints* points, const vtkIdType* ids, vtkIdType size, bool isStrip)
{
  const auto at = [&](vtkIdType k)
  {
    Vector3 point;
    points->GetPoint(ids[k], point.data());
    return point;
  };
  Vector3 area = Vector3::Zero();
  for (vtkIdType k = 2; k < size; ++k)
  {
    const Vector3 origin = at(isStrip ? k - 2 : 0);
    const double sign = isStrip && k % 2 == 1 ? -1 : 1;
    area += sign * (at(k - 1) - origin).cross(at(k) - origin);
  }
  return area;
}

void AppendNormals(
  vtkPoints* points, vtkCellArray* cells, bool areStrips, Eigen::Index first, Points& normals)
{
  vtkIdType size = 0;
  const vtkIdType* ids = nullptr;
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
  {
    cells->GetCellAtId(cell, size, ids);
    const Vector3 area = VectorArea(points, ids, size, areStrips);
    const double length = area.stableNorm();
    normals.row(first + cell) = length > 0 ? Vector3(area / length) : Vector3(Vector3::Zero());
  }
}
}

Points CellNormals(vtkPolyData* mesh)
{
  Points normals = Points::Zero(mesh->GetNumberOfCells(), 3);
  const vtkIdType firstPolygon = mesh->GetNumberOfVerts() + mesh->GetNumberOfLines();
  AppendNormals(mesh->GetPoints(), mesh->GetPolys(), false, firstPolygon, normals);
  AppendNormals(
    mesh->GetPoints(), mesh->GetStrips(), true, firstPolygon + mesh->GetNumberOfPolys(), normals);
  return normals;
}
}
