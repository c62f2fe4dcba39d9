// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_NormalAlignmentTerm_h
#define lmo_NormalAlignmentTerm_h

#include "Core/LeastSquares/EnergyTerm.h"
#include "Core/Mesh/MeshTopology.h"

#include <algorithm>

namespace lmo
{
/// Triangles that shall have given normals m: the sum over the triangles t and their corners k of
/// (m_t (V_k + d_k - c_t))^2, where c_t is the centroid of t at V + d.
struct NormalAlignmentTerm
{
  Triangles triangles; ///< no rows if the problem has no such term
  AdjacencyLists cornersAt;
  Points normals;       ///< m, one unit row per triangle, or 0
  CornerValues heights; ///< m_t (V_k - centroid of t at V)

  NormalAlignmentTerm() = default;
  NormalAlignmentTerm(
    const Points& V, const Triangles& triangles, AdjacencyLists cornersAt, Points normals);

  bool IsCoupled() const { return this->triangles.rows() > 0; }

  double Energy(const Points& d) const;

  auto ResidualRows(const Points& d) const
  {
    return [this, moved = this->MovedHeights(d)](Index i, Vector3& sum)
    {
      this->ForEachCornerAt(
        i, [&](Index corner) { sum -= moved.data()[corner] * this->normals.row(corner / 3); });
    };
  }

  void AddDiagonal(Index i, DiagonalBlock& block) const;

  void AddEntries(MatrixEntries& entries) const;

  template <typename Visit>
  void ForEachCornerAt(Index i, const Visit& visit) const
  {
    if (this->IsCoupled())
    {
      std::for_each(this->cornersAt.Begin(i), this->cornersAt.End(i), visit);
    }
  }

  /// m_t (V_k + d_k - c_t) for the corners of a triangle; d without rows stands for 0.
  Vector3 MovedHeightsOf(Index t, const Points& d) const;

  /// The same for all triangles.
  CornerValues MovedHeights(const Points& d) const;

  template <typename Scalar>
  class Product
  {
  public:
    static constexpr bool IsForCoupled = true;

    /// Keeps a reference to \a term.
    explicit Product(const NormalAlignmentTerm& term);

    /// Computes m_t (x_k - mean of x over t) for each corner.
    void Prepare(const PackedPoints<Scalar>& x);

    template <typename Body>
    void WithRows(const Body& body) const
    {
      body(
        [term = &this->Term, heights = this->Heights.data(), normals = View(this->Normals)](
          Index i, const PackedRow<Scalar>&, PackedRow<Scalar>& sum)
        {
          term->ForEachCornerAt(
            i, [&](Index corner) { sum += heights[corner] * normals.col(corner / 3); });
        });
    }

  private:
    const NormalAlignmentTerm& Term;
    PackedPoints<Scalar> Normals;
    Eigen::Array<Scalar, 3, Eigen::Dynamic> Heights;
  };
};
}

#endif
