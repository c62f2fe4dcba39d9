// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_ShiftedStiffness_h
#define lmo_ShiftedStiffness_h

#include "Core/LeastSquares/EllpackStiffness.h"
#include "Core/LeastSquares/LeastSquaresProblem.h"

namespace lmo
{
/// K + R with R = W_p / sqrt(Q): (K + R) Q (K + R) is close to A = K Q K + W_p^2, however different
/// in size its two terms are. It is the closer the less R changes from vertex to vertex, which
/// would not matter to A: instead of W_p, R has its mean over the one-ring, as long as that does
/// not outweigh K. Bounds keep K + R and Q from being singular. Vertices that are not free to move
/// in all directions, and those with very many neighbours, whose rows would make products of
/// matrices dense, are left out: their unknowns are 0.
///
/// With clamped edge weights K and Q are those that L would have with them: the ends of a very
/// short edge then have an R that is not out of all proportion to that of their neighbours, which
/// multigrid needs, while L, whose rows are scaled to a sum of 1, hardly differs.
struct ShiftedStiffness
{
  using Values = Eigen::ArrayXf;

  Laplacian L; ///< without row scales
  std::shared_ptr<const EllpackStiffness<float>> K;
  Values shift;    ///< diagonal of R, > 0
  Vector diagonal; ///< of K + R
  Values inverseQ; ///< > 0, but 0 at vertices left out
  Mask isLeftOut;

  /// \param K that of the problem's Laplacian, used unless there are clamped weights
  /// \param clampedEdgeWeights may be null
  ShiftedStiffness(const LeastSquaresProblem& problem,
    std::shared_ptr<const EllpackStiffness<float>> K,
    const std::shared_ptr<const Vector>& clampedEdgeWeights = nullptr);

  /// Entries of both matrices are in the same places.
  bool HasPatternOf(const ShiftedStiffness& other) const;

  /// Both are the same matrix; Q does not matter.
  bool IsEqualTo(const ShiftedStiffness& other) const;

  Index Size() const { return static_cast<Index>(this->shift.size()); }

  /// Calls visit(column, value) for the entries of row i; row and column of a vertex left out are
  /// empty.
  template <typename Visit>
  void ForEachEntry(Index i, const Visit& visit) const
  {
    if (this->isLeftOut[i])
    {
      return;
    }
    visit(i, this->diagonal[i]);
    const AdjacencyLists& rings = *this->L.rings;
    for (Index k = rings.offsets[i]; k < rings.offsets[i + 1]; ++k)
    {
      if (!this->isLeftOut[rings.ids[k]])
      {
        visit(rings.ids[k], this->L.edgeWeights ? -(*this->L.edgeWeights)[k] : -1.0);
      }
    }
  }

  /// The same with 1 in the diagonal of a vertex left out, so that the matrix is not singular.
  template <typename Visit>
  void ForEachEntryWithIdentity(Index i, const Visit& visit) const
  {
    if (this->isLeftOut[i])
    {
      visit(i, 1.0);
      return;
    }
    this->ForEachEntry(i, visit);
  }

  /// Calls body(rows), where rows(i) is row i of (K + R) x and cheap to copy. The rows of vertices
  /// left out have no meaning.
  /// \param x 0 at vertices left out
  template <typename Body>
  void WithRows(const PackedPoints<float>& x, const Body& body) const
  {
    this->K->WithRows(x,
      [&](const auto& Kx)
      {
        body([Kx, shift = this->shift.data(), x = View(x)](Index i)
          { return PackedRow<float>(Kx(i) + shift[i] * x.col(i)); });
      });
  }
};
}

#endif
