// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Base/EmpiricalDistribution.h"

#include "Core/Base/Threading.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <numeric>

namespace lmo
{
namespace
{
/// A value >= 0 and the vertex that has it.
struct RankedValue
{
  double value;
  Index vertex;
  bool operator<(const RankedValue& other) const { return this->value < other.value; }
};

/// Maps values >= 0 to buckets in their order: by the leading bits of the values as floats, which
/// is faster than to sort one long list.
class Buckets
{
public:
  /// About half as many buckets as values.
  explicit Buckets(const Vector& values)
    : Lowest(Bits(values.minCoeff()))
  {
    const std::uint32_t range = Bits(values.maxCoeff()) - this->Lowest;
    while ((range >> this->Shift) > static_cast<std::uint32_t>(values.size()) / 2)
    {
      ++this->Shift;
    }
    this->Count = static_cast<Index>(range >> this->Shift) + 1;
  }

  Index GetCount() const { return this->Count; }
  Index operator()(double value) const
  {
    return static_cast<Index>((Bits(value) - this->Lowest) >> this->Shift);
  }

private:
  static std::uint32_t Bits(double value)
  {
    const auto rounded = static_cast<float>(value);
    std::uint32_t bits = 0;
    static_assert(sizeof(bits) == sizeof(rounded));
    std::memcpy(&bits, &rounded, sizeof(bits));
    return bits;
  }

  std::uint32_t Lowest;
  int Shift = 0;
  Index Count = 0;
};
}

double Quantile(std::vector<double> values, double q)
{
  if (values.empty())
  {
    return 0;
  }
  const double place = q * double(values.size() - 1);
  const auto below = values.begin() + static_cast<std::ptrdiff_t>(place);
  std::nth_element(values.begin(), below, values.end());
  const auto above = std::min_element(below + 1, values.end());
  return above == values.end() ? *below : *below + (place - std::floor(place)) * (*above - *below);
}

Vector CumulativeShares(const Vector& values, const Mask& counts)
{
  const auto size = static_cast<Index>(values.size());
  Vector shares = Vector::Zero(size);
  if (size == 0)
  {
    return shares;
  }
  const Buckets bucketOf(values);
  std::vector<Index> offsets(bucketOf.GetCount() + 1, 0);
  for (Index i = 0; i < size; ++i)
  {
    offsets[bucketOf(values[i]) + 1] += counts[i];
  }
  std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
  std::vector<RankedValue> ranking(offsets.back());
  std::vector<Index> next(offsets.begin(), offsets.end() - 1);
  for (Index i = 0; i < size; ++i)
  {
    if (counts[i])
    {
      ranking[next[bucketOf(values[i])]++] = { values[i], i };
    }
  }
  const auto share = [&](std::vector<RankedValue>::iterator above)
  { return double(above - ranking.begin()) / double(std::max<std::size_t>(ranking.size(), 1)); };
  ParallelFor(bucketOf.GetCount(),
    [&](Index bucket)
    {
      const auto end = ranking.begin() + offsets[bucket + 1];
      std::sort(ranking.begin() + offsets[bucket], end);
      for (auto first = ranking.begin() + offsets[bucket]; first != end;)
      {
        const auto above = std::upper_bound(first, end, *first);
        std::for_each(
          first, above, [&](const RankedValue& tie) { shares[tie.vertex] = share(above); });
        first = above;
      }
    });
  for (Index i = 0; i < size; ++i)
  {
    if (!counts[i])
    {
      const Index bucket = bucketOf(values[i]);
      shares[i] = share(std::upper_bound(ranking.begin() + offsets[bucket],
        ranking.begin() + offsets[bucket + 1], RankedValue{ values[i], i }));
    }
  }
  return shares;
}
}
