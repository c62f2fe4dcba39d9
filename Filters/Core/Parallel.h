// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_Parallel_h
#define lmo_Parallel_h

#include "Types.h"

#include "vtkSMPTools.h"

#include <algorithm>

namespace lmo
{
/// Length of the partial sums of ParallelSum(), and the least work that is worth a thread.
constexpr Index ParallelBlock = 2048;

/// Calls body(begin, end) for ranges that cover [0, count), in any order and on several threads.
/// Every begin is a multiple of ParallelBlock.
template <typename Body>
void ParallelRanges(Index count, const Body& body)
{
  const Index blocks = count / ParallelBlock + (count % ParallelBlock != 0);
  // Four ranges for each thread even out their speeds; more would cost in overhead.
  const Index ranges = 4 * vtkSMPTools::GetEstimatedNumberOfThreads();
  vtkSMPTools::For(0, blocks, std::max<Index>(4, blocks / ranges),
    [&](vtkIdType firstBlock, vtkIdType lastBlock)
    {
      const std::int64_t begin = firstBlock * ParallelBlock;
      const std::int64_t end = std::min<std::int64_t>(count, lastBlock * ParallelBlock);
      body(static_cast<Index>(begin), static_cast<Index>(end));
    });
}

/// Calls body(i) for every i in [0, count), in any order and on several threads.
template <typename Body>
void ParallelFor(Index count, const Body& body)
{
  ParallelRanges(count,
    [&body](Index begin, Index end)
    {
      for (Index i = begin; i < end; ++i)
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
  std::vector<Value> partial(count / ParallelBlock + (count % ParallelBlock != 0), zero);
  ParallelRanges(count,
    [&](Index begin, Index end)
    {
      while (begin < end)
      {
        Value sum = zero;
        const Index block = begin / ParallelBlock;
        const Index blockEnd = end - begin > ParallelBlock ? begin + ParallelBlock : end;
        for (; begin < blockEnd; ++begin)
        {
          body(sum, begin);
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
  const Index parts = 4;
  const auto count = end - begin;
  const auto bound = [&](Index part) { return begin + count * part / parts; };
  vtkSMPTools::For(0, parts, 1,
    [&](vtkIdType first, vtkIdType last)
    {
      for (auto part = static_cast<Index>(first); part < last; ++part)
      {
        std::sort(bound(part), bound(part + 1));
      }
    });
  vtkSMPTools::For(0, 2, 1,
    [&](vtkIdType first, vtkIdType last)
    {
      for (auto half = static_cast<Index>(first); half < last; ++half)
      {
        std::inplace_merge(bound(2 * half), bound(2 * half + 1), bound(2 * half + 2));
      }
    });
  std::inplace_merge(begin, bound(2), end);
}
}

#endif
