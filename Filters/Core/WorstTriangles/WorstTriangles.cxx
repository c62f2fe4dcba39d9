// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/WorstTriangles/WorstTriangles.h"

#include "Core/Base/Threading.h"
#include "Core/Mesh/TriangleGeometry.h"
#include "Core/WorstTriangles/DistantVertices.h"
#include "Core/WorstTriangles/VertexMoves.h"

#include <algorithm>
#include <limits>

namespace lmo
{
namespace
{
constexpr double GoalStep = 0.02;         ///< above the least t, as long as that rises
constexpr double SmallestRise = 0.01;     ///< that suffices above BadQuality
constexpr double LiftedGoal = 0.5;        ///< above it no vertex leaves its tangent plane
constexpr int MostSweeps = 10;            ///< for one goal
constexpr double LargestLoss = 2e-3;      ///< of t_mean, at which triangles are raised
constexpr double RelativeEffort = 0.9;    ///< of proofs, in terms of those until then
constexpr double EnoughEffort = 60000;    ///< where those were few
constexpr std::ptrdiff_t MostOpen = 1024; ///< vertices from which distant ones are chosen
constexpr Index ParallelMoves = 4;        ///< that are worth a thread

/// What is worth the effort.
struct Threshold
{
  MoveThreshold move;
  double stalling; ///< share of what is missing to the goal that a last sweep leaves
  double effort;   ///< share of all effort at which to stop
};
constexpr Threshold OfMany = { { 1e-3, 0.01 }, 0.98, 0.75 };
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
    , Places(guard, triangles, topology, constraints, place)
    , Moves(guard, triangles, topology.vertices)
    , Distant(triangles, topology, guard.CountReferenceTriangles())
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
  /// Tries each vertex of each triangle below the goal once.
  void Sweep(VertexPlaces::Direction direction, ProgressMonitor& monitor);

  /// Tries some vertices, of which distant ones move at once.
  /// \return those that have not moved
  std::vector<Index> Try(const std::vector<Index>& vertices, VertexPlaces::Direction direction,
    VertexPlaces::Choice choice, ProgressMonitor& monitor);

  /// Takes distant vertices from a list, and drops those that need not be tried.
  std::vector<Index> TakeDistant(
    std::vector<Index>& vertices, VertexPlaces::Direction direction, VertexPlaces::Choice choice);

  /// Sum of what the triangles lack that can move.
  double MissingToGoal() const;

  /// The triangles with t below a goal, without those that cannot move.
  std::vector<Index> WorstFirst(double goal) const;

  /// Says that a vertex has moved or has been refused.
  void Note(const VertexMove& move);

  /// False also where a search has failed already, and as long as no neighbour has moved.
  bool MayTry(Index vertex, VertexPlaces::Direction direction, VertexPlaces::Choice choice) const;

  /// Of the guard, at which this goal has had its share.
  double MostEffortNow() const
  {
    return static_cast<double>(this->EffortBefore) + this->Worth.effort * this->MostEffort;
  }

  bool IsFixed(Index i) const
  {
    return this->Constraints.freedom[i] == DisplacementConstraints::FIXED;
  }

  DeviationGuard& Guard;
  const Triangles& T;
  const MeshTopology& Topology;
  const DisplacementConstraints& Constraints;
  const VertexPlaces Places;
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
    this->Sweep(VertexPlaces::ALONG_SURFACE, monitor);
  }
  if (goal <= LiftedGoal)
  {
    this->Sweep(VertexPlaces::LIFTED, monitor);
  }
}

void Search::Sweep(VertexPlaces::Direction direction, ProgressMonitor& monitor)
{
  IndexSet vertices(this->Topology.vertices);
  for (const Index t : this->WorstFirst(this->Goal))
  {
    for (const Index i : this->T.row(t))
    {
      vertices.Add(i);
    }
  }
  const std::vector<Index> refused =
    this->Try(vertices.Get(), direction, VertexPlaces::BEST, monitor);
  this->Try(refused, direction, VertexPlaces::OTHERS, monitor);
}

std::vector<Index> Search::Try(const std::vector<Index>& vertices,
  VertexPlaces::Direction direction, VertexPlaces::Choice choice, ProgressMonitor& monitor)
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
      [&](Index k) { moves[k] = this->Places.Find(distant[k], this->Goal, direction, choice); },
      ParallelMoves);
    this->Moves.Run(moves, this->Budget, this->MostEffortNow());
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
  std::vector<Index>& vertices, VertexPlaces::Direction direction, VertexPlaces::Choice choice)
{
  std::vector<Index> distant;
  std::vector<Index> others;
  for (const Index i : vertices)
  {
    if (this->MayTry(i, direction, choice))
    {
      const bool isDistant =
        this->Distant.Add(i, [this](Index j) { return this->Guard.FindDependent(j); });
      (isDistant ? distant : others).push_back(i);
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

bool Search::MayTry(
  Index vertex, VertexPlaces::Direction direction, VertexPlaces::Choice choice) const
{
  if (static_cast<double>(this->Guard.GetEffort()) > this->MostEffortNow())
  {
    return false;
  }
  if (direction == VertexPlaces::LIFTED)
  {
    return this->Constraints.freedom[vertex] == DisplacementConstraints::IN_PLANE &&
           !this->Places.IsOnPlane(vertex);
  }
  return !this->IsFixed(vertex) && (choice == VertexPlaces::OTHERS || !this->IsExhausted[vertex]);
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
