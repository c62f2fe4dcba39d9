// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Weights.h"

#include "Parallel.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lmo
{
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
  std::vector<std::pair<double, Index>> ranking;
  ranking.reserve(curvatures.size());
  for (Index i = 0; i < curvatures.size(); ++i)
  {
    if (isUsed[i])
    {
      ranking.emplace_back(curvatures[i], i);
    }
  }
  ParallelSort(ranking.begin(), ranking.end());
  Vector weights(curvatures.size());
  for (Index i = 0; i < curvatures.size(); ++i)
  {
    if (!isUsed[i])
    {
      const auto above = std::upper_bound(ranking.begin(), ranking.end(),
        std::make_pair(curvatures[i], std::numeric_limits<Index>::max()));
      weights[i] = double(above - ranking.begin()) / std::max(1.0, double(ranking.size()));
    }
  }
  for (std::size_t first = 0; first < ranking.size();)
  {
    std::size_t last = first + 1;
    while (last < ranking.size() && ranking[last].first == ranking[first].first)
    {
      ++last;
    }
    for (; first < last; ++first)
    {
      weights[ranking[first].second] = double(last) / double(ranking.size());
    }
  }
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
