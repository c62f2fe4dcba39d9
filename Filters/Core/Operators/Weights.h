// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_Weights_h
#define lmo_Weights_h

#include "Core/Mesh/Subdomain.h"

namespace lmo
{
/// Weights are squared, multiplied by lengths and squared again: beyond these bounds numbers in
/// double precision overflow or vanish.
constexpr double LargestWeight = 1e40;
constexpr double SmallestScaleFactor = 1e-40;

/// Distribution of the mean curvature over the vertices that a triangle uses.
struct CurvatureStatistics
{
  double minimum = 0;
  double maximum = 0;
  double threshold = 0; ///< kappa_tau = Q3 + 1.5 (Q3 - Q1), the box-plot test (Tukey 1977)
};

/// \param curvatures kappa >= 0, one per vertex
/// \param isUsed the vertices that count
CurvatureStatistics ComputeStatistics(
  const Vector& curvatures, const Mask& isUsed, const Subdomain& subdomain = Subdomain());

/// Section 5: W_linear / s. Maps [kappa_min, min(kappa_max, kappa_tau)] linearly to [0, 1] and
/// clamps. If that interval is empty because most vertices have the least curvature, as on a CAD
/// part with flat faces, they have 0 and all others 1; if all curvatures are equal, 1 everywhere.
Vector LinearWeights(const Vector& curvatures, const CurvatureStatistics& statistics);

/// Eqn. 13: C(kappa), the share of the vertices that count whose curvature is at most kappa, in
/// [0, 1]; more than 0 at vertices that count. Curvatures that differ by round-off count as equal.
Vector CumulativeWeights(
  const Vector& curvatures, const Mask& isUsed, const Subdomain& subdomain = Subdomain());

/// Section 5.3: 1 - weights. With linear weights this is W_L = (s I - W_linear) / s.
Vector ComplementWeights(const Vector& weights);

/// Section 6: exp(-kappa^2 / 2 sigma^2), in [0, 1].
/// \param sigma > 0 in the unit of the curvatures; 0 gives 1 where kappa = 0 and 0 elsewhere.
Vector GaussianWeights(const Vector& curvatures, double sigma);

/// Section 3: anchors. 1 where the tag is not zero, else 0.
Vector AnchorWeights(const Vector& tags);

/// Gives \a weight to every vertex of a component in which no vertex is fixed and no weight is
/// positive: nothing else would determine where it is.
/// \param component connected component of each vertex
void WeightUnconstrainedComponents(const std::vector<Index>& component, const Mask& isFixed,
  double weight, Vector& positionWeights, const Subdomain& subdomain = Subdomain());
}

#endif
