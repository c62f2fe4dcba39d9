// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_PolylineTerm_h
#define lmo_PolylineTerm_h

#include "Core/LeastSquares/EnergyTerm.h"
#include "Core/Mesh/MeshTopology.h"

#include <algorithm>

namespace lmo
{
/// A row of the Laplacian of a polyline: weight (l(d) - target) with
/// l(d) = share d_previous + (1 - share) d_next - d_vertex.
struct PolylineRow
{
  Index vertex;
  Index previous;
  Index next;
  double weight;
  Vector3 target;
  double share = 0.5;

  /// The derivative of l by the vertex at place 0 (previous), 1 (vertex) or 2 (next).
  double Coefficient(Index place) const
  {
    return place == 1 ? -1 : place == 0 ? this->share : 1 - this->share;
  }

  /// l(d)
  Vector3 Apply(const Points& d) const
  {
    return this->share * d.row(this->previous) + (1 - this->share) * d.row(this->next) -
           d.row(this->vertex);
  }

  /// target - l(d); d without rows stands for 0.
  Vector3 Missing(const Points& d) const;
};

/// Feature lines and sliding boundaries: the sum of their squared rows.
struct PolylineTerm
{
  std::vector<PolylineRow> rows; ///< for vertices whose row of L is empty
  AdjacencyLists rowsAt; ///< of each vertex: 3 k if it is previous in row k, 3 k + 1 if it is
                         ///< vertex, 3 k + 2 if it is next

  PolylineTerm() = default;
  PolylineTerm(std::vector<PolylineRow> polylineRows, Index vertices);

  bool IsCoupled() const { return false; }

  double Energy(const Points& d) const;

  auto ResidualRows(const Points& d) const
  {
    return [this, forces = this->Forces(d)](Index i, Vector3& sum)
    {
      Vector3 force = Vector3::Zero();
      this->ForEachRowAt(
        i, [&](Index row, double coefficient) { force += coefficient * forces.row(row); });
      sum += force;
    };
  }

  void AddDiagonal(Index i, DiagonalBlock& block) const
  {
    this->ForEachRowAt(i,
      [&](Index row, double coefficient)
      {
        const double weight = this->rows[row].weight;
        block.isotropic += coefficient * coefficient * weight * weight;
      });
  }

  void AddEntries(MatrixEntries& entries) const;

  /// Calls visit(row, coefficient) for the rows in which vertex i takes part: its derivative is
  /// weight times coefficient.
  template <typename Visit>
  void ForEachRowAt(Index i, const Visit& visit) const
  {
    if (!this->rows.empty())
    {
      std::for_each(this->rowsAt.Begin(i), this->rowsAt.End(i),
        [&](Index place) { visit(place / 3, this->rows[place / 3].Coefficient(place % 3)); });
    }
  }

  /// weight^2 (target - l(d)) of each row; d without rows stands for 0.
  Points Forces(const Points& d) const;

  template <typename Scalar>
  class Product
  {
  public:
    static constexpr bool IsForCoupled = false;

    /// Keeps a reference to \a term.
    explicit Product(const PolylineTerm& term)
      : Term(term)
      , Forces(4, term.rows.size())
    {
    }

    /// Computes weight^2 l(x) of each row.
    void Prepare(const PackedPoints<Scalar>& x);

    template <typename Body>
    void WithRows(const Body& body) const
    {
      if (this->Term.rows.empty()) // loops without polylines do not test for them
      {
        body([](Index, const PackedRow<Scalar>&, PackedRow<Scalar>&) {});
        return;
      }
      body(
        [term = &this->Term, forces = View(this->Forces)](
          Index i, const PackedRow<Scalar>&, PackedRow<Scalar>& sum)
        {
          term->ForEachRowAt(i,
            [&](Index row, double coefficient) { sum += Scalar(coefficient) * forces.col(row); });
        });
    }

  private:
    const PolylineTerm& Term;
    PackedPoints<Scalar> Forces;
  };
};
}

#endif
