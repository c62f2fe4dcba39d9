// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_Parallel_h
#define lmo_Parallel_h

#include "Types.h"

#include "vtkSMPTools.h"

#include <algorithm>

namespace lmo
{
/// Vertices or triangles handed to a thread at a time, and the length of the partial sums.
constexpr Index ParallelBlock = 2048;

/// Calls body(i) for every i in [0, count), in any order and on several threads.
template <typename Body>
void ParallelFor(Index count, const Body& body)
{
  vtkSMPTools::For(0, count, ParallelBlock,
    [&body](vtkIdType begin, vtkIdType end)
    {
      for (auto i = static_cast<Index>(begin); i < static_cast<Index>(end); ++i)
      {
        body(i);
      }
    });
}

/// Sum of body(sum, i) over i in [0, count), where body adds the term of i to its first argument.
/// Blocks of fixed length are added in their order: the result does not depend on the threads.
template <typename Value, typename Body>
Value ParallelSum(Index count, const Value& zero, const Body& body)
{
  const Index blocks = count / ParallelBlock + (count % ParallelBlock != 0);
  std::vector<Value> partial(blocks, zero);
  vtkSMPTools::For(0, blocks, 1,
    [&](vtkIdType firstBlock, vtkIdType lastBlock)
    {
      for (auto block = static_cast<Index>(firstBlock); block < lastBlock; ++block)
      {
        const Index begin = block * ParallelBlock;
        const Index end = std::min<std::int64_t>(count, std::int64_t(begin) + ParallelBlock);
        Value sum = zero;
        for (Index i = begin; i < end; ++i)
        {
          body(sum, i);
        }
        partial[block] = sum;
      }
    });
  Value total = zero;
  for (const Value& sum : partial)
  {
    total += sum;
  }
  return total;
}

/// Sorts ascending; the result does not depend on the threads.
template <typename Iterator>
void ParallelSort(Iterator begin, Iterator end)
{
  vtkSMPTools::Sort(begin, end);
}
}

#endif
