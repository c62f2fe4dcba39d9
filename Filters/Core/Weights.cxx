// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Weights.h"

#include <algorithm>
#include <cmath>

namespace lmo
{
namespace
{
/// The values with 24 binary digits, by Veltkamp's splitting: those that are equal but for
/// round-off get one rank, whatever the numbering of the vertices.
Vector WithoutRoundOff(const Vector& values)
{
  constexpr double largest = 1e290;
  const Vector limited = values.cwiseMin(largest);
  const Vector product = ((1 << 29) + 1) * limited;
  return product - (product - limited);
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
  return subdomain.CumulativeShares(WithoutRoundOff(curvatures), subdomain.OwnedOf(isUsed));
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

void HoldLooseComponents(const std::vector<Index>& component, const Mask& isFixed, double weight,
  Vector& positionWeights, const Subdomain& subdomain)
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
