// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "JoinedPieces.h"

#include "Core/Mesh/TriangleQuality.h"
#include "PieceAppending.h"
#include "PolyDataConversion.h"
#include "ResultArrays.h"
#include "SharedPoints.h"

#include "vtkCellData.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace lmo
{
namespace
{
/// The global ids of the points of all pieces; none if a piece has none.
std::vector<std::int64_t> GlobalIdsOf(const SurfacePieces& pieces)
{
  std::vector<std::int64_t> ids;
  for (vtkPolyData* piece : pieces)
  {
    vtkDataArray* array = piece->GetPointData()->GetGlobalIds();
    if (!array && piece->GetNumberOfPoints() > 0)
    {
      return {};
    }
    for (vtkIdType i = 0; i < piece->GetNumberOfPoints(); ++i)
    {
      ids.push_back(static_cast<std::int64_t>(array->GetTuple1(i)));
    }
  }
  return ids;
}
}

bool JoinedPieces::Source::operator==(vtkPolyData* piece) const
{
  return this->data == piece && this->time == piece->GetMTime();
}

JoinedPieces::JoinedPieces(const SurfacePieces& pieces, Joining joining)
  : How(joining)
{
  vtkIdType points = 0;
  vtkIdType cells = 0;
  for (vtkPolyData* piece : pieces)
  {
    this->Sources.push_back({ piece, piece->GetMTime(), points, cells });
    points += piece->GetNumberOfPoints();
    cells += piece->GetNumberOfCells();
  }
  AppendedPieces appended = AppendPieces(pieces, joining);
  this->Surface = appended.surface;
  this->Cells = std::move(appended.cells);
  for (vtkPolyData* piece : pieces)
  {
    ResultArrays::AddMissing(piece->GetFieldData(), this->Surface->GetFieldData(), true);
  }
  if (joining == Joining::ONE_SURFACE)
  {
    this->FindFirstPoints(pieces);
    this->FindOriginalsOfGhosts(pieces);
  }
}

void JoinedPieces::FindFirstPoints(const SurfacePieces& pieces)
{
  const SurfaceMesh mesh = ReadMesh(this->Surface);
  const std::vector<std::int64_t> ids = GlobalIdsOf(pieces);
  if (!ids.empty())
  {
    this->FirstPoints = FindPointsOfSameId(mesh.points, ids);
    return;
  }
  std::vector<Index> pieceOf;
  for (std::size_t k = 0; k < pieces.size(); ++k)
  {
    pieceOf.resize(pieceOf.size() + pieces[k]->GetNumberOfPoints(), static_cast<Index>(k));
  }
  this->FirstPoints = FindPointsOfSamePlace(mesh.points, mesh.triangles, pieceOf);
}

void JoinedPieces::FindOriginalsOfGhosts(const SurfacePieces& pieces)
{
  using Corners = std::vector<Index>;
  const vtkIdType size = this->Surface->GetNumberOfPoints();
  const auto cornersOf = [&](vtkIdList* points, vtkIdType firstPoint)
  {
    Corners corners;
    for (const vtkIdType point : *points)
    {
      if (point < 0 || firstPoint + point >= size)
      {
        return Corners(); // such a ghost has no original, as cells of the surface are checked
      }
      const auto i = static_cast<Index>(firstPoint + point);
      corners.push_back(this->FirstPoints.empty() ? i : this->FirstPoints[i]);
    }
    std::sort(corners.begin(), corners.end());
    return corners;
  };
  std::map<Corners, std::vector<vtkIdType>> ghosts;
  for (std::size_t k = 0; k < pieces.size(); ++k)
  {
    const Source& source = this->Sources[k];
    const GhostCells isGhost(pieces[k]);
    if (isGhost.HasAny())
    {
      ForEachCell(pieces[k],
        [&](int, vtkIdType cell, vtkIdList* points)
        {
          if (isGhost[cell])
          {
            ghosts[cornersOf(points, source.firstPoint)].push_back(source.firstCell + cell);
          }
        });
    }
  }
  if (ghosts.empty())
  {
    return;
  }
  ForEachCell(this->Surface,
    [&](int, vtkIdType cell, vtkIdList* points)
    {
      const auto copies = ghosts.find(cornersOf(points, 0));
      if (copies != ghosts.end())
      {
        std::for_each(copies->second.begin(), copies->second.end(),
          [&](vtkIdType number) { this->Cells[number] = cell; });
      }
    });
}

bool JoinedPieces::IsOf(const SurfacePieces& pieces, Joining joining) const
{
  return this->How == joining &&
         std::equal(this->Sources.begin(), this->Sources.end(), pieces.begin(), pieces.end());
}

vtkSmartPointer<vtkCellData> JoinedPieces::CellDataOf(
  vtkPolyData* piece, std::size_t k, vtkPolyData* optimized) const
{
  vtkNew<vtkIdList> cells;
  vtkNew<vtkIdList> missing; // ghosts whose originals are in no piece
  for (vtkIdType cell = 0; cell < piece->GetNumberOfCells(); ++cell)
  {
    const vtkIdType found = this->Cells[this->Sources[k].firstCell + cell];
    cells->InsertNextId(std::max<vtkIdType>(found, 0));
    if (found < 0)
    {
      missing->InsertNextId(cell);
    }
  }
  auto data = TuplesOf(optimized->GetCellData(), cells);
  for (int a = data->GetNumberOfArrays() - 1; a >= 0; --a)
  {
    vtkAbstractArray* array = data->GetAbstractArray(a);
    if (!ResultArrays::IsResult(array) && array != data->GetNormals())
    {
      data->RemoveArray(a);
    }
  }
  for (int a = 0; a < data->GetNumberOfArrays() && missing->GetNumberOfIds() > 0; ++a)
  {
    vtkAbstractArray* array = data->GetAbstractArray(a);
    vtkAbstractArray* own =
      array->GetName() ? piece->GetCellData()->GetAbstractArray(array->GetName()) : nullptr;
    auto* numbers = vtkDataArray::FastDownCast(array);
    if (own && own->GetDataType() == array->GetDataType())
    {
      array->InsertTuples(missing, missing, own);
    }
    else if (numbers)
    {
      const double none = numbers->GetDataType() == VTK_DOUBLE ? UndefinedQuality : 0;
      const std::vector<double> tuple(numbers->GetNumberOfComponents(), none);
      std::for_each(missing->begin(), missing->end(),
        [&](vtkIdType cell) { numbers->SetTuple(cell, tuple.data()); });
    }
  }
  return data;
}

vtkSmartPointer<vtkPolyData> JoinedPieces::HandBack(
  vtkPolyData* piece, std::size_t k, vtkPolyData* optimized, ResultArrays& results) const
{
  auto output = vtkSmartPointer<vtkPolyData>::New();
  output->ShallowCopy(piece);
  vtkNew<vtkIdList> ids;
  ids->SetNumberOfIds(piece->GetNumberOfPoints());
  std::iota(ids->begin(), ids->end(), this->Sources[k].firstPoint);
  if (ids->GetNumberOfIds() > 0)
  {
    vtkNew<vtkPoints> points;
    points->SetDataType(optimized->GetPoints()->GetDataType());
    points->SetNumberOfPoints(ids->GetNumberOfIds());
    optimized->GetPoints()->GetData()->GetTuples(ids, points->GetData());
    output->SetPoints(points);
  }
  results.HandOn(TuplesOf(optimized->GetPointData(), ids), output->GetPointData());
  results.HandOn(this->CellDataOf(piece, k, optimized), output->GetCellData());
  results.Renew(this->Surface->GetFieldData(), optimized->GetFieldData(), output->GetFieldData());
  return output;
}

const JoinedPieces& CachedJoin::Of(const SurfacePieces& pieces, Joining joining)
{
  if (!this->Joined || !this->Joined->IsOf(pieces, joining))
  {
    this->Joined.reset(); // its memory serves for the next one
    this->Joined = std::make_unique<const JoinedPieces>(pieces, joining);
  }
  return *this->Joined;
}
}
