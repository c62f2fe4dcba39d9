// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_VertexMoves_h
#define lmo_VertexMoves_h

#include "Core/Deviation/DeviationGuard.h"
#include "Core/WorstTriangles/StarSearch.h"

namespace lmo
{
/// What is worth moving a vertex.
struct MoveThreshold
{
  double gain;         ///< in t
  double relativeGain; ///< the same, in terms of t
};

/// Decides which moves pay: the mean of t may fall for its minimum, but not by more than is left.
class MoveBudget
{
public:
  /// \param loss of the sum of all t
  explicit MoveBudget(double loss)
    : LossLeft(loss)
  {
  }

  /// \param goal t that is worth any gain
  void SetGoal(double goal, const MoveThreshold& worth)
  {
    this->Goal = goal;
    this->Worth = worth;
  }

  /// Takes the loss of a move, if it pays.
  /// \return whether it does
  bool Take(const StarShape& before, const StarShape& after);

  /// Gives back what Take() took.
  void Return(const StarShape& before, const StarShape& after)
  {
    this->LossLeft += before.sum - after.sum;
  }

private:
  double Goal = 0;
  MoveThreshold Worth = {};
  double LossLeft;
};

/// A vertex and the places that it may move to, the first choice first.
struct VertexMove
{
  Index vertex;
  StarSearch::Place start;
  std::vector<StarSearch::Place> places;
  std::size_t next = 0; ///< place to try
  bool isMoved = false;
};

/// Moves vertices that are distant from each other (DistantVertices), all at once.
class VertexMoves
{
public:
  /// Keeps references to the arguments.
  VertexMoves(DeviationGuard& guard, const Triangles& triangles, Index vertices)
    : Guard(guard)
    , T(triangles)
    , MoveOf(vertices, nullptr)
  {
  }

  /// Moves each vertex to the first of its places that pays and that the guard accepts.
  /// \param mostEffort of the guard, beyond which no more places are tried
  void Run(std::vector<VertexMove>& moves, MoveBudget& budget, double mostEffort);

private:
  /// Proposes the next place that pays, or else the old one.
  void ProposeNext(VertexMove& move, MoveBudget& budget);

  /// Judges what is proposed, and other places where the guard refuses it.
  /// \return whether a proposal was found that the guard accepts
  bool Judge(std::vector<Index> proposed, MoveBudget& budget);

  /// Proposes other places for the vertices that are to blame for the failures.
  /// \return these vertices
  std::vector<Index> ProposeOthers(
    const std::vector<DeviationGuard::Failure>& failures, MoveBudget& budget);

  DeviationGuard& Guard;
  const Triangles& T;
  double MostEffort = 0;
  std::vector<VertexMove*> MoveOf; ///< of each vertex; null for those that have none
};
}

#endif
