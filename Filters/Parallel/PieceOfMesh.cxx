// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "PieceOfMesh.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkGenerateGlobalIds.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

namespace lmo
{
namespace
{
std::vector<GlobalId> ReadIds(vtkDataArray* array)
{
  std::vector<GlobalId> ids(array ? array->GetNumberOfTuples() : 0);
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    ids[i] = static_cast<GlobalId>(array->GetTuple1(static_cast<vtkIdType>(i)));
  }
  return ids;
}

/// Ids by which points of all processes are the same one: those of the input, or by coordinates.
std::vector<GlobalId> GlobalIds(
  vtkPolyData* input, const Communicator& comm, vtkMultiProcessController* controller)
{
  vtkDataArray* ids = input->GetPointData()->GetGlobalIds();
  const bool isMissing = input->GetNumberOfPoints() > 0 && !ids;
  if (comm.Maximum(isMissing) == 0)
  {
    return ReadIds(ids);
  }
  vtkNew<vtkPolyData> points;
  points->SetPoints(input->GetPoints());
  vtkNew<vtkGenerateGlobalIds> generator;
  generator->SetController(controller);
  generator->SetInputData(points);
  generator->Update();
  return ReadIds(vtkPolyData::SafeDownCast(generator->GetOutput())->GetPointData()->GetGlobalIds());
}

/// The triangles of the cells that are not marked as duplicates.
Triangles TrianglesThatCount(vtkPolyData* input, const SurfaceMesh& mesh)
{
  const Triangles& triangles = mesh.triangles;
  auto* ghosts = vtkUnsignedCharArray::SafeDownCast(
    input->GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName()));
  if (!ghosts)
  {
    return triangles;
  }
  Triangles counted(triangles.rows(), 3);
  Eigen::Index count = 0;
  for (Index t = 0; t < triangles.rows(); ++t)
  {
    if (!(ghosts->GetValue(mesh.numbering.CellOf(t)) & vtkDataSetAttributes::DUPLICATECELL))
    {
      counted.row(count++) = triangles.row(t);
    }
  }
  counted.conservativeResize(count, 3);
  return counted;
}
}

Piece TakePiece(vtkPolyData* input, SurfaceMesh& mesh, const Communicator& comm,
  vtkMultiProcessController* controller)
{
  Piece piece;
  piece.triangles = TrianglesThatCount(input, mesh);
  piece.points = std::move(mesh.points);
  if (comm.Sum(std::int64_t(input->GetNumberOfPoints())) > 0)
  {
    piece.ids = GlobalIds(input, comm, controller);
  }
  return piece;
}
}
