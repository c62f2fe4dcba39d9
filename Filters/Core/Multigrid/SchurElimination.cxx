// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Multigrid/SchurElimination.h"

#include "Core/Base/Threading.h"

#include <algorithm>
#include <cmath>

namespace lmo
{
namespace
{
constexpr double LargestLeak = 1.6;  ///< of unknowns that stay
constexpr Index LargestValence = 20; ///< the square of it bounds the entries that are added
constexpr double FewShare = 0.02;    ///< fewer unknowns are not worth a matrix of their own

/// What becomes of an error in column i: the sum of sqrt(Q_i / Q_j) |a_ij| / a_jj. About 1 where
/// the rows of L are scaled to a sum of 1.
double Leak(const ShiftedStiffness& matrix, Index i)
{
  if (matrix.isLeftOut[i])
  {
    return 0;
  }
  double leak = 0;
  matrix.ForEachEntry(i,
    [&](Index j, double value)
    {
      if (j != i)
      {
        leak += std::sqrt(matrix.inverseQ[j]) * std::abs(value) / matrix.diagonal[j];
      }
    });
  return leak / std::sqrt(matrix.inverseQ[i]);
}

/// Unknowns that leak, of which no two are connected: those that leak most come first.
std::vector<Index> ChooseUnknowns(const ShiftedStiffness& matrix)
{
  std::vector<double> leaks(matrix.Size());
  ParallelFor(matrix.Size(), [&](Index i) { leaks[i] = Leak(matrix, i); });
  std::vector<Index> candidates;
  for (Index i = 0; i < matrix.Size(); ++i)
  {
    if (leaks[i] > LargestLeak && matrix.L.rings->Size(i) <= LargestValence)
    {
      candidates.push_back(i);
    }
  }
  std::sort(candidates.begin(), candidates.end(),
    [&](Index a, Index b) { return leaks[a] != leaks[b] ? leaks[a] > leaks[b] : a < b; });
  std::vector<Index> chosen;
  Mask isTaken(matrix.Size(), false);
  for (const Index i : candidates)
  {
    if (!isTaken[i])
    {
      chosen.push_back(i);
      matrix.ForEachEntry(i, [&](Index j, double) { isTaken[j] = true; });
    }
  }
  return chosen;
}
}

SchurElimination::SchurElimination(const ShiftedStiffness& matrix)
{
  const std::vector<Index> chosen = ChooseUnknowns(matrix);
  if (chosen.size() < FewShare * matrix.Size())
  {
    return;
  }
  this->InverseDiagonal = Eigen::ArrayXf::Zero(matrix.Size());
  for (const Index i : chosen)
  {
    this->InverseDiagonal[i] = static_cast<float>(1 / matrix.diagonal[i]);
  }
  this->PlaceOf.resize(matrix.Size());
  for (Index i = 0; i < matrix.Size(); ++i)
  {
    this->PlaceOf[i] = this->NumberOfOthers;
    this->NumberOfOthers += !this->IsEliminated(i);
  }
  constexpr Index expectedEntries = 2;
  const SparseRows prolongation =
    MakeSparseRows(matrix.Size(), this->NumberOfOthers, expectedEntries,
      [&](Index i, const auto& add)
      {
        if (!this->IsEliminated(i))
        {
          add(this->PlaceOf[i], 1);
          return;
        }
        matrix.ForEachEntry(i,
          [&](Index j, double value)
          {
            if (j != i)
            {
              add(this->PlaceOf[j], static_cast<float>(-value / matrix.diagonal[i]));
            }
          });
      });
  this->Prolongation = PaddedCsrMatrix(prolongation);
  this->Restriction = PaddedCsrMatrix(prolongation.transpose());
}

SparseRows SchurElimination::SchurComplement(const ShiftedStiffness& matrix) const
{
  std::vector<Index> others(this->NumberOfOthers);
  for (Index i = 0; i < matrix.Size(); ++i)
  {
    if (!this->IsEliminated(i))
    {
      others[this->PlaceOf[i]] = i;
    }
  }
  constexpr Index expectedEntries = 8;
  return MakeSparseRows(this->NumberOfOthers, this->NumberOfOthers, expectedEntries,
    [&](Index row, const auto& add)
    {
      matrix.ForEachEntry(others[row],
        [&](Index j, double value)
        {
          if (!this->IsEliminated(j))
          {
            add(this->PlaceOf[j], static_cast<float>(value));
            return;
          }
          matrix.ForEachEntry(j,
            [&](Index k, double other)
            {
              if (k != j)
              {
                add(this->PlaceOf[k], static_cast<float>(-value * other / matrix.diagonal[j]));
              }
            });
        });
    });
}

void SchurElimination::Restrict(
  const PackedPoints<float>& rightHandSide, PackedPoints<float>& restricted) const
{
  ParallelFor(this->NumberOfOthers,
    [rows = PaddedCsrMatrix::Times(this->Restriction, rightHandSide),
      restricted = View(restricted)](Index i) mutable { restricted.col(i) = rows(i); });
}

void SchurElimination::Prolong(const PackedPoints<float>& others,
  const PackedPoints<float>& rightHandSide, PackedPoints<float>& solution) const
{
  ParallelFor(static_cast<Index>(this->PlaceOf.size()),
    [rows = PaddedCsrMatrix::Times(this->Prolongation, others), b = View(rightHandSide),
      inverseD = this->InverseDiagonal.data(), x = View(solution)](Index i) mutable
    { x.col(i) = rows(i) + inverseD[i] * b.col(i); });
}
}
