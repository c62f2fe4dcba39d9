// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_SmoothedAggregation_txx
#define lmo_SmoothedAggregation_txx

#include "Core/Base/Threading.h"

namespace lmo
{
/// Negative entries that are not small beside the diagonal.
template <typename Matrix>
class StrongConnections
{
public:
  explicit StrongConnections(const Matrix& A)
    : A(A)
    , Diagonal(A.Size())
  {
    ParallelFor(
      A.Size(), [&](Index i) { this->Diagonal[i] = static_cast<float>(DiagonalEntry(A, i)); });
  }

  /// Calls visit(j, magnitude) for the strong connections of unknown i.
  template <typename Visit>
  void ForEach(Index i, const Visit& visit) const
  {
    constexpr double threshold = 0.08; // relative to the geometric mean of the diagonals
    const double least = threshold * threshold * this->Diagonal[i];
    this->A.ForEachEntry(i,
      [&](Index j, double value)
      {
        if (j != i && value < 0 && value * value > least * this->Diagonal[j])
        {
          visit(j, -value);
        }
      });
  }

private:
  const Matrix& A;
  Eigen::ArrayXf Diagonal;
};

template <typename Matrix>
Aggregation Aggregate(const Matrix& A)
{
  constexpr Index undecided = -2;
  const StrongConnections<Matrix> connections(A);
  Aggregation result;
  std::vector<Index>& aggregateOf = result.aggregateOf;
  aggregateOf.assign(A.Size(), undecided);
  for (Index i = 0; i < A.Size(); ++i)
  {
    if (aggregateOf[i] != undecided)
    {
      continue;
    }
    bool isConnected = false;
    bool isNeighbourhoodFree = true;
    connections.ForEach(i,
      [&](Index j, double)
      {
        isConnected = true;
        isNeighbourhoodFree = isNeighbourhoodFree && aggregateOf[j] < 0;
      });
    if (!isConnected)
    {
      aggregateOf[i] = -1;
    }
    else if (isNeighbourhoodFree)
    {
      aggregateOf[i] = result.count;
      connections.ForEach(i, [&](Index j, double) { aggregateOf[j] = result.count; });
      ++result.count;
    }
  }
  // The others join the aggregate of their strongest neighbour that has one.
  const std::vector<Index> first = aggregateOf;
  for (Index i = 0; i < A.Size(); ++i)
  {
    if (first[i] == undecided)
    {
      double strongest = 0;
      connections.ForEach(i,
        [&](Index j, double magnitude)
        {
          if (first[j] >= 0 && magnitude > strongest)
          {
            strongest = magnitude;
            aggregateOf[i] = first[j];
          }
        });
      aggregateOf[i] = strongest > 0 ? aggregateOf[i] : result.count++;
    }
  }
  return result;
}

template <typename Matrix>
SparseRows SmoothedProlongation(
  const Matrix& A, const ChebyshevSmoother& smoother, const Aggregation& aggregation)
{
  constexpr float damping = 4 / (3 * ChebyshevSmoother::LargestEigenvalue);
  constexpr Index expectedEntries = 4;
  const Eigen::ArrayXf& scale = smoother.GetScale();
  const std::vector<Index>& aggregateOf = aggregation.aggregateOf;
  return MakeSparseRows(A.Size(), aggregation.count, expectedEntries,
    [&](Index i, const auto& add)
    {
      if (aggregateOf[i] >= 0)
      {
        add(aggregateOf[i], 1);
      }
      A.ForEachEntry(i,
        [&](Index j, double value)
        {
          if (aggregateOf[j] >= 0)
          {
            add(aggregateOf[j], -damping * scale[i] * static_cast<float>(value));
          }
        });
    });
}
}

#endif
