// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Multigrid/BasisFunctions.h"

#include "Core/Multigrid/SmoothedAggregation.h"

#include <algorithm>
#include <utility>

namespace lmo
{
namespace
{
constexpr Index Support = 4; ///< largest number of functions that are not 0 at a place

/// The Laplacian of the graph of the one-rings, as SmoothedAggregation takes matrices.
class RingGraph
{
public:
  explicit RingGraph(const AdjacencyLists& rings)
    : Rings(rings)
  {
  }

  Index Size() const { return static_cast<Index>(this->Rings.offsets.size()) - 1; }

  template <typename Visit>
  void ForEachEntry(Index i, const Visit& visit) const
  {
    visit(i, double(this->Rings.Size(i)));
    for (const Index j : this->Rings[i])
    {
      visit(j, -1.0);
    }
  }

private:
  const AdjacencyLists& Rings;
};

SparseRows Indicators(const Aggregation& aggregation)
{
  const std::vector<Index>& aggregateOf = aggregation.aggregateOf;
  return MakeSparseRows(static_cast<Index>(aggregateOf.size()), aggregation.count, 1,
    [&](Index i, const auto& add)
    {
      if (aggregateOf[i] >= 0)
      {
        add(aggregateOf[i], 1);
      }
    });
}

/// The mean of each function over every vertex and its neighbours.
template <typename Graph>
SparseRows Average(const Graph& graph, const SparseRows& functions)
{
  return MakeSparseRows(graph.Size(), static_cast<Index>(functions.cols()), Support,
    [&](Index i, const auto& add)
    {
      float count = 0;
      graph.ForEachEntry(i, [&](Index, double) { ++count; });
      graph.ForEachEntry(i,
        [&](Index j, double)
        {
          for (SparseRows::InnerIterator entry(functions, j); entry; ++entry)
          {
            add(static_cast<Index>(entry.col()), entry.value() / count);
          }
        });
    });
}

/// The largest entries of each row, with the sum 1.
SparseRows KeepLargest(const SparseRows& functions)
{
  return MakeSparseRows(static_cast<Index>(functions.rows()), static_cast<Index>(functions.cols()),
    Support,
    [&](Index i, const auto& add)
    {
      std::vector<std::pair<float, Index>> entries;
      for (SparseRows::InnerIterator entry(functions, i); entry; ++entry)
      {
        entries.emplace_back(-entry.value(), static_cast<Index>(entry.col()));
      }
      const auto kept = std::min<std::size_t>(Support, entries.size());
      std::partial_sort(entries.begin(), entries.begin() + kept, entries.end());
      entries.resize(kept);
      float sum = 0;
      for (const auto& [negative, column] : entries)
      {
        sum -= negative;
      }
      for (const auto& [negative, column] : entries)
      {
        add(column, -negative / sum);
      }
    });
}

/// Adds the functions of the next scale.
/// \return the graph of their aggregates; empty if there are no coarser ones
template <typename Graph>
SparseRows AddScale(const Graph& graph, std::vector<SparseRows>& scales)
{
  constexpr Index fewest = 8;
  constexpr double largestCoarseningRatio = 0.8;
  constexpr Index expectedEntries = 8;
  const Aggregation aggregation = Aggregate(graph);
  if (aggregation.count == 0 || aggregation.count > largestCoarseningRatio * graph.Size())
  {
    return {};
  }
  const SparseRows indicators = Indicators(aggregation);
  scales.push_back(KeepLargest(Average(graph, Average(graph, indicators))));
  if (aggregation.count <= fewest)
  {
    return {};
  }
  const SparseRows members = indicators.transpose();
  return Multiply(
    SparseRowList(members), Multiply(graph, indicators, expectedEntries), expectedEntries);
}
}

std::vector<SparseRows> BasisFunctions(const AdjacencyLists& rings, ProgressMonitor& monitor)
{
  std::vector<SparseRows> scales;
  SparseRows graph = AddScale(RingGraph(rings), scales);
  while (graph.rows() > 0)
  {
    monitor.Report(0);
    graph = AddScale(SparseRowList(graph), scales);
  }
  return scales;
}
}
