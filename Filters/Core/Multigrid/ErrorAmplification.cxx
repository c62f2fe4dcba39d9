// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Multigrid/ErrorAmplification.h"

#include "Core/Base/Threading.h"

#include <algorithm>
#include <cmath>

namespace lmo
{
namespace
{
constexpr double LargestAmplification = 1.6; ///< of unknowns that stay
constexpr Index LargestValence = 20; ///< the square of it bounds the entries that elimination adds
constexpr double FewShare = 0.02;    ///< fewer unknowns are not worth a matrix of their own

/// What becomes of an error in column i: the sum of sqrt(Q_i / Q_j) |a_ij| / a_jj. About 1 where
/// the rows of L are scaled to a sum of 1.
double Amplification(const ShiftedStiffness& matrix, Index i)
{
  if (matrix.isLeftOut[i])
  {
    return 0;
  }
  double amplification = 0;
  matrix.ForEachEntry(i,
    [&](Index j, double value)
    {
      if (j != i)
      {
        amplification += std::sqrt(matrix.inverseQ[j]) * std::abs(value) / matrix.diagonal[j];
      }
    });
  return amplification / std::sqrt(matrix.inverseQ[i]);
}
}

std::vector<Index> AmplifyingUnknowns(const ShiftedStiffness& matrix)
{
  std::vector<double> factor(matrix.Size());
  ParallelFor(matrix.Size(), [&](Index i) { factor[i] = Amplification(matrix, i); });
  std::vector<Index> candidates;
  for (Index i = 0; i < matrix.Size(); ++i)
  {
    if (factor[i] > LargestAmplification && matrix.L.rings->Size(i) <= LargestValence)
    {
      candidates.push_back(i);
    }
  }
  std::sort(candidates.begin(), candidates.end(),
    [&](Index a, Index b) { return factor[a] != factor[b] ? factor[a] > factor[b] : a < b; });
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
  return chosen.size() < FewShare * matrix.Size() ? std::vector<Index>() : chosen;
}
}
