// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Deviation/DependentCertificates.h"

#include <algorithm>
#include <numeric>

namespace lmo
{
void DependentProofs::Clear()
{
  this->Listed = {};
  this->Added.clear();
}

void DependentProofs::Build(const DistanceProofs& proofs)
{
  const auto forEach = [&](const auto& visit)
  {
    for (Index t = 0; t < proofs.Size(); ++t)
    {
      for (const Index used : proofs.Get(t).used)
      {
        visit(used, t);
      }
    }
  };
  std::vector<Index>& offsets = this->Listed.offsets;
  offsets.assign(proofs.Size() + 2, 0);
  forEach([&](Index used, Index) { ++offsets[used + 2]; });
  std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
  this->Listed.ids.resize(offsets.back());
  forEach([&](Index used, Index t) { this->Listed.ids[offsets[used + 1]++] = t; });
  offsets.pop_back();
}

void DependentProofs::Add(Index triangle, const DistanceProofs::Proof& proof)
{
  const auto isIn = [triangle](auto begin, auto end)
  { return std::find(begin, end, triangle) != end; };
  for (const Index used : proof.used)
  {
    std::vector<Index>& added = this->Added[used];
    if (!isIn(this->Listed.Begin(used), this->Listed.End(used)) &&
        !isIn(added.begin(), added.end()))
    {
      added.push_back(triangle);
    }
  }
}

std::vector<Index> DependentProofs::Find(const std::vector<Index>& used) const
{
  std::vector<Index> found;
  for (const Index t : used)
  {
    found.insert(found.end(), this->Listed.Begin(t), this->Listed.End(t));
    const auto added = this->Added.find(t);
    if (added != this->Added.end())
    {
      found.insert(found.end(), added->second.begin(), added->second.end());
    }
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}
}
