// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "DistributedMesh.h"

#include "Core/Base/Exceptions.h"
#include "Core/Mesh/VertexOrder.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <sstream>
#include <unordered_set>

namespace lmo
{
namespace
{
/// Coordinates of one vertex that differ by more, relative to the bounding box, are an error.
constexpr double LargestShift = 1e-6;

Mask UsedPoints(const Piece& piece)
{
  Mask isUsed(piece.ids.size(), 0);
  for (const Index i : piece.triangles.reshaped())
  {
    isUsed[i] = 1;
  }
  return isUsed;
}
}

DistributedMesh::DistributedMesh(const Communicator& comm, Piece piece)
  : Comm(comm)
  , PiecePoints(static_cast<Index>(piece.points.rows()))
{
  piece.owners = ChooseOwners(comm, piece.ids, UsedPoints(piece));
  const std::int64_t firstNumber = comm.SumBefore(std::int64_t(piece.triangles.rows()));
  const Neighbourhood neighbourhood = GatherNeighbourhood(comm, piece, firstNumber);
  std::vector<OwnedVertex> ghosts = this->CollectGhosts(neighbourhood, piece);
  this->MakeTriangles(neighbourhood, piece, firstNumber, ghosts);
  this->Reorder(ghosts);
  this->Connect(piece, ghosts);
  this->V = this->FromPiece(piece.points);
  this->CheckCoordinates(piece);
}

std::vector<OwnedVertex> DistributedMesh::CollectGhosts(
  const Neighbourhood& neighbourhood, const Piece& piece)
{
  const int rank = this->Comm.Rank();
  std::vector<GlobalId> owned;
  for (Index i = 0; i < this->PiecePoints; ++i)
  {
    if (piece.owners[i] == rank)
    {
      owned.push_back(piece.ids[i]);
    }
  }
  this->Owned = IdList(std::move(owned));

  std::vector<OwnedVertex> ghosts;
  std::unordered_set<GlobalId> known;
  const auto add = [&](const OwnedVertex& vertex)
  {
    if (vertex.owner != rank && known.insert(vertex.id).second)
    {
      ghosts.push_back(vertex);
    }
  };
  for (const Index t : neighbourhood.own)
  {
    for (const Index i : piece.triangles.row(t))
    {
      add({ piece.ids[i], piece.owners[i] });
    }
  }
  for (const TravellingTriangle& triangle : neighbourhood.foreign)
  {
    std::for_each(std::begin(triangle.vertices), std::end(triangle.vertices), add);
  }
  std::sort(ghosts.begin(), ghosts.end(),
    [](const OwnedVertex& a, const OwnedVertex& b) { return a.id < b.id; });
  return ghosts;
}

void DistributedMesh::MakeTriangles(const Neighbourhood& neighbourhood, const Piece& piece,
  std::int64_t firstNumber, const std::vector<OwnedVertex>& ghosts)
{
  std::vector<GlobalId> ids;
  std::transform(ghosts.begin(), ghosts.end(), std::back_inserter(ids),
    [](const OwnedVertex& vertex) { return vertex.id; });
  const IdList copyIds(std::move(ids));
  const auto numberOf = [&](const OwnedVertex& vertex)
  {
    return vertex.owner == this->Comm.Rank() ? this->Owned.Find(vertex.id)
                                             : this->Owned.Size() + copyIds.Find(vertex.id);
  };
  std::vector<Index> numbers(this->PiecePoints);
  this->SourcePoints.assign(this->Owned.Size(), 0);
  for (Index i = this->PiecePoints - 1; i >= 0; --i)
  {
    numbers[i] = numberOf({ piece.ids[i], piece.owners[i] });
    if (piece.owners[i] == this->Comm.Rank())
    {
      this->SourcePoints[numbers[i]] = i;
    }
  }
  this->T.resize(neighbourhood.own.size() + neighbourhood.foreign.size(), 3);
  Index t = 0;
  auto foreign = neighbourhood.foreign.begin();
  const auto addForeignBefore = [&](std::int64_t number)
  {
    for (; foreign != neighbourhood.foreign.end() && foreign->number < number; ++foreign, ++t)
    {
      for (int corner = 0; corner < 3; ++corner)
      {
        this->T(t, corner) = numberOf(foreign->vertices[corner]);
      }
    }
  };
  addForeignBefore(firstNumber);
  for (const Index own : neighbourhood.own)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      this->T(t, corner) = numbers[piece.triangles(own, corner)];
    }
    ++t;
  }
  addForeignBefore(std::numeric_limits<std::int64_t>::max());
}

