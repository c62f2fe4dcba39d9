// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_DistributedMesh_h
#define lmo_DistributedMesh_h

#include "HaloTriangles.h"

#include <memory>

namespace lmo
{
/// A surface over several processes, each of which brings a piece along: which vertices a process
/// owns, the triangles within two edges of them, and the ways between owners and ghosts. Pieces may
/// be empty, and may be cut in any way; vertices with the same id are one.
class DistributedMesh
{
public:
  /// Collective.
  /// \param piece its owners need not be set; points that no triangle uses are vertices too
  /// \throw InputError, in every process, if points with one id lie apart.
  DistributedMesh(const Communicator& comm, Piece piece);

  const Communicator& GetCommunicator() const { return this->Comm; }

  /// The vertices of this process: first those it owns, then ghosts.
  Index GetNumberOfVertices() const
  {
    return this->Owned.Size() + static_cast<Index>(this->GhostPlaces.size());
  }
  Index GetNumberOfOwned() const { return this->Owned.Size(); }
  std::int64_t GetGlobalNumberOfVertices() const { return this->GlobalVertices; }

  /// The coordinates of the vertices and the triangles, which are moved out.
  Points TakePoints() { return std::move(this->V); }
  Triangles TakeTriangles() { return std::move(this->T); }

  /// Where a vertex is owned.
  VertexPlace GetPlace(Index i) const;

  /// Number of a vertex over all processes: consecutive for those that a process owns.
  std::int64_t GetRow(Index i) const;
  Vector GetRows() const; ///< of all vertices
  std::int64_t GetFirstRow() const { return this->FirstRows[this->Comm.Rank()]; }

  /// Gives the ghosts among the vertices the values of their owners.
  template <typename Scalar>
  void UpdateGhosts(Scalar* values, int components) const;

  /// Gives both owners and ghosts the largest of their values.
  void UniteMaximum(Vector& values) const;

  /// Values at the points of the piece from values at the vertices.
  template <typename Values>
  Values ToPiece(const Values& vertexValues) const;

  /// Values at the vertices from values at the points of the piece.
  template <typename Values>
  Values FromPiece(const Values& pointValues) const;

private:
  std::vector<OwnedVertex> CollectGhosts(const Neighbourhood& neighbourhood, const Piece& piece);
  void MakeTriangles(const Neighbourhood& neighbourhood, const Piece& piece,
    std::int64_t firstNumber, const std::vector<OwnedVertex>& ghosts);
  void Reorder(std::vector<OwnedVertex>& ghosts);
  void Connect(const Piece& piece, const std::vector<OwnedVertex>& ghosts);
  void CheckCoordinates(const Piece& piece) const;

  Communicator Comm;
  IdList Owned;
  std::vector<Index> Numbers;      ///< of the vertices owned, in the order of their ids
  std::vector<Index> SourcePoints; ///< of each vertex owned, a point of the piece
  std::vector<VertexPlace> GhostPlaces;
  std::vector<std::int64_t> FirstRows; ///< of each process
  std::int64_t GlobalVertices = 0;
  Index PiecePoints = 0;
  Points V;
  Triangles T;
  std::unique_ptr<GhostVertices> Ghosts;      ///< the vertices that are not owned
  std::unique_ptr<GhostVertices> PieceGhosts; ///< the points of the piece
};

template <typename Scalar>
void DistributedMesh::UpdateGhosts(Scalar* values, int components) const
{
  const std::ptrdiff_t owned = std::ptrdiff_t(components) * this->GetNumberOfOwned();
  this->Ghosts->Update(values, values + owned, components);
}

template <typename Values>
Values DistributedMesh::ToPiece(const Values& vertexValues) const
{
  Values pointValues(this->PiecePoints, vertexValues.cols());
  this->PieceGhosts->Update(
    vertexValues.data(), pointValues.data(), static_cast<int>(vertexValues.cols()));
  return pointValues;
}

template <typename Values>
Values DistributedMesh::FromPiece(const Values& pointValues) const
{
  Values vertexValues(this->GetNumberOfVertices(), pointValues.cols());
  for (Index i = 0; i < this->GetNumberOfOwned(); ++i)
  {
    vertexValues.row(i) = pointValues.row(this->SourcePoints[i]);
  }
  this->UpdateGhosts(vertexValues.data(), static_cast<int>(vertexValues.cols()));
  return vertexValues;
}
}

#endif
