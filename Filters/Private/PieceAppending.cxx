// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "PieceAppending.h"

#include "vtkAppendPolyData.h"
#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

namespace lmo
{
namespace
{
vtkUnsignedCharArray* MarksOf(vtkPolyData* data)
{
  auto* marks = vtkUnsignedCharArray::SafeDownCast(
    data->GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName()));
  const bool fits = marks && marks->GetNumberOfComponents() == 1 &&
                    marks->GetNumberOfTuples() == data->GetNumberOfCells();
  return fits ? marks : nullptr;
}

/// A cell array that tells the cells of all pieces apart while they are joined.
constexpr const char* CellNumbers = "vtkLaplacianMeshOptimizerCellNumbers";

/// A copy with the numbers of its cells.
vtkSmartPointer<vtkPolyData> NumberedCopy(vtkPolyData* piece, vtkIdType firstNumber)
{
  vtkNew<vtkIdTypeArray> numbers;
  numbers->SetName(CellNumbers);
  numbers->SetNumberOfTuples(piece->GetNumberOfCells());
  std::iota(numbers->GetPointer(0), numbers->GetPointer(numbers->GetNumberOfTuples()), firstNumber);
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->SetPoints(piece->GetPoints());
  copy->GetPointData()->ShallowCopy(piece->GetPointData());
  copy->GetCellData()->ShallowCopy(piece->GetCellData());
  copy->GetCellData()->AddArray(numbers);
  copy->SetVerts(piece->GetVerts());
  copy->SetLines(piece->GetLines());
  copy->SetPolys(piece->GetPolys());
  copy->SetStrips(piece->GetStrips());
  return copy;
}

/// All points stay.
void RemoveGhosts(vtkPolyData* data)
{
  const GhostCells ghosts(data);
  if (!ghosts.HasAny())
  {
    return;
  }
  vtkNew<vtkCellArray> kept[4];
  vtkNew<vtkIdList> ids;
  ForEachCell(data,
    [&](int kind, vtkIdType cell, vtkIdList* points)
    {
      if (!ghosts[cell])
      {
        kept[kind]->InsertNextCell(points);
        ids->InsertNextId(cell);
      }
    });
  data->GetCellData()->ShallowCopy(TuplesOf(data->GetCellData(), ids));
  data->SetVerts(kept[0]);
  data->SetLines(kept[1]);
  data->SetPolys(kept[2]);
  data->SetStrips(kept[3]);
}

/// Pieces that have no marks of ghosts would take them away from the others.
void MarkGhosts(vtkPolyData* data)
{
  if (!MarksOf(data))
  {
    vtkNew<vtkUnsignedCharArray> ghosts;
    ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
    ghosts->SetNumberOfTuples(data->GetNumberOfCells());
    ghosts->Fill(0);
    data->GetCellData()->AddArray(ghosts);
  }
}

/// vtkAppendPolyData appends no points if there are no cells.
void AddVertexCell(vtkPolyData* data, vtkIdType number)
{
  vtkNew<vtkCellArray> vertex;
  vertex->InsertNextCell({ 0 });
  data->SetVerts(vertex);
  vtkNew<vtkIdTypeArray> numbers;
  numbers->SetName(CellNumbers);
  numbers->InsertNextValue(number);
  data->GetCellData()->Initialize();
  data->GetCellData()->AddArray(numbers);
}

vtkSmartPointer<vtkPolyData> Append(const SurfacePieces& pieces)
{
  vtkNew<vtkAppendPolyData> append;
  for (vtkPolyData* piece : pieces)
  {
    append->AddInputData(piece);
  }
  if (pieces.empty())
  {
    return vtkSmartPointer<vtkPolyData>::New();
  }
  append->Update();
  return append->GetOutput();
}

/// The place of each number, which then leave the surface.
std::vector<vtkIdType> TakeNumbers(vtkPolyData* surface, vtkIdType count)
{
  std::vector<vtkIdType> cells(count, -1);
  vtkCellData* data = surface->GetCellData();
  auto* numbers = vtkIdTypeArray::SafeDownCast(data->GetArray(CellNumbers));
  for (vtkIdType cell = 0; numbers && cell < numbers->GetNumberOfTuples(); ++cell)
  {
    if (numbers->GetValue(cell) < count)
    {
      cells[numbers->GetValue(cell)] = cell;
    }
  }
  data->RemoveArray(CellNumbers);
  return cells;
}
}

GhostCells::GhostCells(vtkPolyData* data)
  : Marks(MarksOf(data))
{
  const vtkIdType count = data->GetNumberOfCells();
  vtkIdType cell = 0;
  while (this->Marks && cell < count && !(*this)[cell])
  {
    ++cell;
  }
  this->Marks = cell < count ? this->Marks : nullptr;
}

bool GhostCells::operator[](vtkIdType cell) const
{
  return this->Marks && (this->Marks->GetValue(cell) & vtkDataSetAttributes::DUPLICATECELL);
}

AppendedPieces AppendPieces(const SurfacePieces& pieces, Joining joining)
{
  SurfacePieces copies;
  vtkIdType cells = 0;
  vtkIdType cellsLeft = 0;
  for (vtkPolyData* piece : pieces)
  {
    if (piece->GetNumberOfPoints() > 0)
    {
      copies.push_back(NumberedCopy(piece, cells));
      joining == Joining::ONE_SURFACE ? RemoveGhosts(copies.back()) : MarkGhosts(copies.back());
      cellsLeft += copies.back()->GetNumberOfCells();
    }
    cells += piece->GetNumberOfCells();
  }
  if (cellsLeft == 0 && !copies.empty())
  {
    AddVertexCell(copies.front(), cells);
  }
  AppendedPieces appended;
  appended.surface = Append(copies);
  appended.cells = TakeNumbers(appended.surface, cells);
  return appended;
}
}
