// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Ownership.h"

#include <algorithm>
#include <tuple>

namespace lmo
{
namespace
{
/// The process that knows who names an id.
int Directory(GlobalId id, int processes)
{
  return static_cast<int>(static_cast<std::uint64_t>(id) % static_cast<std::uint64_t>(processes));
}

struct Claim
{
  GlobalId id;
  bool isUsed;
};

/// The answers to the claims of all processes, in their order.
PerProcess<int> Decide(const PerProcess<Claim>& claims)
{
  struct Candidate
  {
    GlobalId id;
    bool isUnused;
    int rank;
    std::size_t place;
    bool operator<(const Candidate& other) const
    {
      return std::tie(this->id, this->isUnused, this->rank) <
             std::tie(other.id, other.isUnused, other.rank);
    }
  };
  std::vector<Candidate> candidates;
  PerProcess<int> owners(claims.size());
  for (std::size_t rank = 0; rank < claims.size(); ++rank)
  {
    owners[rank].resize(claims[rank].size());
    for (std::size_t place = 0; place < claims[rank].size(); ++place)
    {
      const Claim& claim = claims[rank][place];
      candidates.push_back({ claim.id, !claim.isUsed, static_cast<int>(rank), place });
    }
  }
  std::sort(candidates.begin(), candidates.end());
  int owner = 0;
  for (std::size_t k = 0; k < candidates.size(); ++k)
  {
    if (k == 0 || candidates[k].id != candidates[k - 1].id)
    {
      owner = candidates[k].rank;
    }
    owners[candidates[k].rank][candidates[k].place] = owner;
  }
  return owners;
}
}

std::vector<int> ChooseOwners(
  const Communicator& comm, const std::vector<GlobalId>& ids, const Mask& isUsed)
{
  PerProcess<Claim> claims(comm.Size());
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    claims[Directory(ids[i], comm.Size())].push_back({ ids[i], isUsed[i] != 0 });
  }
  const PerProcess<int> answers = comm.Exchange(Decide(comm.Exchange(claims)));
  std::vector<std::size_t> next(comm.Size(), 0);
  std::vector<int> owners(ids.size());
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    const int directory = Directory(ids[i], comm.Size());
    owners[i] = answers[directory][next[directory]++];
  }
  return owners;
}

IdList::IdList(std::vector<GlobalId> ids)
  : Ids(std::move(ids))
{
  std::sort(this->Ids.begin(), this->Ids.end());
  this->Ids.erase(std::unique(this->Ids.begin(), this->Ids.end()), this->Ids.end());
}

Index IdList::Find(GlobalId id) const
{
  const auto place = std::lower_bound(this->Ids.begin(), this->Ids.end(), id);
  const bool isThere = place != this->Ids.end() && *place == id;
  return isThere ? static_cast<Index>(place - this->Ids.begin()) : -1;
}

std::vector<VertexPlace> FindPlaces(const Communicator& comm,
  const std::vector<OwnedVertex>& vertices, const IdList& owned, const std::vector<Index>& numbers)
{
  PerProcess<GlobalId> questions(comm.Size());
  for (const OwnedVertex& vertex : vertices)
  {
    questions[vertex.owner].push_back(vertex.id);
  }
  PerProcess<Index> answers(comm.Size());
  const PerProcess<GlobalId> asked = comm.Exchange(questions);
  for (int rank = 0; rank < comm.Size(); ++rank)
  {
    for (const GlobalId id : asked[rank])
    {
      answers[rank].push_back(numbers[owned.Find(id)]);
    }
  }
  answers = comm.Exchange(answers);
  std::vector<std::size_t> next(comm.Size(), 0);
  std::vector<VertexPlace> places;
  places.reserve(vertices.size());
  for (const OwnedVertex& vertex : vertices)
  {
    places.push_back({ vertex.owner, answers[vertex.owner][next[vertex.owner]++] });
  }
  return places;
}
}
