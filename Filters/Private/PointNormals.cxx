// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "PointNormals.h"

#include "CellReading.h"
#include "Core/Base/Threading.h"
#include "Core/Mesh/TriangleGeometry.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

namespace lmo
{
namespace
{
Triangles ByFirstPoints(Triangles triangles, const MeshNumbering& numbering)
{
  ParallelFor(static_cast<Index>(triangles.rows()),
    [&](Index t)
    {
      for (int k = 0; k < 3; ++k)
      {
        triangles(t, k) = numbering.FirstPointOf(numbering.VertexOf(triangles(t, k)));
      }
    });
  return triangles;
}

Points NormalsOf(const Points& V, const Triangles& triangles)
{
  MeshTopology topology;
  topology.vertices = static_cast<Index>(V.rows());
  topology.cornersAt = CornersAtVertices(topology.vertices, triangles);
  return VertexNormals(V, triangles, topology);
}
}

Points NormalsOfMergedPoints(
  vtkPolyData* input, const Points& positions, const MeshNumbering& numbering)
{
  const auto size = static_cast<Index>(positions.rows());
  Points V(size, 3);
  Points inputNormals(size, 3);
  for (Index i = 0; i < size; ++i)
  {
    input->GetPoint(i, V.row(i).data());
    input->GetPointData()->GetNormals()->GetTuple(i, inputNormals.row(i).data());
  }
  const Triangles own = ReadTriangles(input).triangles;
  const Triangles merged = ByFirstPoints(own, numbering);
  const Points ownBefore = NormalsOf(V, own);
  const Points mergedBefore = NormalsOf(V, merged);
  const Points mergedNow = NormalsOf(positions, merged);
  Points normals = NormalsOf(positions, own);
  ParallelFor(size,
    [&](Index i)
    {
      const Index first = numbering.FirstPointOf(numbering.VertexOf(i));
      const Vector3 normal = inputNormals.row(i);
      if (normal.dot(mergedBefore.row(first)) >= normal.dot(ownBefore.row(i)))
      {
        normals.row(i) = mergedNow.row(first);
      }
    });
  return normals;
}
}
