// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/WorstTriangles/VertexPlaces.h"

#include "Core/Mesh/TriangleGeometry.h"

#include <algorithm>
#include <cmath>

namespace lmo
{
namespace
{
constexpr int Directions = 12;
constexpr double Shares[] = { 0.5, 0.25 }; ///< of the way to the best place
constexpr std::ptrdiff_t MostPlaces = 50;  ///< that are tried after these
constexpr double CosineInPlane = 0.9998;   ///< of 1 degree
}

std::vector<Vector3> VertexPlaces::DirectionsOf(Index vertex) const
{
  if (this->Constraints.freedom[vertex] == DisplacementConstraints::ALONG_LINE)
  {
    const Vector3 axis = this->Constraints.axes.row(vertex);
    return { axis, -axis };
  }
  const Vector3 normal = this->NormalAt(vertex);
  if (normal.isZero(0))
  {
    return {};
  }
  const Vector3 u = normal.unitOrthogonal();
  const Vector3 v = normal.cross(u);
  std::vector<Vector3> directions;
  for (int k = 0; k < Directions; ++k)
  {
    const double angle = 2 * Pi * k / Directions;
    const Vector3 direction = std::cos(angle) * u + std::sin(angle) * v;
    directions.push_back(direction.cwiseProduct(this->Constraints.freeAxes));
  }
  return directions;
}

bool VertexPlaces::IsOnPlane(Index vertex) const
{
  const Points& V = this->Guard.GetAccepted();
  const Vector3 normal = VertexNormal(V, this->T, this->Topology, vertex);
  const AdjacencyLists::Range corners = this->Topology.cornersAt[vertex];
  return std::all_of(corners.begin(), corners.end(),
    [&](Index corner)
    {
      const Index t = corner / 3;
      return ScaledNormal(V, this->T, t).stableNormalized().dot(normal) > CosineInPlane &&
             this->Guard.NormalBelow(t).dot(normal) > CosineInPlane;
    });
}

VertexMove VertexPlaces::Find(Index vertex, double goal, Direction direction, Choice choice) const
{
  const StarSearch star(this->Guard.GetAccepted(), this->T, this->Topology, vertex);
  const Vector3 here = this->Guard.GetAccepted().row(vertex);
  VertexMove move = { vertex, { here, star.Measure(here) }, {} };
  if (move.start.shape.minimum >= goal)
  {
    return move;
  }
  const StarSearch::Freedom freedom = this->FreedomOf(vertex);
  StarSearch::Place best = star.FindBest(move.start, freedom, goal);
  if (direction == LIFTED)
  {
    best = star.Lift(best, this->NormalAt(vertex), freedom, goal);
  }
  if (choice == BEST)
  {
    move.places = { best };
    return move;
  }
  for (const double share : Shares)
  {
    const Vector3 part = this->Place(vertex, here + share * (best.position - here));
    move.places.push_back({ part, star.Measure(part) });
  }
  const std::vector<StarSearch::Place> better = star.FindBetter(move.start, freedom, goal);
  move.places.insert(move.places.end(), better.begin(),
    better.begin() +
      std::min<std::ptrdiff_t>(static_cast<std::ptrdiff_t>(better.size()), MostPlaces));
  return move;
}
}
