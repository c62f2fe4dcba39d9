// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "DistributedRanking.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace lmo
{
namespace
{
/// The bits of a number >= 0, which are in the order of the numbers.
std::uint64_t Bits(double value)
{
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof(bits));
  return bits;
}

/// The value that \a place others come before: radix selection, 16 bits at a time.
double SelectValue(const Communicator& comm, const std::vector<double>& values, std::int64_t place)
{
  constexpr int digitBits = 16;
  std::uint64_t prefix = 0;
  for (int shift = 64 - digitBits; shift >= 0; shift -= digitBits)
  {
    std::vector<std::int64_t> counts(std::size_t(1) << digitBits, 0);
    for (const double value : values)
    {
      const std::uint64_t bits = Bits(value) >> shift;
      if (bits >> digitBits == prefix)
      {
        ++counts[bits & (counts.size() - 1)];
      }
    }
    comm.Sum(counts);
    std::uint64_t digit = 0;
    for (; place >= counts[digit]; ++digit)
    {
      place -= counts[digit];
    }
    prefix = prefix << digitBits | digit;
  }
  double value = 0;
  std::memcpy(&value, &prefix, sizeof(value));
  return value;
}

/// Cuts the values into intervals, one for each process, with about as many values in each.
class Intervals
{
public:
  Intervals(const Communicator& comm, const std::vector<double>& values)
  {
    std::vector<std::int64_t> counts(std::size_t(1) << BucketBits, 0);
    for (const double value : values)
    {
      ++counts[Bucket(value)];
    }
    comm.Sum(counts);
    std::int64_t total = 0;
    for (const std::int64_t count : counts)
    {
      total += count;
    }
    this->Ranks.reserve(counts.size());
    std::int64_t before = 0;
    for (const std::int64_t count : counts)
    {
      this->Ranks.push_back(total > 0 ? static_cast<int>(before * comm.Size() / (total + 1)) : 0);
      before += count;
    }
  }

  int RankOf(double value) const { return this->Ranks[Bucket(value)]; }

private:
  static constexpr int BucketBits = 20;
  static std::size_t Bucket(double value) { return Bits(value) >> (63 - BucketBits); }

  std::vector<int> Ranks;
};

/// A value and how often a process has it.
struct ValueCount
{
  double value;
  std::int64_t count;
};

/// Each value once, ascending.
std::vector<ValueCount> CountValues(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  std::vector<ValueCount> counts;
  for (const double value : values)
  {
    if (counts.empty() || counts.back().value != value)
    {
      counts.push_back({ value, 0 });
    }
    ++counts.back().count;
  }
  return counts;
}

/// For each value of each process how many values of all processes are at most as large.
PerProcess<std::int64_t> CountUpTo(const Communicator& comm, const PerProcess<ValueCount>& values)
{
  std::vector<ValueCount> all;
  for (const std::vector<ValueCount>& list : values)
  {
    all.insert(all.end(), list.begin(), list.end());
  }
  const auto isBelow = [](const ValueCount& a, const ValueCount& b) { return a.value < b.value; };
  std::sort(all.begin(), all.end(), isBelow);
  std::int64_t total = 0;
  for (ValueCount& item : all)
  {
    item.count = total += item.count;
  }
  const std::int64_t before = comm.SumBefore(total);
  PerProcess<std::int64_t> ranks(values.size());
  for (std::size_t rank = 0; rank < values.size(); ++rank)
  {
    for (const ValueCount& item : values[rank])
    {
      const auto above = std::upper_bound(all.begin(), all.end(), item, isBelow);
      ranks[rank].push_back(before + (above - 1)->count);
    }
  }
  return ranks;
}
}

double DistributedQuantile(const Communicator& comm, const std::vector<double>& values, double q)
{
  const std::int64_t count = comm.Sum(std::int64_t(values.size()));
  if (count == 0)
  {
    return 0;
  }
  const double place = q * double(count - 1);
  const auto below = static_cast<std::int64_t>(place);
  const double lower = SelectValue(comm, values, below);
  const double upper = SelectValue(comm, values, std::min(below + 1, count - 1));
  return lower + (place - std::floor(place)) * (upper - lower);
}

Vector DistributedShares(const Communicator& comm, const Vector& values, const Mask& counts)
{
  std::vector<double> counted;
  for (Eigen::Index i = 0; i < values.size(); ++i)
  {
    if (counts[i])
    {
      counted.push_back(values[i]);
    }
  }
  const double total = double(std::max<std::int64_t>(comm.Sum(std::int64_t(counted.size())), 1));
  const Intervals intervals(comm, counted);
  PerProcess<ValueCount> leaving(comm.Size());
  // Values that do not count here, such as those of ghosts, want to know their share too.
  std::vector<ValueCount> distinct = CountValues(std::move(counted));
  for (const ValueCount& item : CountValues({ values.begin(), values.end() }))
  {
    const auto found = std::lower_bound(distinct.begin(), distinct.end(), item,
      [](const ValueCount& a, const ValueCount& b) { return a.value < b.value; });
    const bool counts = found != distinct.end() && found->value == item.value;
    leaving[intervals.RankOf(item.value)].push_back({ item.value, counts ? found->count : 0 });
  }
  const PerProcess<std::int64_t> ranks = comm.Exchange(CountUpTo(comm, comm.Exchange(leaving)));
  Vector shares(values.size());
  for (Eigen::Index i = 0; i < values.size(); ++i)
  {
    const int rank = intervals.RankOf(values[i]);
    const auto found = std::lower_bound(leaving[rank].begin(), leaving[rank].end(), values[i],
      [](const ValueCount& item, double value) { return item.value < value; });
    shares[i] = double(ranks[rank][found - leaving[rank].begin()]) / total;
  }
  return shares;
}
}
