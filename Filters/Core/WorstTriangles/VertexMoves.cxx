// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/WorstTriangles/VertexMoves.h"

#include <algorithm>

namespace lmo
{
namespace
{
constexpr double MostLossForGain = 25; ///< of the sum of t, for a gain of the least t
}

bool MoveBudget::Take(const StarShape& before, const StarShape& after)
{
  const double gain = after.minimum - before.minimum;
  const double least = this->Worth.gain + this->Worth.relativeGain * before.minimum;
  const bool isEnough = gain > (after.minimum >= this->Goal ? 0 : least);
  const double loss = before.sum - after.sum;
  const bool pays = isEnough && loss <= this->LossLeft && loss <= MostLossForGain * gain;
  this->LossLeft -= pays ? loss : 0;
  return pays;
}

void VertexMoves::ProposeNext(VertexMove& move, MoveBudget& budget)
{
  const bool mayTry = static_cast<double>(this->Guard.GetEffort()) < this->MostEffort;
  move.isMoved = false;
  while (mayTry && !move.isMoved && move.next < move.places.size())
  {
    move.isMoved = budget.Take(move.start.shape, move.places[move.next++].shape);
  }
  this->Guard.Propose(
    move.vertex, move.isMoved ? move.places[move.next - 1].position : move.start.position);
}

std::vector<Index> VertexMoves::ProposeOthers(
  const std::vector<DeviationGuard::Failure>& failures, MoveBudget& budget)
{
  const auto isMoving = [this](Index i) { return this->MoveOf[i] && this->MoveOf[i]->isMoved; };
  std::vector<Index> refused;
  ForEachToBlame(failures, this->T, isMoving, [&](Index i) { refused.push_back(i); });
  std::sort(refused.begin(), refused.end());
  refused.erase(std::unique(refused.begin(), refused.end()), refused.end());
  for (const Index i : refused)
  {
    VertexMove& move = *this->MoveOf[i];
    budget.Return(move.start.shape, move.places[move.next - 1].shape);
    this->ProposeNext(move, budget);
  }
  return refused;
}

bool VertexMoves::Judge(std::vector<Index> proposed, MoveBudget& budget)
{
  ProgressMonitor unwatched;
  std::vector<DeviationGuard::Failure> failures;
  while (!proposed.empty())
  {
    failures = this->Guard.Judge(proposed, 0, DeviationGuard::SINGLE_VERTICES, unwatched);
    proposed = this->ProposeOthers(failures, budget);
  }
  return failures.empty();
}

void VertexMoves::Run(std::vector<VertexMove>& moves, MoveBudget& budget, double mostEffort)
{
  this->MostEffort = mostEffort;
  std::vector<Index> proposed;
  for (VertexMove& move : moves)
  {
    this->MoveOf[move.vertex] = &move;
    this->ProposeNext(move, budget);
    if (move.isMoved)
    {
      proposed.push_back(move.vertex);
    }
  }
  const bool areValid = this->Judge(std::move(proposed), budget);
  areValid ? this->Guard.Accept() : this->Guard.RollBack();
  for (VertexMove& move : moves)
  {
    move.isMoved = move.isMoved && areValid;
    this->MoveOf[move.vertex] = nullptr;
  }
}
}
