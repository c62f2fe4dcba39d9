// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_Split_h
#define lmo_Split_h

#include "Core/Base/Threading.h"

namespace lmo
{
/// Moves what is chosen from a list to the result, in the order of the list.
/// \throw Cancelled if the monitor says so.
template <typename IsChosen>
std::vector<Index> Split(
  std::vector<Index>& list, ProgressMonitor& monitor, const IsChosen& isChosen)
{
  Mask areChosen(list.size());
  InterruptibleFor(
    static_cast<Index>(list.size()), monitor, [&](Index k) { areChosen[k] = isChosen(list[k]); });
  std::vector<Index> chosen;
  std::vector<Index> others;
  for (std::size_t k = 0; k < list.size(); ++k)
  {
    (areChosen[k] ? chosen : others).push_back(list[k]);
  }
  list = std::move(others);
  return chosen;
}
}

#endif
