// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SharedPoints.h"

#include "CoincidentPoints.h"
#include "InputFaults.h"

#include <algorithm>
#include <numeric>

namespace lmo
{
namespace
{
using Ids = std::vector<Index>::const_iterator;

/// Calls visit(first, last) for each run of points that are the same.
template <typename AreSame, typename Visit>
void ForEachRun(const std::vector<Index>& points, const AreSame& areSame, const Visit& visit)
{
  for (auto first = points.begin(); first != points.end();)
  {
    auto last = first + 1;
    while (last != points.end() && areSame(*first, *last))
    {
      ++last;
    }
    visit(first, last);
    first = last;
  }
}

std::vector<Index> EachPointItself(Eigen::Index size)
{
  std::vector<Index> points(size);
  std::iota(points.begin(), points.end(), Index(0));
  return points;
}

/// The points of one place that are the same vertex.
class PlaceOfPieces
{
public:
  PlaceOfPieces(const Points& V, const Triangles& triangles, const std::vector<Index>& pieceOf)
    : CornersAt(CornersAtVertices(static_cast<Index>(V.rows()), triangles))
    , Corners(triangles)
    , PieceOf(pieceOf)
  {
  }

  std::vector<Index> SameVertex(Ids first, Ids last) const
  {
    std::vector<Use> uses;
    std::transform(first, last, std::back_inserter(uses), [&](Index i) { return this->UseOf(i); });
    const auto highest = std::max_element(uses.begin(), uses.end());
    if (*highest == Use::NONE)
    {
      return {};
    }
    const Index anchor = *(first + (highest - uses.begin()));
    const bool isAtBorder = *highest == Use::BORDER;
    const auto isElsewhere = [&](Index i) { return this->PieceOf[i] != this->PieceOf[anchor]; };
    bool isShared = false;
    for (auto point = first; point != last; ++point)
    {
      isShared = isShared || (isElsewhere(*point) && uses[point - first] != Use::NONE);
    }
    std::vector<Index> same;
    for (auto point = first; point != last; ++point)
    {
      const Use use = uses[point - first];
      const bool joins =
        isElsewhere(*point) ? use != Use::INSIDE || isAtBorder : use != Use::INSIDE && isShared;
      if (joins || *point == anchor)
      {
        same.push_back(*point);
      }
    }
    return same;
  }

private:
  enum class Use
  {
    NONE,
    INSIDE,
    BORDER
  };

  Use UseOf(Index point) const
  {
    return this->CornersAt.Size(point) == 0                      ? Use::NONE
           : IsOnBoundary(this->CornersAt, this->Corners, point) ? Use::BORDER
                                                                 : Use::INSIDE;
  }

  const AdjacencyLists CornersAt;
  const Triangles& Corners;
  const std::vector<Index>& PieceOf;
};

/// \throw InputError if points lie apart from those whose vertex they are.
void CheckThatSamePointsAreClose(const Points& V, const std::vector<Index>& lowest)
{
  constexpr double largestShift = 1e-6; // of the extent, for coordinates that were rounded
  const double extent =
    V.rows() > 0 ? (V.colwise().maxCoeff() - V.colwise().minCoeff()).maxCoeff() : 0;
  Faults apart;
  for (Index i = 0; i < static_cast<Index>(V.rows()); ++i)
  {
    if ((V.row(i) - V.row(lowest[i])).lpNorm<Eigen::Infinity>() > largestShift * extent)
    {
      apart.Add(i);
    }
  }
  apart.ThrowIfAny("point lies apart from another one with its global id",
    "points lie apart from others with their global ids", "point",
    "Remove the array of global ids, and points that coincide will be one.");
}
}

std::vector<Index> FindPointsOfSamePlace(
  const Points& V, const Triangles& triangles, const std::vector<Index>& pieceOf)
{
  const std::vector<Index> twins = PointsWithTwins(V);
  const PlaceOfPieces places(V, triangles, pieceOf);
  std::vector<Index> lowest = EachPointItself(V.rows());
  bool areAnySame = false;
  ForEachRun(
    twins, [&](Index i, Index j) { return V.row(i) == V.row(j); },
    [&](Ids first, Ids last)
    {
      const std::vector<Index> same = places.SameVertex(first, last);
      areAnySame = areAnySame || same.size() > 1;
      for (const Index i : same)
      {
        lowest[i] = same.front();
      }
    });
  return areAnySame ? lowest : std::vector<Index>();
}

std::vector<Index> FindPointsOfSameId(const Points& V, const std::vector<std::int64_t>& ids)
{
  std::vector<Index> points = EachPointItself(V.rows());
  std::sort(points.begin(), points.end(),
    [&](Index i, Index j) { return ids[i] != ids[j] ? ids[i] < ids[j] : i < j; });
  std::vector<Index> lowest = EachPointItself(V.rows());
  bool areAnySame = false;
  ForEachRun(
    points, [&](Index i, Index j) { return ids[i] == ids[j]; },
    [&](Ids first, Ids last)
    {
      areAnySame = areAnySame || last - first > 1;
      std::for_each(first, last, [&](Index i) { lowest[i] = *first; });
    });
  CheckThatSamePointsAreClose(V, lowest);
  return areAnySame ? lowest : std::vector<Index>();
}
}
