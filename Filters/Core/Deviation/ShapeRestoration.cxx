// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Deviation/ShapeRestoration.h"

#include "Core/Deviation/TriangleValidity.h"
#include "Core/Mesh/TriangleGeometry.h"

#include <algorithm>

namespace lmo
{
namespace
{
constexpr double TurnedShare = 0.01;  ///< of the triangles, which may turn over without noise
constexpr double SmallestShare = 0.1; ///< of a displacement that is worth keeping
}

ShapeRestoration::ShapeRestoration(const Points& start, const Triangles& triangles,
  const MeshTopology& topology, const std::vector<Index>& component)
  : Start(start)
  , T(triangles)
  , Component(component)
  , Components(component.empty() ? 0 : *std::max_element(component.begin(), component.end()) + 1)
  , Normals(NormalsToKeep(start, triangles, topology))
{
}

bool ShapeRestoration::IsTurned(const Points& positions, Index t) const
{
  return HasTurnedOver(this->Normals.row(t), ScaledNormal(positions, this->T, t));
}

Mask ShapeRestoration::FindTurned(const Points& positions) const
{
  Vector excess = Vector::Zero(this->Components);
  for (Index t = 0; t < static_cast<Index>(this->T.rows()); ++t)
  {
    const bool wasInverted = this->Normals.row(t).isZero(0);
    excess[this->ComponentOf(t)] += this->IsTurned(positions, t) - TurnedShare - wasInverted;
  }
  Mask isTurned(this->Components);
  std::transform(
    excess.begin(), excess.end(), isTurned.begin(), [](double share) { return share > 0; });
  return isTurned;
}

void ShapeRestoration::Restore(const Mask& isChosen, Points& positions) const
{
  const Points displacement = positions - this->Start;
  Vector share = Vector::Ones(positions.rows());
  for (bool isChanged = true; isChanged;)
  {
    isChanged = false;
    for (Index t = 0; t < static_cast<Index>(this->T.rows()); ++t)
    {
      if (isChosen[this->ComponentOf(t)] && this->IsTurned(positions, t))
      {
        for (const Index i : this->T.row(t))
        {
          isChanged = isChanged || share[i] > 0;
          share[i] = share[i] > 2 * SmallestShare ? 0.5 * share[i] : 0;
          positions.row(i) = this->Start.row(i) + share[i] * displacement.row(i);
        }
      }
    }
  }
}
}
