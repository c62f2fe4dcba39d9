// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_SchurElimination_h
#define lmo_SchurElimination_h

#include "Core/Multigrid/PaddedCsrMatrix.h"
#include "Core/Multigrid/ShiftedStiffness.h"

namespace lmo
{
/// Exact elimination of those unknowns of K + R at which an approximate inverse B has to be exact:
/// (K + R) Q (K + R) by way of B multiplies the error of B (K + R) in column i and row j by
/// sqrt(Q_i / Q_j). Where L is scaled by areas that differ by orders of magnitude (L_ck on thin
/// triangles), that would be much. No two of the unknowns are connected, so that the others have a
/// Schur complement S that is nearly as sparse as K + R, and
///   (K + R)^-1 = P S^-1 P^T + D^-1,
/// where P interpolates the unknowns eliminated from the others and D is their diagonal.
class SchurElimination
{
public:
  /// Chooses the unknowns; none if they would be few.
  explicit SchurElimination(const ShiftedStiffness& matrix);

  /// No unknown is eliminated; there is nothing to restrict or to prolong.
  bool IsEmpty() const { return this->NumberOfOthers == 0; }

  /// S
  SparseRows SchurComplement(const ShiftedStiffness& matrix) const;

  /// restricted = P^T rightHandSide
  void Restrict(const PackedPoints<float>& rightHandSide, PackedPoints<float>& restricted) const;

  /// solution = P others + D^-1 rightHandSide
  void Prolong(const PackedPoints<float>& others, const PackedPoints<float>& rightHandSide,
    PackedPoints<float>& solution) const;

private:
  bool IsEliminated(Index i) const { return this->InverseDiagonal[i] > 0; }

  Eigen::ArrayXf InverseDiagonal; ///< 0 for the others
  std::vector<Index> PlaceOf;     ///< of the others
  Index NumberOfOthers = 0;
  PaddedCsrMatrix Prolongation; ///< P
  PaddedCsrMatrix Restriction;  ///< its transpose
};
}

#endif
