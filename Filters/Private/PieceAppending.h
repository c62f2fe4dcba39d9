// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef PieceAppending_h
#define PieceAppending_h

#include "JoinedPieces.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <numeric>

class vtkUnsignedCharArray;

namespace lmo
{
/// The points and cells of pieces in one vtkPolyData.
struct AppendedPieces
{
  vtkSmartPointer<vtkPolyData> surface;
  std::vector<vtkIdType> cells; ///< of the surface, for each cell of all pieces; -1 for none
};

/// All points, one piece after the other, the cells without ghosts or with ghosts that are marked,
/// and the arrays that all pieces have.
AppendedPieces AppendPieces(const SurfacePieces& pieces, Joining joining);

/// For each cell whether it is a duplicate of one in another piece.
class GhostCells
{
public:
  explicit GhostCells(vtkPolyData* data);

  /// False if no cell is one.
  bool HasAny() const { return this->Marks != nullptr; }
  bool operator[](vtkIdType cell) const;

private:
  vtkUnsignedCharArray* Marks;
};

/// Calls visit(kind, cell, points) for each cell in the order of their ids; kind is 0 for
/// vertices, 1 for lines, 2 for polygons and 3 for strips.
template <typename Visit>
void ForEachCell(vtkPolyData* data, const Visit& visit)
{
  vtkIdType cell = 0;
  vtkNew<vtkIdList> points;
  vtkCellArray* const kinds[] = { data->GetVerts(), data->GetLines(), data->GetPolys(),
    data->GetStrips() };
  for (int kind = 0; kind < 4; ++kind)
  {
    for (vtkIdType k = 0; k < kinds[kind]->GetNumberOfCells(); ++k)
    {
      kinds[kind]->GetCellAtId(k, points);
      visit(kind, cell++, points.Get());
    }
  }
}

/// Tuples of all arrays.
template <typename Attributes>
vtkSmartPointer<Attributes> TuplesOf(Attributes* data, vtkIdList* ids)
{
  vtkNew<vtkIdList> all;
  all->SetNumberOfIds(ids->GetNumberOfIds());
  std::iota(all->begin(), all->end(), vtkIdType(0));
  auto tuples = vtkSmartPointer<Attributes>::New();
  tuples->CopyAllOn();
  tuples->CopyAllocate(data, ids->GetNumberOfIds());
  tuples->SetNumberOfTuples(ids->GetNumberOfIds());
  tuples->CopyData(data, ids, all);
  return tuples;
}

}

#endif
