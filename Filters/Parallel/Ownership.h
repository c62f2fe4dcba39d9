// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_Ownership_h
#define lmo_Ownership_h

#include "GhostVertices.h"

namespace lmo
{
/// The id of a vertex over all processes; any number.
using GlobalId = std::int64_t;

/// Chooses one of the processes that name a vertex as its owner, and one in which a triangle uses
/// it, if there are any.
/// \param ids those this process names, in any order, perhaps several times
/// \param isUsed by a triangle of this process
/// \return the owner of each
std::vector<int> ChooseOwners(
  const Communicator& comm, const std::vector<GlobalId>& ids, const Mask& isUsed);

/// Ids in ascending order, each once.
class IdList
{
public:
  IdList() = default;
  explicit IdList(std::vector<GlobalId> ids);

  Index Size() const { return static_cast<Index>(this->Ids.size()); }
  GlobalId operator[](Index place) const { return this->Ids[place]; }

  /// Place of an id; -1 if it is not in the list.
  Index Find(GlobalId id) const;

private:
  std::vector<GlobalId> Ids;
};

/// A vertex that another process, or this one, owns.
struct OwnedVertex
{
  GlobalId id;
  int owner;
};

/// Asks the owners of vertices for the numbers that they gave them.
/// \param owned ids of the vertices that this process owns
/// \param numbers that this process gave to them
std::vector<VertexPlace> FindPlaces(const Communicator& comm,
  const std::vector<OwnedVertex>& vertices, const IdList& owned, const std::vector<Index>& numbers);
}

#endif
