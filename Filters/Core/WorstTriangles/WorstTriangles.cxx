// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/WorstTriangles/WorstTriangles.h"

#include "Core/Base/Threading.h"
#include "Core/Mesh/TriangleGeometry.h"
#include "Core/WorstTriangles/DistantVertices.h"
#include "Core/WorstTriangles/VertexMoves.h"

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
constexpr double FlatHeight = 0.01;   ///< of a plane's reference, in mean edge lengths
constexpr int MostSweeps = 10;        ///< for one goal
constexpr int Directions = 12;
constexpr double LargestLoss = 2e-3;       ///< of t_mean, at which triangles are raised
constexpr double RelativeEffort = 1.25;    ///< of proofs, in terms of those until then
constexpr double EnoughEffort = 60000;     ///< where those were few
constexpr double Shares[] = { 0.5, 0.25 }; ///< of a displacement that the guard is asked for
constexpr std::ptrdiff_t MostPlaces = 50;  ///< that it is asked for where it refuses the best
constexpr std::ptrdiff_t MostOpen = 1024;  ///< vertices from which distant ones are chosen
constexpr Index ParallelMoves = 4;         ///< that are worth a thread

/// What is worth the effort.
struct Threshold
{
  MoveThreshold move;
  double stalling; ///< share of what is missing to the goal that a last sweep leaves
  double effort;   ///< share of all effort at which to stop
};
constexpr Threshold OfMany = { { 1e-3, 0.01 }, 0.95, 0.75 };
constexpr Threshold OfWorst = { { 2e-4, 0 }, 0.995, 1 };

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
    , Moves(guard, triangles, topology.vertices)
    , Distant(triangles, topology)
    , Budget(LargestLoss * CountCells(triangles, topology))
    , EffortBefore(guard.GetEffort())
    , MostEffort(EnoughEffort + RelativeEffort * static_cast<double>(guard.GetEffort()))
    , IsExhausted(topology.vertices, false)
  {
  }

  /// Raises the triangles with t below the goal, the worst first.
  void Raise(double goal, const Threshold& worth, ProgressMonitor& monitor);

  /// t of the worst triangle that can move.
  double GetLeast() const
  {
    const std::vector<Index> worst = this->WorstFirst(1);
    return worst.empty() ? 1 : this->Guard.GetAcceptedQuality()[worst.front()];
  }

private:
  enum Direction
  {
    ALONG_SURFACE,
    LIFTED ///< off the surface, where nothing else helps
  };

  /// Which places a vertex tries.
  enum Choice
  {
    BEST,  ///< the best one
    OTHERS ///< a part of the way there, and other better ones
  };

  /// Tries each vertex of each triangle below the goal once.
  void Sweep(Direction direction, ProgressMonitor& monitor);

  /// Tries some vertices, of which distant ones move at once.
  /// \return those that have not moved
  std::vector<Index> Try(const std::vector<Index>& vertices, Direction direction, Choice choice,
    ProgressMonitor& monitor);

  /// Takes distant vertices from a list, and drops those that need not be tried.
  std::vector<Index> TakeDistant(std::vector<Index>& vertices, Direction direction, Choice choice);

  /// Sum of what the triangles lack that can move.
  double MissingToGoal() const;

  /// The triangles with t below a goal, without those that cannot move.
  std::vector<Index> WorstFirst(double goal) const;

  /// The places to try, if a triangle at the vertex is below the goal.
  VertexMove FindPlaces(Index vertex, Direction direction, Choice choice) const;

  /// Says that a vertex has moved or has been refused.
  void Note(const VertexMove& move);

  /// False also where a search has failed already, and as long as no neighbour has moved.
  bool MayTry(Index vertex, Direction direction, Choice choice) const;

  /// True if mesh and reference are flat around the vertex, and are to stay so.
  bool IsOnPlane(Index vertex) const;

  bool IsFixed(Index i) const
  {
    return this->Constraints.freedom[i] == DisplacementConstraints::FIXED;
  }

  /// Unit normal of the vertex within the free axes; 0 where undefined.
  Vector3 NormalAt(Index vertex) const
  {
    const Vector3 normal = VertexNormal(this->Guard.GetAccepted(), this->T, this->Topology, vertex);
    return normal.cwiseProduct(this->Constraints.freeAxes).stableNormalized();
  }

  /// Unit directions in which the vertex may move.
  std::vector<Vector3> DirectionsOf(Index vertex) const;

  StarSearch::Freedom FreedomOf(Index vertex) const
  {
    return { this->DirectionsOf(vertex),
      [this, vertex](const Vector3& x) { return this->Place(vertex, x); },
      [this, vertex](const Vector3& x) { return this->Guard.IsValid(vertex, x); } };
  }

  DeviationGuard& Guard;
  const Triangles& T;
  const MeshTopology& Topology;
  const DisplacementConstraints& Constraints;
  const PlaceVertex& Place;
  VertexMoves Moves;
  DistantVertices Distant; ///< empty in between
  MoveBudget Budget;
  double Goal = 0;
  Threshold Worth = OfMany;
  const std::int64_t EffortBefore; ///< of proofs
  const double MostEffort;
  Mask IsExhausted; ///< no position helps the vertex, as long as its neighbours stay
};

