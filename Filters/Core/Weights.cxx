// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Weights.h"

#include "Parallel.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <numeric>

namespace lmo
{
namespace
{
/// Sorted values >= 0, in buckets that are ordered by the leading bits of their values: they are
/// found and sorted faster than one long list.
class Ranking
{
public:
  /// The values of \a isUsed.
  Ranking(const Vector& values, const Mask& isUsed)
    : Offsets(BucketCount + 1, 0)
  {
    const auto size = static_cast<Index>(values.size());
    for (Index i = 0; i < size; ++i)
    {
      this->Offsets[Bucket(values[i]) + 1] += isUsed[i];
    }
    std::partial_sum(this->Offsets.begin(), this->Offsets.end(), this->Offsets.begin());
    this->Values.resize(this->Offsets.back());
    std::vector<Index> next(this->Offsets.begin(), this->Offsets.end() - 1);
    for (Index i = 0; i < size; ++i)
    {
      if (isUsed[i])
      {
        this->Values[next[Bucket(values[i])]++] = values[i];
      }
    }
    ParallelFor(
      BucketCount, [&](Index bucket) { std::sort(this->Begin(bucket), this->End(bucket)); });
  }

  /// Share of the values that are not above \a value; 0 if there are none.
  double ShareUpTo(double value) const
  {
    const Index bucket = Bucket(value);
    const auto above = std::upper_bound(this->Begin(bucket), this->End(bucket), value);
    return double(above - this->Values.data()) /
           double(std::max<std::size_t>(this->Values.size(), 1));
  }

private:
  static constexpr Index BucketCount = 1 << 15;

  /// The exponent and the first bits of the mantissa of \a value as a float.
  static Index Bucket(double value)
  {
    const auto rounded = static_cast<float>(value);
    std::uint32_t bits = 0;
    static_assert(sizeof(bits) == sizeof(rounded));
    std::memcpy(&bits, &rounded, sizeof(bits));
    return static_cast<Index>(bits >> 16);
  }

  double* Begin(Index bucket) { return this->Values.data() + this->Offsets[bucket]; }
  double* End(Index bucket) { return this->Values.data() + this->Offsets[bucket + 1]; }
  const double* Begin(Index bucket) const { return this->Values.data() + this->Offsets[bucket]; }
  const double* End(Index bucket) const { return this->Values.data() + this->Offsets[bucket + 1]; }

  std::vector<Index> Offsets; ///< of the buckets in Values
  std::vector<double> Values;
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

CurvatureStatistics ComputeStatistics(const Vector& curvatures, const Mask& isUsed)
{
  std::vector<double> values;
  values.reserve(curvatures.size());
  for (Eigen::Index i = 0; i < curvatures.size(); ++i)
  {
    if (isUsed[i])
    {
      values.push_back(curvatures[i]);
    }
  }
  CurvatureStatistics statistics;
  if (!values.empty())
  {
    const auto [minimum, maximum] = std::minmax_element(values.begin(), values.end());
    statistics.minimum = *minimum;
    statistics.maximum = *maximum;
    const double firstQuartile = Quantile(values, 0.25);
    const double thirdQuartile = Quantile(std::move(values), 0.75);
    statistics.threshold = thirdQuartile + 1.5 * (thirdQuartile - firstQuartile);
  }
  return statistics;
}

Vector LinearWeights(const Vector& curvatures, const CurvatureStatistics& statistics)
{
  if (!(statistics.maximum > statistics.minimum))
  {
    return Vector::Ones(curvatures.size());
  }
  const double range = std::min(statistics.maximum, statistics.threshold) - statistics.minimum;
  if (!(range > 0))
  {
    return (curvatures.array() > statistics.minimum).cast<double>();
  }
  return ((curvatures.array() - statistics.minimum) / range).cwiseMax(0).cwiseMin(1);
}

Vector CumulativeWeights(const Vector& curvatures, const Mask& isUsed)
{
  const Ranking ranking(curvatures, isUsed);
  Vector weights(curvatures.size());
  ParallelFor(static_cast<Index>(curvatures.size()),
    [&](Index i) { weights[i] = ranking.ShareUpTo(curvatures[i]); });
  return weights;
}

Vector ComplementWeights(const Vector& weights)
{
  return 1 - weights.array();
}

Vector GaussianWeights(const Vector& curvatures, double sigma)
{
  if (!(sigma > 0))
  {
    return (curvatures.array() > 0).select(Vector::Zero(curvatures.size()), 1.0);
  }
  return (-0.5 * (curvatures.array() / sigma).square()).exp();
}

Vector AnchorWeights(const Vector& tags)
{
  return (tags.array() != 0).cast<double>();
}

void HoldLooseComponents(
  const std::vector<Index>& component, const Mask& isFixed, double weight, Vector& positionWeights)
{
  Mask isHeld(component.size(), 0);
  for (std::size_t i = 0; i < component.size(); ++i)
  {
    isHeld[component[i]] |= isFixed[i] || positionWeights[i] > 0;
  }
  for (std::size_t i = 0; i < component.size(); ++i)
  {
    if (!isHeld[component[i]])
    {
      positionWeights[i] = weight;
    }
  }
}
}
