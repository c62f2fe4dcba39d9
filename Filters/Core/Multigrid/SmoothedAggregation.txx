// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_SmoothedAggregation_txx
#define lmo_SmoothedAggregation_txx

#include "Core/Base/Threading.h"

#include <cmath>

namespace lmo
{
template <typename Rows>
Eigen::ArrayXf SmootherScale(const Rows& A)
{
  Eigen::ArrayXf scale(A.Size());
  ParallelFor(A.Size(),
    [&](Index i)
    {
      float sum = 0;
      A.ForEachEntry(i, [&](Index, double value) { sum += std::abs(static_cast<float>(value)); });
      scale[i] = 2 / sum;
    });
  return scale;
}

/// Negative entries that are not small beside the diagonal.
template <typename Rows>
class StrongConnections
{
public:
  explicit StrongConnections(const Rows& A)
    : A(A)
    , Diagonal(A.Size())
  {
    ParallelFor(A.Size(),
      [&](Index i)
      {
        A.ForEachEntry(i,
          [&](Index j, double value)
          {
            if (i == j)
            {
              this->Diagonal[i] = static_cast<float>(value);
            }
          });
      });
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
  const Rows& A;
  Eigen::ArrayXf Diagonal;
};

template <typename Rows>
Aggregation Aggregate(const Rows& A)
{
  constexpr Index undecided = -2;
  const StrongConnections<Rows> connections(A);
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

template <typename Rows>
SparseRows SmoothedProlongation(
  const Rows& A, const Eigen::ArrayXf& smootherScale, const Aggregation& aggregation)
{
  constexpr float damping = 4 / (3 * LargestEigenvalue);
  constexpr Index expectedEntries = 4;
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
            add(aggregateOf[j], -damping * smootherScale[i] * static_cast<float>(value));
          }
        });
    });
}
}

#endif
