// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Deviation/WorstTriangles.h"

#include "Core/Deviation/StarSearch.h"
#include "Core/Mesh/TriangleGeometry.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lmo
{
namespace
{
constexpr double GoalStep = 0.02;     ///< above the least t, as long as that rises
constexpr double SmallestRise = 0.01; ///< that suffices above BadQuality
constexpr double LiftedGoal = 0.5;    ///< above it no vertex leaves its tangent plane
constexpr int MostSweeps = 10;        ///< for one goal
constexpr int Directions = 12;
constexpr double LargestLoss = 2e-3;          ///< of t_mean, at which triangles are raised
constexpr double MostLossForGain = 25;        ///< of the sum of t, for a gain of the least t
constexpr double RelativeEffort = 1.25;       ///< of proofs, in terms of those until then
constexpr double EnoughEffort = 60000;        ///< where those were few
constexpr double Shares[] = { 1, 0.5, 0.25 }; ///< of a displacement that the guard is asked for
constexpr std::size_t MostPlaces = 50;        ///< that it is asked for where it refuses the best

/// What is worth the effort.
struct Threshold
{
  double gain;         ///< in t, by a move
  double relativeGain; ///< the same, in terms of t
  double stalling;     ///< share of what is missing to the goal that a last sweep leaves
  double effort;       ///< share of all effort at which to stop
};
constexpr Threshold OfMany = { 1e-3, 0.01, 0.95, 0.75 };
constexpr Threshold OfWorst = { 2e-4, 0, 0.995, 1 };

Index CountCells(const Triangles& triangles, const MeshTopology& topology)
{
  return topology.polygons.IsEmpty() ? static_cast<Index>(triangles.rows())
                                     : topology.polygons.Size();
}

class Search
{
public:
  Search(DeviationGuard& guard, const Triangles& triangles, const MeshTopology& topology,
    const DisplacementConstraints& constraints, const PlaceVertex& place)
    : Guard(guard)
    , T(triangles)
    , Topology(topology)
    , Constraints(constraints)
    , Place(place)
    , Star(guard.GetAccepted(), triangles, topology)
    , LossLeft(LargestLoss * CountCells(triangles, topology))
    , EffortBefore(guard.GetEffort())
    , MostEffort(EnoughEffort + RelativeEffort * static_cast<double>(guard.GetEffort()))
    , IsExhausted(topology.vertices, false)
  {
  }

  /// Raises the triangles with t below the goal, the worst first.
  void Raise(double goal, const Threshold& worth, ProgressMonitor& monitor)
  {
    this->Worth = worth;
    std::fill(this->IsExhausted.begin(), this->IsExhausted.end(), false);
    double before = std::numeric_limits<double>::infinity();
    for (int sweep = 0; sweep < MostSweeps; ++sweep)
    {
      const double missing = this->MissingTo(goal);
      if (!(missing < worth.stalling * before))
      {
        break;
      }
      before = missing;
      this->Sweep(goal, ALONG_SURFACE, monitor);
    }
    if (goal <= LiftedGoal)
    {
      this->Sweep(goal, LIFTED, monitor);
    }
  }

  /// t of the worst triangle that can move.
  double GetLeast() const
  {
    const std::vector<Index> worst = this->WorstFirst(1);
    return worst.empty() ? 1 : this->Guard.GetAcceptedQuality()[worst.front()];
  }

private:
  enum Move
  {
    ALONG_SURFACE,
    LIFTED ///< off the surface, where nothing else helps
  };

  /// Tries each vertex of each triangle below the goal once.
  void Sweep(double goal, Move move, ProgressMonitor& monitor)
  {
    for (const Index t : this->WorstFirst(goal))
    {
      monitor.Report(0);
      for (int k = 0; k < 3 && this->Guard.GetAcceptedQuality()[t] < goal; ++k)
      {
        this->Improve(this->T(t, k), goal, move);
      }
    }
  }

  /// Sum of what the triangles lack that can move.
  double MissingTo(double goal) const
  {
    double missing = 0;
    for (const Index t : this->WorstFirst(goal))
    {
      missing += goal - this->Guard.GetAcceptedQuality()[t];
    }
    return missing;
  }

  bool IsFixed(Index i) const
  {
    return this->Constraints.freedom[i] == DisplacementConstraints::FIXED;
  }

  /// The triangles with t below the goal, without those that cannot move.
  std::vector<Index> WorstFirst(double goal) const
  {
    const Vector& quality = this->Guard.GetAcceptedQuality();
    std::vector<Index> worst;
    for (Index t = 0; t < static_cast<Index>(quality.size()); ++t)
    {
      const bool isPinned = this->IsFixed(this->T(t, 0)) && this->IsFixed(this->T(t, 1)) &&
                            this->IsFixed(this->T(t, 2));
      if (quality[t] < goal && !isPinned && !IsDegenerate(this->T, t))
      {
        worst.push_back(t);
      }
    }
    // In single precision, so that round-off does not order equal triangles.
    std::stable_sort(worst.begin(), worst.end(),
      [&](Index s, Index t)
      { return static_cast<float>(quality[s]) < static_cast<float>(quality[t]); });
    return worst;
  }

  /// Unit normal of the vertex within the free axes; 0 where undefined.
  Vector3 NormalAt(Index vertex) const
  {
    const Vector3 normal = VertexNormal(this->Guard.GetAccepted(), this->T, this->Topology, vertex);
    return normal.cwiseProduct(this->Constraints.freeAxes).stableNormalized();
  }

  /// Unit directions in which the vertex may move.
  std::vector<Vector3> DirectionsOf(Index vertex) const
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

  /// \param least t that no triangle may fall below
  /// \return whether the guard accepts the position
  bool TryMove(Index vertex, const Vector3& position, double least)
  {
    ProgressMonitor unwatched;
    this->Guard.Propose(vertex, position);
    const bool isValid =
      this->Guard.Judge({ vertex }, least, DeviationGuard::FIRST_FAILURE, unwatched).empty();
    isValid ? this->Guard.Accept() : this->Guard.RollBack();
    return isValid;
  }

  /// False also where a search has failed already, and as long as no neighbour has moved.
  bool MayTry(Index vertex, Move move) const
  {
    const auto effort = static_cast<double>(this->Guard.GetEffort() - this->EffortBefore);
    if (effort > this->Worth.effort * this->MostEffort)
    {
      return false;
    }
    if (move == LIFTED)
    {
      return this->Constraints.freedom[vertex] == DisplacementConstraints::IN_PLANE &&
             !this->Star.IsFlat(vertex);
    }
    return !this->IsFixed(vertex) && !this->IsExhausted[vertex];
  }

  /// Moves the vertex to where the least t around it is greatest, if that pays.
  void Improve(Index vertex, double goal, Move move)
  {
    if (!this->MayTry(vertex, move))
    {
      return;
    }
    this->Star.SetVertex(vertex);
    const Vector3 here = this->Guard.GetAccepted().row(vertex);
    const StarSearch::Place start{ here, this->Star.Measure(here) };
    const StarSearch::Freedom freedom = this->FreedomOf(vertex);
    StarSearch::Place best = this->Star.FindBest(start, freedom, goal);
    if (move == LIFTED)
    {
      best = this->Star.Lift(best, this->NormalAt(vertex), freedom, goal);
    }
    this->IsExhausted[vertex] = !this->MoveTowards(vertex, start, best.position, goal) &&
                                !this->MoveAnywhere(vertex, start, freedom, goal);
    if (!this->IsExhausted[vertex])
    {
      for (const Index j : this->Topology.oneRings[vertex])
      {
        this->IsExhausted[j] = false;
      }
    }
  }

  StarSearch::Freedom FreedomOf(Index vertex)
  {
    return { this->DirectionsOf(vertex),
      [this, vertex](const Vector3& x) { return this->Place(vertex, x); },
      [this, vertex](const Vector3& x) { return this->Guard.IsValid(vertex, x); } };
  }

  /// Moves the vertex as far towards a position as the guard allows, in three attempts.
  bool MoveTowards(
    Index vertex, const StarSearch::Place& start, const Vector3& position, double goal)
  {
    for (const double share : Shares)
    {
      const Vector3 part =
        share == 1 ? position
                   : this->Place(vertex, start.position + share * (position - start.position));
      if (this->MoveTo(vertex, start, { part, this->Star.Measure(part) }, goal))
      {
        return true;
      }
    }
    return false;
  }

  /// Moves the vertex to the best one of many places that the guard accepts.
  bool MoveAnywhere(
    Index vertex, const StarSearch::Place& start, const StarSearch::Freedom& freedom, double goal)
  {
    std::vector<StarSearch::Place> places = this->Star.FindBetter(start, freedom, goal);
    places.resize(std::min(places.size(), MostPlaces));
    return std::any_of(places.begin(), places.end(),
      [&](const StarSearch::Place& to) { return this->MoveTo(vertex, start, to, goal); });
  }

  bool MoveTo(
    Index vertex, const StarSearch::Place& start, const StarSearch::Place& to, double goal)
  {
    if (!this->IsWorthIt(start.shape, to.shape, goal) ||
        !this->TryMove(vertex, to.position, start.shape.minimum))
    {
      return false;
    }
    this->LossLeft += to.shape.sum - start.shape.sum;
    return true;
  }

  bool IsWorthIt(const StarShape& before, const StarShape& after, double goal) const
  {
    const double gain = after.minimum - before.minimum;
    const double least = this->Worth.gain + this->Worth.relativeGain * before.minimum;
    const bool isEnough = gain > (after.minimum >= goal ? 0 : least);
    const double loss = before.sum - after.sum;
    return isEnough && loss <= this->LossLeft && loss <= MostLossForGain * gain;
  }

  DeviationGuard& Guard;
  const Triangles& T;
  const MeshTopology& Topology;
  const DisplacementConstraints& Constraints;
  const PlaceVertex& Place;
  StarSearch Star;
  Threshold Worth = OfMany;
  double LossLeft;                 ///< of the sum of all t
  const std::int64_t EffortBefore; ///< of proofs
  const double MostEffort;
  Mask IsExhausted; ///< no position helps the vertex, as long as its neighbours stay
};
}

void ImproveWorstTriangles(DeviationGuard& guard, const Triangles& triangles,
  const MeshTopology& topology, const DisplacementConstraints& constraints,
  const PlaceVertex& place, ProgressMonitor& monitor)
{
  Search search(guard, triangles, topology, constraints, place);
  search.Raise(BadQuality, OfMany, monitor);
  double least = search.GetLeast();
  double goal = 0;
  for (double rise = 1; rise > 0 || goal < LiftedGoal;)
  {
    // Where the worst triangle is stuck, the others may still rise, and loosen it.
    goal = rise > 0 ? least + GoalStep : LiftedGoal;
    search.Raise(goal, OfWorst, monitor);
    const double gain = search.GetLeast() - least;
    least += gain;
    rise = least < BadQuality || gain > SmallestRise ? gain : 0;
  }
}
}
