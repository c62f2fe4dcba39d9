// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_IndexSet_h
#define lmo_IndexSet_h

#include "Core/Base/Types.h"

namespace lmo
{
/// Indices, each once, in the order in which they were added. Clearing costs as much as adding did,
/// however large the indices may be.
class IndexSet
{
public:
  /// \param size the indices are below it
  explicit IndexSet(Index size)
    : IsListed(size, false)
  {
  }

  void Add(Index k)
  {
    if (!this->IsListed[k])
    {
      this->IsListed[k] = true;
      this->List.push_back(k);
    }
  }

  void Add(const std::vector<Index>& more)
  {
    for (const Index k : more)
    {
      this->Add(k);
    }
  }

  void Clear()
  {
    for (const Index k : this->List)
    {
      this->IsListed[k] = false;
    }
    this->List.clear();
  }

  const std::vector<Index>& Get() const { return this->List; }

  /// True for each index that is in the set.
  const Mask& GetMask() const { return this->IsListed; }

private:
  Mask IsListed;
  std::vector<Index> List;
};
}

#endif
