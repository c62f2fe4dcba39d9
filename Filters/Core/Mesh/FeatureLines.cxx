// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Mesh/FeatureLines.h"

#include "Core/Base/Threading.h"

#include <algorithm>

namespace lmo
{
namespace
{
constexpr double CosineOfLargestTurn = 0.4999; // 60 degrees, and what round-off may add

Vector3 ClosestPointOnSegment(const Vector3& x, const Vector3& a, const Vector3& b)
{
  const Vector3 edge = b - a;
  const double squaredLength = edge.squaredNorm();
  const double t = squaredLength > 0 ? (x - a).dot(edge) / squaredLength : 0;
  return a + std::clamp(t, 0.0, 1.0) * edge;
}

/// Walks along a line from vertex i over its neighbour j, at most \a reach far, and keeps the
/// closest point to x.
void WalkLine(const FeatureLines& features, const Points& V, Index i, Index j, double reach,
  const Vector3& x, Vector3& closest)
{
  double walked = 0;
  for (Index from = i; walked <= reach;)
  {
    const Vector3 candidate = ClosestPointOnSegment(x, V.row(from), V.row(j));
    if ((candidate - x).squaredNorm() < (closest - x).squaredNorm())
    {
      closest = candidate;
    }
    if (features.pointClass[j] != FeatureLines::EDGE || j == i)
    {
      return;
    }
    walked += (V.row(j) - V.row(from)).norm();
    const Index* ends = features.lines->Begin(j);
    const Index next = ends[0] == from ? ends[1] : ends[0];
    from = j;
    j = next;
  }
}
}

bool IsSmoothTurn(const Points& V, Index previous, Index i, Index next)
{
  const Vector3 in = (V.row(i) - V.row(previous)).stableNormalized();
  const Vector3 out = (V.row(next) - V.row(i)).stableNormalized();
  return in.dot(out) >= CosineOfLargestTurn;
}

FeatureLines ClassifyLines(std::shared_ptr<const AdjacencyLists> lines, const Points& V)
{
  FeatureLines features;
  features.pointClass.assign(V.rows(), FeatureLines::SMOOTH);
  features.tangents = Points::Zero(V.rows(), 3);
  ParallelFor(static_cast<Index>(V.rows()),
    [&](Index i)
    {
      if (lines->Size(i) == 0)
      {
        return;
      }
      features.pointClass[i] = FeatureLines::CORNER;
      if (lines->Size(i) == 2)
      {
        const Index previous = lines->Begin(i)[0];
        const Index next = lines->Begin(i)[1];
        if (IsSmoothTurn(V, previous, i, next))
        {
          features.pointClass[i] = FeatureLines::EDGE;
          features.tangents.row(i) = (V.row(next) - V.row(previous)).stableNormalized();
        }
      }
    });
  features.lines = std::move(lines);
  return features;
}

Vector3 ProjectOntoLine(const FeatureLines& features, const Points& V, Index i, const Vector3& x)
{
  const double reach = 2 * (x - V.row(i)).norm();
  Vector3 closest = V.row(i);
  for (const Index j : (*features.lines)[i])
  {
    WalkLine(features, V, i, j, reach, x, closest);
  }
  return closest;
}

void ProjectOntoLines(const FeatureLines& features, const Points& V, Points& moved)
{
  ParallelFor(static_cast<Index>(V.rows()),
    [&](Index i)
    {
      if (features.pointClass[i] == FeatureLines::EDGE)
      {
        moved.row(i) = ProjectOntoLine(features, V, i, moved.row(i));
      }
    });
}
}
