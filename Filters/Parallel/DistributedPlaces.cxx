// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "DistributedPlaces.h"

#include <algorithm>
#include <numeric>

namespace lmo
{
namespace
{
/// Changes of the process during one walk.
constexpr int LongestWay = 64;

/// A walk on its way to another process.
struct Walk
{
  double position[3];
  Index start; ///< a vertex that the process owns
  int rank;    ///< of the vertex that moved
  Index vertex;
};

struct FieldsAtPlace
{
  Index vertex;
  double values[Fields::ColsAtCompileTime];
};

std::vector<Walk> StartWalks(
  const MeshQuantities& mesh, const DistributedMesh& distributed, const Points& positions)
{
  std::vector<Walk> walks;
  for (Index i = 0; i < distributed.GetNumberOfOwned(); ++i)
  {
    if (positions.row(i) != mesh.GetPoints().row(i))
    {
      Walk walk{ {}, i, distributed.GetCommunicator().Rank(), i };
      Eigen::Map<Vector3>(walk.position) = positions.row(i);
      walks.push_back(walk);
    }
  }
  return walks;
}

/// Pairs of points of a piece that are one vertex.
std::vector<std::pair<Index, Index>> FindTwins(const DistributedMesh& mesh)
{
  const Vector rows = mesh.ToPiece(mesh.GetRows());
  std::vector<Index> order(rows.size());
  std::iota(order.begin(), order.end(), Index(0));
  std::sort(order.begin(), order.end(), [&](Index a, Index b) { return rows[a] < rows[b]; });
  std::vector<std::pair<Index, Index>> twins;
  for (std::size_t k = 1; k < order.size(); ++k)
  {
    if (rows[order[k]] == rows[order[k - 1]])
    {
      twins.emplace_back(order[k - 1], order[k]);
    }
  }
  return twins;
}
}

DistributedPlaces::DistributedPlaces(
  const MeshQuantities& mesh, const DistributedSubdomain& subdomain, const Points& positions)
  : Session(subdomain.GetMesh().GetCommunicator().Get())
  , Mesh(mesh)
  , Domain(subdomain)
  , Twins(FindTwins(subdomain.GetMesh()))
{
  const DistributedMesh& distributed = subdomain.GetMesh();
  const Communicator& comm = distributed.GetCommunicator();
  const WalkableSurface surface{ mesh.GetPoints(), mesh.GetTriangles(),
    mesh.GetTopology().cornersAt };
  std::vector<Walk> walks = StartWalks(mesh, distributed, distributed.FromPiece(positions));
  for (int way = 0; comm.Sum(std::int64_t(walks.size())) > 0; ++way)
  {
    PerProcess<Walk> leaving(comm.Size());
    for (Walk& walk : walks)
    {
      const SurfaceLocation place =
        WalkToClosestPoint(surface, walk.start, Eigen::Map<const Vector3>(walk.position));
      if (place.triangle < 0)
      {
        continue;
      }
      const VertexPlace owner = distributed.GetPlace(surface.triangles(place.triangle, 0));
      if (owner.rank == comm.Rank() || way == LongestWay)
      {
        this->Places.push_back(place);
        this->Origins.push_back({ walk.rank, walk.vertex });
      }
      else
      {
        walk.start = owner.number;
        leaving[owner.rank].push_back(walk);
      }
    }
    walks.clear();
    for (const std::vector<Walk>& arrived : comm.Exchange(leaving))
    {
      walks.insert(walks.end(), arrived.begin(), arrived.end());
    }
  }
}

bool DistributedPlaces::HasSeam(const Fields& values) const
{
  const bool isHere = std::any_of(this->Twins.begin(), this->Twins.end(),
    [&](const auto& twins) { return (values.row(twins.first) != values.row(twins.second)).any(); });
  return this->Domain.GetMesh().GetCommunicator().Maximum(isHere) > 0;
}

Fields DistributedPlaces::Interpolate(const Fields& values, Interpolation how) const
{
  const DistributedMesh& distributed = this->Domain.GetMesh();
  const Communicator& comm = distributed.GetCommunicator();
  const WalkableSurface surface{ this->Mesh.GetPoints(), this->Mesh.GetTriangles(),
    this->Mesh.GetTopology().cornersAt };
  Fields fields = distributed.FromPiece(values);
  const Fields atPlaces = InterpolateFields(surface, fields, this->Places, how);
  PerProcess<FieldsAtPlace> leaving(comm.Size());
  for (std::size_t k = 0; k < this->Origins.size(); ++k)
  {
    FieldsAtPlace field{ this->Origins[k].vertex, {} };
    Eigen::Map<Eigen::Array<double, 1, Fields::ColsAtCompileTime>>(field.values) =
      atPlaces.row(static_cast<Eigen::Index>(k));
    leaving[this->Origins[k].rank].push_back(field);
  }
  for (const std::vector<FieldsAtPlace>& arrived : comm.Exchange(leaving))
  {
    for (const FieldsAtPlace& field : arrived)
    {
      fields.row(field.vertex) =
        Eigen::Map<const Eigen::Array<double, 1, Fields::ColsAtCompileTime>>(field.values);
    }
  }
  return distributed.ToPiece(fields);
}
}
