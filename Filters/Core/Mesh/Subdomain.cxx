// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Mesh/Subdomain.h"

namespace lmo
{
Mask Subdomain::OwnedOf(Mask mask) const
{
  for (std::size_t i = 0; i < mask.size(); ++i)
  {
    mask[i] = mask[i] && this->OwnsVertex(static_cast<Index>(i));
  }
  return mask;
}

Eigen::AlignedBox3d Subdomain::Unite(const Eigen::AlignedBox3d& box) const
{
  Eigen::AlignedBox3d united;
  for (int c = 0; c < 3; ++c)
  {
    united.min()[c] = -this->Maximum(-box.min()[c]);
    united.max()[c] = this->Maximum(box.max()[c]);
  }
  return united;
}

double Subdomain::Quantile(std::vector<double> values, double q) const
{
  return lmo::Quantile(std::move(values), q);
}

Vector Subdomain::CumulativeShares(const Vector& values, const Mask& counts) const
{
  return lmo::CumulativeShares(values, counts);
}

void Subdomain::UniteFlags(const std::vector<Index>&, Mask&) const {}

void Subdomain::SumOverComponents(const std::vector<Index>&, Eigen::ArrayXXd&) const {}

void Subdomain::ProjectOntoLines(const FeatureLines& features, const Points& V, Points& moved) const
{
  lmo::ProjectOntoLines(features, V, moved);
}
}
