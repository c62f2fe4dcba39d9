// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_StarSearch_h
#define lmo_StarSearch_h

#include "Core/Mesh/MeshTopology.h"

#include <functional>

namespace lmo
{
/// t of the cells at a vertex.
struct StarShape
{
  double minimum = 1;
  double sum = 0;

  void Add(double t)
  {
    this->minimum = t < this->minimum ? t : this->minimum;
    this->sum += t;
  }

  /// Compares the minima first, up to the goal, then the sums; round-off does not decide.
  bool IsBetter(const StarShape& other, double goal) const
  {
    const double here = this->minimum < goal ? this->minimum : goal;
    const double there = other.minimum < goal ? other.minimum : goal;
    constexpr double tie = 1e-9;
    return here > there + tie || (here > there - tie && this->sum > other.sum + tie);
  }
};

/// The cells at one vertex as functions of its position: their quality, and the place where the
/// least of it is greatest.
class StarSearch
{
public:
  struct Place
  {
    Vector3 position;
    StarShape shape;
  };

  /// Reads the cells at a vertex.
  StarSearch(
    const Points& V, const Triangles& triangles, const MeshTopology& topology, Index vertex);

  /// Mean distance of the other corners of the vertex's cells.
  double GetSize() const { return this->Size; }

  /// With the vertex at a position. A triangle that has turned over since the cells were read
  /// counts as t = -1.
  /// \param least stops at t below it
  StarShape Measure(const Vector3& position, double least = -2) const;

  /// Where the vertex may be.
  struct Freedom
  {
    std::vector<Vector3> directions;              ///< of steps, unit vectors
    std::function<Vector3(const Vector3&)> place; ///< the closest position that the vertex may have
    std::function<bool(const Vector3&)>
      isAllowed; ///< asked for what is better than the best so far
  };

  /// The best place that a search in steps finds, which are halved where none leads to a better
  /// one. The mean ratio is quasi-concave in the position (Amenta, Bern, Eppstein 1999); t is
  /// nearly so for good triangles, and for bad ones FindBetter() may find what this search does
  /// not.
  /// \param start where the search begins
  /// \param goal t above which the minimum does not count
  Place FindBest(const Place& start, const Freedom& freedom, double goal) const;

  /// All better places among those at some distances in the directions, the best first.
  std::vector<Place> FindBetter(const Place& start, const Freedom& freedom, double goal) const;

  /// The least height above or below a place where the minimum reaches the goal, or else the best
  /// one: three triangles around a vertex in their plane have t = 0.46 at most.
  /// \param normal unit vector
  Place Lift(const Place& start, const Vector3& normal, const Freedom& freedom, double goal) const;

private:
  struct Cell
  {
    Index begin; ///< of its corners but the vertex, in Corners
    Index end;
    Vector3 normal; ///< of a triangle, not normalised; 0 for larger polygons
  };

  void AddTriangle(const Points& V, const Triangles& triangles, Index corner);
  void AddPolygon(
    const Points& V, const AdjacencyLists& cornersOfPolygons, Index polygon, Index vertex);
  /// Makes a position the best one, if it is better.
  bool Try(const Vector3& position, const Freedom& freedom, double goal, Place& best) const;
  double MeasureCell(const Cell& cell, const Vector3& position) const;

  std::vector<Cell> Cells;
  std::vector<Vector3> Corners;
  double Size = 0;
};
}

#endif