void Search::Raise(double goal, const Threshold& worth, ProgressMonitor& monitor)
{
  this->Goal = goal;
  this->Worth = worth;
  this->Budget.SetGoal(goal, worth.move);
  std::fill(this->IsExhausted.begin(), this->IsExhausted.end(), false);
  double before = std::numeric_limits<double>::infinity();
  for (int sweep = 0; sweep < MostSweeps; ++sweep)
  {
    const double missing = this->MissingToGoal();
    if (!(missing < worth.stalling * before))
    {
      break;
    }
    before = missing;
    this->Sweep(ALONG_SURFACE, monitor);
  }
  if (goal <= LiftedGoal)
  {
    this->Sweep(LIFTED, monitor);
  }
}

void Search::Sweep(Direction direction, ProgressMonitor& monitor)
{
  IndexSet vertices(this->Topology.vertices);
  for (const Index t : this->WorstFirst(this->Goal))
  {
    for (const Index i : this->T.row(t))
    {
      vertices.Add(i);
    }
  }
  const std::vector<Index> refused = this->Try(vertices.Get(), direction, BEST, monitor);
  this->Try(refused, direction, OTHERS, monitor);
}

std::vector<Index> Search::Try(
  const std::vector<Index>& vertices, Direction direction, Choice choice, ProgressMonitor& monitor)
{
  std::vector<Index> refused;
  std::vector<Index> open;
  auto next = vertices.begin();
  while (next != vertices.end() || !open.empty())
  {
    monitor.Report(0);
    const auto end =
      next + std::min(vertices.end() - next, MostOpen - static_cast<std::ptrdiff_t>(open.size()));
    open.insert(open.end(), next, end);
    next = end;
    const std::vector<Index> distant = this->TakeDistant(open, direction, choice);
    std::vector<VertexMove> moves(distant.size());
    ParallelFor(
      static_cast<Index>(distant.size()),
      [&](Index k) { moves[k] = this->FindPlaces(distant[k], direction, choice); }, ParallelMoves);
    this->Moves.Run(moves, this->Budget);
    for (const VertexMove& move : moves)
    {
      this->Note(move);
      if (!move.isMoved && !move.places.empty())
      {
        refused.push_back(move.vertex);
      }
    }
  }
  return refused;
}

std::vector<Index> Search::TakeDistant(
  std::vector<Index>& vertices, Direction direction, Choice choice)
{
  std::vector<Index> distant;
  std::vector<Index> others;
  for (const Index i : vertices)
  {
    if (this->MayTry(i, direction, choice))
    {
      (this->Distant.Add(i) ? distant : others).push_back(i);
    }
  }
  this->Distant.Clear();
  vertices = std::move(others);
  return distant;
}

double Search::MissingToGoal() const
{
  double missing = 0;
  for (const Index t : this->WorstFirst(this->Goal))
  {
    missing += this->Goal - this->Guard.GetAcceptedQuality()[t];
  }
  return missing;
}

std::vector<Index> Search::WorstFirst(double goal) const
{
  const Vector& quality = this->Guard.GetAcceptedQuality();
  std::vector<Index> worst;
  for (Index t = 0; t < static_cast<Index>(quality.size()); ++t)
  {
    const bool isPinned =
      this->IsFixed(this->T(t, 0)) && this->IsFixed(this->T(t, 1)) && this->IsFixed(this->T(t, 2));
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

std::vector<Vector3> Search::DirectionsOf(Index vertex) const
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

bool Search::IsOnPlane(Index vertex) const
{
  const Points& V = this->Guard.GetAccepted();
  HeightRange heights;
  for (const Index corner : this->Topology.cornersAt[vertex])
  {
    heights.Add(this->Guard.GetHeights(corner / 3));
  }
  const double size = StarSearch(V, this->T, this->Topology, vertex).GetSize();
  return heights.Largest() < FlatHeight * size && IsFlatAt(V, this->T, this->Topology, vertex);
}

bool Search::MayTry(Index vertex, Direction direction, Choice choice) const
{
  const auto effort = static_cast<double>(this->Guard.GetEffort() - this->EffortBefore);
  if (effort > this->Worth.effort * this->MostEffort)
  {
    return false;
  }
  if (direction == LIFTED)
  {
    return this->Constraints.freedom[vertex] == DisplacementConstraints::IN_PLANE &&
           !this->IsOnPlane(vertex);
  }
  return !this->IsFixed(vertex) && (choice == OTHERS || !this->IsExhausted[vertex]);
}

VertexMove Search::FindPlaces(Index vertex, Direction direction, Choice choice) const
{
  const StarSearch star(this->Guard.GetAccepted(), this->T, this->Topology, vertex);
  const Vector3 here = this->Guard.GetAccepted().row(vertex);
  VertexMove move = { vertex, { here, star.Measure(here) }, {} };
  if (move.start.shape.minimum >= this->Goal)
  {
    return move;
  }
  const StarSearch::Freedom freedom = this->FreedomOf(vertex);
  StarSearch::Place best = star.FindBest(move.start, freedom, this->Goal);
  if (direction == LIFTED)
  {
    best = star.Lift(best, this->NormalAt(vertex), freedom, this->Goal);
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
  const std::vector<StarSearch::Place> better = star.FindBetter(move.start, freedom, this->Goal);
  move.places.insert(move.places.end(), better.begin(),
    better.begin() +
      std::min<std::ptrdiff_t>(static_cast<std::ptrdiff_t>(better.size()), MostPlaces));
  return move;
}

void Search::Note(const VertexMove& move)
{
  this->IsExhausted[move.vertex] = !move.isMoved;
  if (move.isMoved)
  {
    for (const Index j : this->Topology.oneRings[move.vertex])
    {
      this->IsExhausted[j] = false;
    }
  }
}
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
