// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_SchurElimination_h
#define lmo_SchurElimination_h

#include "Core/Multigrid/PaddedCsrMatrix.h"

#include <memory>
#include <utility>
#include <vector>

namespace lmo
{
/// Exact elimination of some unknowns of a symmetric matrix A, of which no two are connected, so
/// that the others have a Schur complement S that is nearly as sparse as A, and
///   A^-1 = P S^-1 P^T + D^-1,
/// where P interpolates the unknowns eliminated from the others and D is their diagonal. A matrix
/// has Size() and ForEachEntry() as ChebyshevSmoother describes them.
class SchurElimination
{
public:
  /// \param unknowns to eliminate
  template <typename Matrix>
  SchurElimination(const Matrix& A, const std::vector<Index>& unknowns);

  /// S
  template <typename Matrix>
  SparseRows SchurComplement(const Matrix& A) const;

  /// restricted = P^T rightHandSide
  void Restrict(const PackedPoints<float>& rightHandSide, PackedPoints<float>& restricted) const
  {
    Assign(this->Restriction, rightHandSide, restricted);
  }

  /// solution = P others + D^-1 rightHandSide
  void Prolong(const PackedPoints<float>& others, const PackedPoints<float>& rightHandSide,
    PackedPoints<float>& solution) const;

private:
  bool IsEliminated(Index i) const { return this->InverseDiagonal[i] > 0; }

  Eigen::ArrayXf InverseDiagonal; ///< 0 for the others
  std::vector<Index> IndexOf;     ///< of the others in S
  Index NumberOfOthers = 0;
  PaddedCsrMatrix Prolongation; ///< P
  PaddedCsrMatrix Restriction;  ///< its transpose
};

/// Makes an inverse of A from one of S. Approximate inverses have Apply() and ApplyTransposed().
template <typename Inverse>
class SchurInverse
{
public:
  /// \param inverse of the Schur complement S, which has \a size rows
  SchurInverse(SchurElimination elimination, std::unique_ptr<Inverse> inverse, Index size)
    : Elimination(std::move(elimination))
    , Others(std::move(inverse))
    , RightHandSide(4, size)
    , Solution(4, size)
  {
  }

  /// solution = B rightHandSide, B the approximate inverse
  void Apply(const PackedPoints<float>& rightHandSide, PackedPoints<float>& solution)
  {
    this->Elimination.Restrict(rightHandSide, this->RightHandSide);
    this->Others->Apply(this->RightHandSide, this->Solution);
    this->Elimination.Prolong(this->Solution, rightHandSide, solution);
  }

  /// solution = B^T rightHandSide
  void ApplyTransposed(const PackedPoints<float>& rightHandSide, PackedPoints<float>& solution)
  {
    this->Elimination.Restrict(rightHandSide, this->RightHandSide);
    this->Others->ApplyTransposed(this->RightHandSide, this->Solution);
    this->Elimination.Prolong(this->Solution, rightHandSide, solution);
  }

  const Inverse& GetInverse() const { return *this->Others; }

private:
  SchurElimination Elimination;
  std::unique_ptr<Inverse> Others;
  PackedPoints<float> RightHandSide; ///< of the unknowns that are not eliminated
  PackedPoints<float> Solution;
};
}

#include "Core/Multigrid/SchurElimination.txx"

#endif
