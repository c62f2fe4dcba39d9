// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "HaloTriangles.h"

#include <algorithm>
#include <unordered_map>

namespace lmo
{
namespace
{
class NeighbourhoodGatherer
{
public:
  NeighbourhoodGatherer(const Communicator& comm, const Piece& piece, std::int64_t firstNumber)
    : Comm(comm)
    , Mesh(piece)
    , FirstNumber(firstNumber)
  {
  }

  Neighbourhood Gather()
  {
    this->SendToOwners();
    this->FindNeighbours();
    this->SendToNeighbours();
    this->Sort();
    return { this->ChooseOwn(), std::move(this->Foreign) };
  }

private:
  TravellingTriangle MakeTraveller(Index t) const
  {
    TravellingTriangle traveller{ this->FirstNumber + t, this->Comm.Rank(), {} };
    for (int corner = 0; corner < 3; ++corner)
    {
      const Index i = this->Mesh.triangles(t, corner);
      traveller.vertices[corner] = { this->Mesh.ids[i], this->Mesh.owners[i] };
    }
    return traveller;
  }

  bool IsMine(Index i) const { return this->Mesh.owners[i] == this->Comm.Rank(); }

  int CountMine(Index t) const
  {
    int count = 0;
    for (int corner = 0; corner < 3; ++corner)
    {
      count += this->IsMine(this->Mesh.triangles(t, corner));
    }
    return count;
  }

  /// Afterwards each process has the triangles at the vertices that it owns.
  void SendToOwners()
  {
    PerProcess<TravellingTriangle> leaving(this->Comm.Size());
    for (Index t = 0; t < this->Mesh.triangles.rows(); ++t)
    {
      if (this->CountMine(t) < 3)
      {
        const TravellingTriangle traveller = this->MakeTraveller(t);
        this->ForEachOwner(traveller, [&](int owner) { leaving[owner].push_back(traveller); });
        this->Border.push_back(traveller);
      }
    }
    this->Receive(leaving);
  }

  /// Calls visit(owner) once for each other process that owns a vertex of the triangle.
  template <typename Visit>
  void ForEachOwner(const TravellingTriangle& triangle, const Visit& visit) const
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      const int owner = triangle.vertices[corner].owner;
      const bool isNew = std::none_of(triangle.vertices, triangle.vertices + corner,
        [&](const OwnedVertex& vertex) { return vertex.owner == owner; });
      if (isNew && owner != this->Comm.Rank())
      {
        visit(owner);
      }
    }
  }

  void Receive(const PerProcess<TravellingTriangle>& leaving)
  {
    for (const std::vector<TravellingTriangle>& arrived : this->Comm.Exchange(leaving))
    {
      this->Foreign.insert(this->Foreign.end(), arrived.begin(), arrived.end());
    }
  }

  /// The vertices of others that share a triangle with one of this process's.
  void FindNeighbours()
  {
    std::vector<GlobalId> neighbours;
    for (const std::vector<TravellingTriangle>* triangles : { &this->Border, &this->Foreign })
    {
      for (const TravellingTriangle& triangle : *triangles)
      {
        const bool touchesMine =
          std::any_of(std::begin(triangle.vertices), std::end(triangle.vertices),
            [&](const OwnedVertex& vertex) { return vertex.owner == this->Comm.Rank(); });
        for (const OwnedVertex& vertex : triangle.vertices)
        {
          if (touchesMine && vertex.owner != this->Comm.Rank())
          {
            neighbours.push_back(vertex.id);
            this->OwnerOf[vertex.id] = vertex.owner;
          }
        }
      }
    }
    this->Neighbours = IdList(std::move(neighbours));
  }

  /// Sends the triangles at a vertex to all processes that have it as a neighbour.
  void SendToNeighbours()
  {
    PerProcess<GlobalId> wanted(this->Comm.Size());
    for (Index k = 0; k < this->Neighbours.Size(); ++k)
    {
      wanted[this->OwnerOf.at(this->Neighbours[k])].push_back(this->Neighbours[k]);
    }
    std::unordered_map<GlobalId, std::vector<int>> takers;
    const PerProcess<GlobalId> asked = this->Comm.Exchange(wanted);
    for (int rank = 0; rank < this->Comm.Size(); ++rank)
    {
      for (const GlobalId id : asked[rank])
      {
        takers[id].push_back(rank);
      }
    }
    PerProcess<TravellingTriangle> leaving(this->Comm.Size());
    const auto send = [&](const TravellingTriangle& triangle)
    {
      for (const OwnedVertex& vertex : triangle.vertices)
      {
        const auto found = takers.find(vertex.id);
        for (const int taker : found == takers.end() ? std::vector<int>() : found->second)
        {
          const bool isSent =
            !leaving[taker].empty() && leaving[taker].back().number == triangle.number;
          if (taker != triangle.home && !isSent)
          {
            leaving[taker].push_back(triangle);
          }
        }
      }
    };
    const Mask isWanted = this->FindWantedPoints(takers);
    for (Index t = 0; t < this->Mesh.triangles.rows(); ++t)
    {
      const auto corners = this->Mesh.triangles.row(t);
      if (isWanted[corners[0]] || isWanted[corners[1]] || isWanted[corners[2]])
      {
        send(this->MakeTraveller(t));
      }
    }
    std::for_each(this->Foreign.begin(), this->Foreign.end(), send);
    this->Receive(leaving);
  }

  template <typename Map>
  Mask FindWantedPoints(const Map& takers) const
  {
    Mask isWanted(this->Mesh.ids.size(), 0);
    for (std::size_t i = 0; i < isWanted.size() && !takers.empty(); ++i)
    {
      isWanted[i] = this->IsMine(static_cast<Index>(i)) && takers.count(this->Mesh.ids[i]) > 0;
    }
    return isWanted;
  }

  /// A triangle may have come from several owners.
  void Sort()
  {
    const auto isBefore = [](const TravellingTriangle& a, const TravellingTriangle& b)
    { return a.number < b.number; };
    const auto isSame = [](const TravellingTriangle& a, const TravellingTriangle& b)
    { return a.number == b.number; };
    std::sort(this->Foreign.begin(), this->Foreign.end(), isBefore);
    this->Foreign.erase(
      std::unique(this->Foreign.begin(), this->Foreign.end(), isSame), this->Foreign.end());
  }

  std::vector<Index> ChooseOwn() const
  {
    Mask isNear(this->Mesh.ids.size());
    for (std::size_t i = 0; i < isNear.size(); ++i)
    {
      isNear[i] =
        this->IsMine(static_cast<Index>(i)) || this->Neighbours.Find(this->Mesh.ids[i]) >= 0;
    }
    std::vector<Index> own;
    for (Index t = 0; t < this->Mesh.triangles.rows(); ++t)
    {
      const auto corners = this->Mesh.triangles.row(t);
      if (isNear[corners[0]] || isNear[corners[1]] || isNear[corners[2]])
      {
        own.push_back(t);
      }
    }
    return own;
  }

  const Communicator& Comm;
  const Piece& Mesh;
  const std::int64_t FirstNumber;
  std::vector<TravellingTriangle> Border; ///< of this piece, with vertices of others
  std::vector<TravellingTriangle> Foreign;
  std::unordered_map<GlobalId, int> OwnerOf; ///< of the neighbours
  IdList Neighbours;
};
}

Neighbourhood GatherNeighbourhood(
  const Communicator& comm, const Piece& piece, std::int64_t firstNumber)
{
  return NeighbourhoodGatherer(comm, piece, firstNumber).Gather();
}
}
