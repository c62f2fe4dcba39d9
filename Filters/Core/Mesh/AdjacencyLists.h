// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_AdjacencyLists_h
#define lmo_AdjacencyLists_h

#include "Core/Base/Types.h"

namespace lmo
{
/// For each vertex a list of ids, all lists in one array (compressed rows).
struct AdjacencyLists
{
  std::vector<Index> offsets; ///< size vertices + 1; list i is [offsets[i], offsets[i + 1])
  std::vector<Index> ids;

  /// One of the lists.
  struct Range
  {
    const Index* first;
    const Index* last;
    const Index* begin() const { return this->first; }
    const Index* end() const { return this->last; }
  };

  Range operator[](Index i) const { return { this->Begin(i), this->End(i) }; }
  Index Size(Index i) const { return this->offsets[i + 1] - this->offsets[i]; }
  const Index* Begin(Index i) const { return this->ids.data() + this->offsets[i]; }
  const Index* End(Index i) const { return this->ids.data() + this->offsets[i + 1]; }
};
}

#endif
