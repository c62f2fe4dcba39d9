// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_SparseProduct_txx
#define lmo_SparseProduct_txx

#include "Core/Base/Threading.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace lmo
{
/// Sums the entries of one row at a time, without a branch that the processor could not predict.
class RowAccumulator
{
public:
  explicit RowAccumulator(Index columns)
    : Cells(columns)
    , Ids(columns + std::size_t(1))
  {
  }

  void Add(Index column, float value)
  {
    Cell& cell = this->Cells[column];
    cell.sum += value;
    this->Ids[this->Size] = column;
    this->Size += !cell.isInRow;
    cell.isInRow = true;
  }

  /// Appends the row and starts the next one.
  Index MoveTo(std::vector<Index>& ids, std::vector<float>& values)
  {
    ids.insert(ids.end(), this->Ids.begin(), this->Ids.begin() + this->Size);
    for (Index k = 0; k < this->Size; ++k)
    {
      Cell& cell = this->Cells[this->Ids[k]];
      values.push_back(cell.sum);
      cell = Cell();
    }
    return std::exchange(this->Size, 0);
  }

private:
  struct Cell
  {
    float sum = 0;
    int isInRow = false;
  };
  std::vector<Cell> Cells; ///< of each column
  std::vector<Index> Ids;  ///< of the columns in the row, and room for one more
  Index Size = 0;
};

template <typename Fill>
SparseRows MakeSparseRows(Index rows, Index columns, Index expectedEntries, const Fill& fill)
{
  struct Range
  {
    Index begin = 0;
    std::vector<Index> ids;
    std::vector<float> values;
  };
  std::vector<Range> ranges(rows / ParallelBlock + 1);
  SparseRows matrix(rows, columns);
  Index* offsets = matrix.outerIndexPtr();
  offsets[0] = 0;
  ParallelRanges(rows,
    [&](Index begin, Index end)
    {
      Range& range = ranges[begin / ParallelBlock];
      range.begin = begin;
      range.ids.reserve(std::size_t(expectedEntries) * (end - begin));
      range.values.reserve(std::size_t(expectedEntries) * (end - begin));
      RowAccumulator row(columns);
      for (Index i = begin; i < end; ++i)
      {
        fill(i, [&](Index column, float value) { row.Add(column, value); });
        offsets[i + 1] = row.MoveTo(range.ids, range.values);
      }
    });
  std::partial_sum(offsets, offsets + rows + 1, offsets);
  matrix.resizeNonZeros(offsets[rows]);
  ParallelTasks(static_cast<Index>(ranges.size()),
    [&](Index k)
    {
      const Range& range = ranges[k];
      const Index first = offsets[range.begin];
      std::copy(range.ids.begin(), range.ids.end(), matrix.innerIndexPtr() + first);
      std::copy(range.values.begin(), range.values.end(), matrix.valuePtr() + first);
    });
  return matrix;
}

template <typename Rows>
SparseRows Multiply(const Rows& A, const SparseRows& B, Index expectedEntries)
{
  return MakeSparseRows(A.Size(), static_cast<Index>(B.cols()), expectedEntries,
    [&](Index i, const auto& add)
    {
      A.ForEachEntry(i,
        [&](Index k, float a)
        {
          for (SparseRows::InnerIterator b(B, k); b; ++b)
          {
            add(static_cast<Index>(b.col()), a * b.value());
          }
        });
    });
}
}

#endif
