// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef JoinedPieces_h
#define JoinedPieces_h

#include "Core/Base/Types.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <memory>
#include <vector>

class vtkCellData;
class vtkPolyData;

namespace lmo
{
class ResultArrays;

using SurfacePieces = std::vector<vtkSmartPointer<vtkPolyData>>;

/// What becomes of ghost cells and of points that several pieces have.
enum class Joining
{
  ONE_SURFACE, ///< ghost cells are left out, and the points are one vertex
  SIDE_BY_SIDE ///< ghost cells stay and are marked, and the points stay apart
};

/// The pieces of a surface as one vtkPolyData, which has all points of the pieces, one piece after
/// the other, and what an optimization makes of it as pieces again.
class JoinedPieces
{
public:
  /// \throw InputError if points with the same global id lie apart, and as ReadMesh() does.
  JoinedPieces(const SurfacePieces& pieces, Joining joining);

  /// True if it was made of these pieces as they are now.
  bool IsOf(const SurfacePieces& pieces, Joining joining) const;

  vtkPolyData* GetSurface() const { return this->Surface; }

  /// For each point the lowest one that is the same vertex: points with the same global id, or,
  /// without global ids, at the same place at the border of a piece. Empty if no two are the same.
  const std::vector<Index>& GetFirstPoints() const { return this->FirstPoints; }

  /// A piece with what an optimization of the surface made of its points and arrays. Ghost cells
  /// get what the cells have whose copies they are.
  /// \param k number of the piece
  /// \param results is told about names of arrays that are not free
  vtkSmartPointer<vtkPolyData> HandBack(
    vtkPolyData* piece, std::size_t k, vtkPolyData* optimized, ResultArrays& results) const;

private:
  /// A piece that was joined.
  struct Source
  {
    vtkPolyData* data; ///< to be compared only
    vtkMTimeType time;
    vtkIdType firstPoint; ///< in the surface
    vtkIdType firstCell;  ///< among the cells of all pieces

    bool operator==(vtkPolyData* piece) const;
  };

  void FindFirstPoints(const SurfacePieces& pieces);
  void FindOriginalsOfGhosts(const SurfacePieces& pieces);
  /// What an optimization changes or adds.
  vtkSmartPointer<vtkCellData> CellDataOf(
    vtkPolyData* piece, std::size_t k, vtkPolyData* optimized) const;

  Joining How;
  std::vector<Source> Sources;
  vtkSmartPointer<vtkPolyData> Surface;
  std::vector<Index> FirstPoints;
  std::vector<vtkIdType> Cells; ///< of the surface, for each cell of all pieces; -1 for none
};

/// Keeps what was joined as long as the pieces stay as they are.
class CachedJoin
{
public:
  const JoinedPieces& Of(const SurfacePieces& pieces, Joining joining);

private:
  std::unique_ptr<const JoinedPieces> Joined;
};
}

#endif