void DistributedMesh::Reorder(std::vector<OwnedVertex>& ghosts)
{
  const Index owned = this->Owned.Size();
  this->Numbers.resize(owned);
  std::iota(this->Numbers.begin(), this->Numbers.end(), 0);
  if (!IsScattered(this->T))
  {
    return;
  }
  MeshOrder order = BreadthFirstOrder(owned + static_cast<Index>(ghosts.size()), this->T);
  std::stable_partition(
    order.vertices.begin(), order.vertices.end(), [&](Index i) { return i < owned; });
  this->T = Renumber(order, this->T);
  std::vector<Index> sourcePoints(owned);
  for (Index i = 0; i < owned; ++i)
  {
    this->Numbers[order.vertices[i]] = i;
    sourcePoints[i] = this->SourcePoints[order.vertices[i]];
  }
  this->SourcePoints = std::move(sourcePoints);
  std::vector<OwnedVertex> oldGhosts = ghosts;
  for (std::size_t k = 0; k < ghosts.size(); ++k)
  {
    ghosts[k] = oldGhosts[order.vertices[owned + k] - owned];
  }
}

void DistributedMesh::Connect(const Piece& piece, const std::vector<OwnedVertex>& ghosts)
{
  const Index owned = this->Owned.Size();
  this->GhostPlaces = FindPlaces(this->Comm, ghosts, this->Owned, this->Numbers);
  this->Ghosts = std::make_unique<GhostVertices>(this->Comm, owned, this->GhostPlaces);

  std::vector<OwnedVertex> points(this->PiecePoints);
  for (Index i = 0; i < this->PiecePoints; ++i)
  {
    points[i] = { piece.ids[i], piece.owners[i] };
  }
  this->PieceGhosts = std::make_unique<GhostVertices>(
    this->Comm, owned, FindPlaces(this->Comm, points, this->Owned, this->Numbers));

  this->FirstRows =
    this->Comm.Join(std::vector<std::int64_t>{ this->Comm.SumBefore(std::int64_t(owned)) });
  this->GlobalVertices = this->Comm.Sum(std::int64_t(owned));
}

void DistributedMesh::CheckCoordinates(const Piece& piece) const
{
  const Points owners = this->ToPiece(this->V);
  double size = 0;
  for (int c = 0; c < 3; ++c)
  {
    const bool isEmpty = piece.points.rows() == 0;
    const double maximum = isEmpty ? -HUGE_VAL : piece.points.col(c).maxCoeff();
    const double minimum = isEmpty ? HUGE_VAL : piece.points.col(c).minCoeff();
    size = std::max(size, this->Comm.Maximum(maximum) + this->Comm.Maximum(-minimum));
  }
  this->Comm.Try(
    [&]
    {
      const Vector shifts = (owners - piece.points).rowwise().lpNorm<Eigen::Infinity>();
      const Eigen::Index count = (shifts.array() > LargestShift * size).count();
      for (Eigen::Index i = 0; i < piece.points.rows() && count > 0; ++i)
      {
        if (shifts[i] > LargestShift * size)
        {
          std::ostringstream text;
          text << count
               << " points lie apart from others with their global ids; the first is point " << i
               << " with the id " << piece.ids[i]
               << ". Remove the array of global ids, and points that coincide will be one.";
          throw InputError(text.str());
        }
      }
    });
}

VertexPlace DistributedMesh::GetPlace(Index i) const
{
  return i < this->GetNumberOfOwned() ? VertexPlace{ this->Comm.Rank(), i }
                                      : this->GhostPlaces[i - this->GetNumberOfOwned()];
}

std::int64_t DistributedMesh::GetRow(Index i) const
{
  const VertexPlace place = this->GetPlace(i);
  return this->FirstRows[place.rank] + place.number;
}

Vector DistributedMesh::GetRows() const
{
  Vector rows(this->GetNumberOfVertices());
  for (Index i = 0; i < this->GetNumberOfVertices(); ++i)
  {
    rows[i] = static_cast<double>(this->GetRow(i));
  }
  return rows;
}

void DistributedMesh::UniteMaximum(Vector& values) const
{
  this->Ghosts->ReduceMaximum(values.data() + this->GetNumberOfOwned(), values.data());
  this->UpdateGhosts(values.data(), 1);
}
}
