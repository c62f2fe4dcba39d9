// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Weights.h"

#include "Parallel.h"

#include <algorithm>
#include <cmath>

namespace lmo
{
double Quantile(const Vector& sorted, double q)
{
  if (sorted.size() == 0)
  {
    return 0;
  }
  const double place = q * double(sorted.size() - 1);
  const auto below = static_cast<Eigen::Index>(place);
  const auto above = std::min<Eigen::Index>(below + 1, sorted.size() - 1);
  return sorted[below] + (place - double(below)) * (sorted[above] - sorted[below]);
}

CurvatureStatistics ComputeStatistics(const Vector& curvatures, const Mask& isUsed)
{
  CurvatureStatistics statistics;
  statistics.sorted.resize(std::count(isUsed.begin(), isUsed.end(), true));
  Eigen::Index count = 0;
  for (Eigen::Index i = 0; i < curvatures.size(); ++i)
  {
    if (isUsed[i])
    {
      statistics.sorted[count++] = curvatures[i];
    }
  }
  if (count > 0)
  {
    ParallelSort(statistics.sorted.data(), statistics.sorted.data() + count);
    statistics.minimum = statistics.sorted[0];
    statistics.maximum = statistics.sorted[count - 1];
    const double firstQuartile = Quantile(statistics.sorted, 0.25);
    const double thirdQuartile = Quantile(statistics.sorted, 0.75);
    statistics.threshold = thirdQuartile + 1.5 * (thirdQuartile - firstQuartile);
  }
  return statistics;
}

Vector LinearWeights(const Vector& curvatures, const CurvatureStatistics& statistics)
{
  const double range = std::min(statistics.maximum, statistics.threshold) - statistics.minimum;
  if (!(range > 0))
  {
    return Vector::Ones(curvatures.size());
  }
  return ((curvatures.array() - statistics.minimum) / range).cwiseMax(0).cwiseMin(1);
}

Vector CumulativeWeights(const Vector& curvatures, const CurvatureStatistics& statistics)
{
  const double* begin = statistics.sorted.data();
  const double* end = begin + statistics.sorted.size();
  Vector weights(curvatures.size());
  ParallelFor(static_cast<Index>(curvatures.size()),
    [&](Index i)
    {
      const auto atMost = std::upper_bound(begin, end, curvatures[i]) - begin;
      weights[i] = begin == end ? 1.0 : double(atMost) / double(end - begin);
    });
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
