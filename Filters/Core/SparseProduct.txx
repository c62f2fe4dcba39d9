// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_SparseProduct_txx
#define lmo_SparseProduct_txx

#include "Parallel.h"

#include <algorithm>
#include <numeric>

namespace lmo
{
/// Sums the entries of one row at a time.
class RowAccumulator
{
public:
  explicit RowAccumulator(Index columns)
    : PlaceOf(columns, -1)
  {
  }

  void Add(Index column, float value)
  {
    Index& place = this->PlaceOf[column];
    if (place < 0)
    {
      place = static_cast<Index>(this->Ids.size());
      this->Ids.push_back(column);
      this->Values.push_back(value);
    }
    else
    {
      this->Values[place] += value;
    }
  }

  /// Appends the row, in ascending order of the columns, and starts the next one.
  Index MoveTo(std::vector<Index>& ids, std::vector<float>& values)
  {
    const auto size = static_cast<Index>(this->Ids.size());
    std::sort(this->Ids.begin(), this->Ids.end());
    for (const Index column : this->Ids)
    {
      ids.push_back(column);
      values.push_back(this->Values[this->PlaceOf[column]]);
      this->PlaceOf[column] = -1;
    }
    this->Ids.clear();
    this->Values.clear();
    return size;
  }

private:
  std::vector<Index> PlaceOf; ///< of each column in Values, -1 if it is not in the row
  std::vector<Index> Ids;
  std::vector<float> Values;
};

template <typename Fill>
SparseRows MakeSparseRows(Index rows, Index columns, const Fill& fill)
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
      RowAccumulator row(columns);
      for (Index i = begin; i < end; ++i)
      {
        fill(i, [&](Index column, float value) { row.Add(column, value); });
        offsets[i + 1] = row.MoveTo(range.ids, range.values);
      }
    });
  std::partial_sum(offsets, offsets + rows + 1, offsets);
  matrix.resizeNonZeros(offsets[rows]);
  for (const Range& range : ranges)
  {
    std::copy(range.ids.begin(), range.ids.end(), matrix.innerIndexPtr() + offsets[range.begin]);
    std::copy(range.values.begin(), range.values.end(), matrix.valuePtr() + offsets[range.begin]);
  }
  return matrix;
}

inline SparseRows Multiply(const SparseRows& A, const SparseRows& B)
{
  return MakeSparseRows(static_cast<Index>(A.rows()), static_cast<Index>(B.cols()),
    [&](Index i, const auto& add)
    {
      for (SparseRows::InnerIterator a(A, i); a; ++a)
      {
        for (SparseRows::InnerIterator b(B, a.col()); b; ++b)
        {
          add(b.col(), a.value() * b.value());
        }
      }
    });
}
}

#endif
