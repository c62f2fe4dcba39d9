// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Operators/Weights.h"

#include "Core/Base/Threading.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace lmo
{
namespace
{
/// The value with 24 binary digits: values that are equal but for round-off get one rank, whatever
/// the numbering of the vertices.
double WithoutRoundOff(double value)
{
  constexpr std::uint64_t half = std::uint64_t(1) << 28;
  std::uint64_t bits = 0;
  static_assert(sizeof(bits) == sizeof(value));
  std::memcpy(&bits, &value, sizeof(bits));
  bits = (bits + half) & ~(2 * half - 1);
  std::memcpy(&value, &bits, sizeof(bits));
  return value;
}
}

CurvatureStatistics ComputeStatistics(
  const Vector& curvatures, const Mask& isUsed, const Subdomain& subdomain)
{
  std::vector<double> values;
  values.reserve(curvatures.size());
  for (Eigen::Index i = 0; i < curvatures.size(); ++i)
  {
    if (isUsed[i] && subdomain.OwnsVertex(static_cast<Index>(i)))
    {
      values.push_back(curvatures[i]);
    }
  }
  CurvatureStatistics statistics;
  if (subdomain.Sum(double(values.size())) == 0)
  {
    return statistics;
  }
  double minimum = HUGE_VAL;
  for (const double value : values)
  {
    minimum = std::min(minimum, value);
    statistics.maximum = std::max(statistics.maximum, value);
  }
  statistics.minimum = -subdomain.Maximum(-minimum);
  statistics.maximum = subdomain.Maximum(statistics.maximum);
  const double firstQuartile = subdomain.Quantile(values, 0.25);
  const double thirdQuartile = subdomain.Quantile(std::move(values), 0.75);
  statistics.threshold = thirdQuartile + 1.5 * (thirdQuartile - firstQuartile);
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

Vector CumulativeWeights(const Vector& curvatures, const Mask& isUsed, const Subdomain& subdomain)
{
  Vector rounded(curvatures.size());
  ParallelFor(static_cast<Index>(curvatures.size()),
    [&](Index i) { rounded[i] = WithoutRoundOff(curvatures[i]); });
  return subdomain.CumulativeShares(rounded, subdomain.OwnedOf(isUsed));
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

void WeightUnconstrainedComponents(const std::vector<Index>& component, const Mask& isFixed,
  double weight, Vector& positionWeights, const Subdomain& subdomain)
{
  Mask isHeld(component.size(), 0);
  for (std::size_t i = 0; i < component.size(); ++i)
  {
    isHeld[component[i]] |=
      subdomain.OwnsVertex(static_cast<Index>(i)) && (isFixed[i] || positionWeights[i] > 0);
  }
  subdomain.UniteFlags(component, isHeld);
  for (std::size_t i = 0; i < component.size(); ++i)
  {
    if (!isHeld[component[i]])
    {
      positionWeights[i] = weight;
    }
  }
}
}
