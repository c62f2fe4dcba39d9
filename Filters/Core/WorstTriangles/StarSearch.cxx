// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/WorstTriangles/StarSearch.h"

#include "Core/Mesh/TriangleGeometry.h"
#include "Core/Mesh/TriangleQuality.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace lmo
{
namespace
{
constexpr double LongestStep = 0.4;   ///< in mean edge lengths
constexpr double ShortestStep = 0.01; ///< the place is not worth more
constexpr int StepsOfLength = 4;      ///< before steps become shorter
constexpr double LiftStep = 0.01;     ///< in mean edge lengths
constexpr double HighestLift = 0.105; ///< the same; it tilts three triangles by 20 degrees
constexpr double TurnedOver = -1;     ///< in the place of t
}

StarSearch::StarSearch(
  const Points& V, const Triangles& triangles, const MeshTopology& topology, Index vertex)
{
  const Polygons& polygons = topology.polygons;
  Index last = -1;
  for (const Index corner : topology.cornersAt[vertex])
  {
    if (polygons.IsEmpty())
    {
      this->AddTriangle(V, triangles, corner);
    }
    else if (polygons.ofTriangle[corner / 3] != last)
    {
      last = polygons.ofTriangle[corner / 3];
      this->AddPolygon(V, polygons.corners, last, vertex);
    }
  }
  double sum = 0;
  for (const Vector3& corner : this->Corners)
  {
    sum += (corner - V.row(vertex)).norm();
  }
  this->Size = this->Corners.empty() ? 0 : sum / static_cast<double>(this->Corners.size());
}

void StarSearch::AddTriangle(const Points& V, const Triangles& triangles, Index corner)
{
  const Vector3 here = V.row(triangles.data()[corner]);
  const Vector3 next = V.row(triangles.data()[NextCorner(corner)]);
  const Vector3 previous = V.row(triangles.data()[PreviousCorner(corner)]);
  const auto begin = static_cast<Index>(this->Corners.size());
  this->Corners.push_back(next);
  this->Corners.push_back(previous);
  this->Cells.push_back({ begin, begin + 2, (next - here).cross(previous - here) });
}

void StarSearch::AddPolygon(
  const Points& V, const AdjacencyLists& cornersOfPolygons, Index polygon, Index vertex)
{
  const Index* ids = cornersOfPolygons.Begin(polygon);
  const Index size = cornersOfPolygons.Size(polygon);
  const auto first = static_cast<Index>(std::find(ids, ids + size, vertex) - ids);
  const auto begin = static_cast<Index>(this->Corners.size());
  for (Index k = 1; k < size; ++k)
  {
    this->Corners.push_back(V.row(ids[(first + k) % size]));
  }
  this->Cells.push_back({ begin, begin + size - 1, Vector3::Zero() });
}

double StarSearch::MeasureCell(const Cell& cell, const Vector3& position) const
{
  const Vector3* others = this->Corners.data() + cell.begin;
  if (cell.end - cell.begin > 2)
  {
    return CellQuality(cell.end - cell.begin + 1,
      [&](Index k) -> Vector3 { return k == 0 ? position : others[k - 1]; });
  }
  return (others[0] - position).cross(others[1] - position).dot(cell.normal) < 0
           ? TurnedOver
           : RadiusRatio(position, others[0], others[1]);
}

StarShape StarSearch::Measure(const Vector3& position, double least) const
{
  StarShape shape;
  for (const Cell& cell : this->Cells)
  {
    shape.Add(this->MeasureCell(cell, position));
    if (shape.minimum < least)
    {
      break;
    }
  }
  return shape;
}

StarSearch::Place StarSearch::FindBest(
  const Place& start, const Freedom& freedom, double goal) const
{
  Place best = start;
  for (double step = LongestStep; step > ShortestStep; step /= 2)
  {
    bool isBetter = true;
    for (int k = 0; k < StepsOfLength && isBetter; ++k)
    {
      isBetter = false;
      const Vector3 from = best.position;
      for (const Vector3& direction : freedom.directions)
      {
        isBetter |= this->Try(from + step * this->Size * direction, freedom, goal, best);
      }
    }
  }
  return best;
}

std::vector<StarSearch::Place> StarSearch::FindBetter(
  const Place& start, const Freedom& freedom, double goal) const
{
  std::vector<Place> places;
  for (double step = LongestStep; step > ShortestStep; step /= 2)
  {
    for (const Vector3& direction : freedom.directions)
    {
      Place place = start;
      if (this->Try(start.position + step * this->Size * direction, freedom, goal, place))
      {
        places.push_back(place);
      }
    }
  }
  std::stable_sort(places.begin(), places.end(),
    [goal](const Place& a, const Place& b) { return a.shape.IsBetter(b.shape, goal); });
  return places;
}

StarSearch::Place StarSearch::Lift(
  const Place& start, const Vector3& normal, const Freedom& freedom, double goal) const
{
  Place best = start;
  for (double height = LiftStep; height < HighestLift && best.shape.minimum < goal;
       height += LiftStep)
  {
    const Vector3 offset = height * this->Size * normal;
    this->Try(start.position + offset, freedom, goal, best);
    this->Try(start.position - offset, freedom, goal, best);
  }
  return best;
}

bool StarSearch::Try(
  const Vector3& position, const Freedom& freedom, double goal, Place& best) const
{
  const Vector3 placed = freedom.place(position);
  const StarShape shape = this->Measure(placed, std::min(best.shape.minimum, goal));
  const bool isBetter = shape.IsBetter(best.shape, goal) && freedom.isAllowed(placed);
  if (isBetter)
  {
    best = { placed, shape };
  }
  return isBetter;
}
}
