// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_Threading_h
#define lmo_Threading_h

#include "Core/Base/ProgressMonitor.h"
#include "Core/Base/ThreadPool.h"

#include "vtkSMPTools.h"

#include <algorithm>

namespace lmo
{
/// Length of the partial sums of ParallelSum().
constexpr Index ParallelBlock = 2048;

/// Fewest calls of a loop's body that are worth a thread.
constexpr Index ParallelGrain = 256;

/// Number of threads that serve a parallel loop of the calling thread.
inline int NumberOfThreads()
{
  if (SerialScope::IsActive())
  {
    return 1;
  }
  const ThreadPool* team = ThreadPool::Current();
  return team ? team->Size() : vtkSMPTools::GetEstimatedNumberOfThreads();
}

/// Calls body(k) for every k in [0, count), in any order and on several threads, on those that
/// vtkSMPTools provides.
template <typename Body>
void ParallelTasks(Index count, const Body& body)
{
  if (count == 1 || SerialScope::IsActive())
  {
    for (Index k = 0; k < count; ++k)
    {
      body(k);
    }
    return;
  }
  if (ThreadPool* team = ThreadPool::Current())
  {
    team->Run(count, body);
    return;
  }
  vtkSMPTools::For(0, count, 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (auto k = static_cast<Index>(begin); k < end; ++k)
      {
        body(k);
      }
    });
}

/// Calls body(begin, end) for ranges that cover [0, count), in any order and on several threads.
/// Every begin is a multiple of \a block.
template <typename Body>
void ParallelRanges(Index count, const Body& body, Index block = ParallelBlock)
{
  const Index blocks = count / block + (count % block != 0);
  // Several ranges for each thread even out their speeds; more would cost in overhead.
  const Index ranges = blocks > 1 ? std::min(blocks, 4 * NumberOfThreads()) : blocks;
  ParallelTasks(ranges,
    [&](Index range)
    {
      const auto bound = [&](Index k)
      {
        const std::int64_t first = std::int64_t(blocks) * k / ranges;
        return static_cast<Index>(std::min<std::int64_t>(count, first * block));
      };
      body(bound(range), bound(range + 1));
    });
}

/// Calls body(i), or that of a copy, for every i in [0, count), in any order and on several
/// threads.
/// \param grain fewest calls that are worth a thread
template <typename Body>
void ParallelFor(Index count, const Body& body, Index grain = ParallelGrain)
{
  ParallelRanges(
    count,
    [&body](Index begin, Index end)
    {
      Body local = body; // what it holds by value stays in registers
      for (Index i = begin; i < end; ++i)
      {
        local(i);
      }
    },
    grain);
}

/// ParallelFor() that asks the monitor now and then.
/// \throw Cancelled if the monitor says so; what has been done by then stays.
template <typename Body>
void InterruptibleFor(
  Index count, ProgressMonitor& monitor, const Body& body, Index grain = ParallelGrain)
{
  constexpr Index slice = 65536;
  for (Index first = 0; first < count; first += std::min(slice, count - first))
  {
    monitor.Report(0);
    ParallelFor(
      std::min(slice, count - first), [first, local = body](Index i) mutable { local(first + i); },
      grain);
  }
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
      Body local = body;
      while (begin < end)
      {
        Value sum = zero;
        const Index block = begin / ParallelBlock;
        const Index blockEnd = end - begin > ParallelBlock ? begin + ParallelBlock : end;
        for (; begin < blockEnd; ++begin)
        {
          local(sum, begin);
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
}

#endif
