// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_SchurElimination_txx
#define lmo_SchurElimination_txx

namespace lmo
{
template <typename Matrix>
SchurElimination::SchurElimination(const Matrix& A, const std::vector<Index>& unknowns)
  : InverseDiagonal(Eigen::ArrayXf::Zero(A.Size()))
  , IndexOf(A.Size())
{
  for (const Index i : unknowns)
  {
    this->InverseDiagonal[i] = static_cast<float>(1 / DiagonalEntry(A, i));
  }
  for (Index i = 0; i < A.Size(); ++i)
  {
    this->IndexOf[i] = this->NumberOfOthers;
    this->NumberOfOthers += !this->IsEliminated(i);
  }
  constexpr Index expectedEntries = 2;
  const SparseRows prolongation = MakeSparseRows(A.Size(), this->NumberOfOthers, expectedEntries,
    [&](Index i, const auto& add)
    {
      if (!this->IsEliminated(i))
      {
        add(this->IndexOf[i], 1);
        return;
      }
      const double diagonal = DiagonalEntry(A, i);
      A.ForEachEntry(i,
        [&](Index j, double value)
        {
          if (j != i)
          {
            add(this->IndexOf[j], static_cast<float>(-value / diagonal));
          }
        });
    });
  this->Prolongation = PaddedCsrMatrix(prolongation);
  this->Restriction = PaddedCsrMatrix(prolongation.transpose());
}

template <typename Matrix>
SparseRows SchurElimination::SchurComplement(const Matrix& A) const
{
  std::vector<Index> others(this->NumberOfOthers);
  for (Index i = 0; i < A.Size(); ++i)
  {
    if (!this->IsEliminated(i))
    {
      others[this->IndexOf[i]] = i;
    }
  }
  constexpr Index expectedEntries = 8;
  return MakeSparseRows(this->NumberOfOthers, this->NumberOfOthers, expectedEntries,
    [&](Index row, const auto& add)
    {
      A.ForEachEntry(others[row],
        [&](Index j, double value)
        {
          if (!this->IsEliminated(j))
          {
            add(this->IndexOf[j], static_cast<float>(value));
            return;
          }
          const double diagonal = DiagonalEntry(A, j);
          A.ForEachEntry(j,
            [&](Index k, double other)
            {
              if (k != j)
              {
                add(this->IndexOf[k], static_cast<float>(-value * other / diagonal));
              }
            });
        });
    });
}
}

#endif
