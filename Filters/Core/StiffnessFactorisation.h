// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_StiffnessFactorisation_h
#define lmo_StiffnessFactorisation_h

#include "ShiftedStiffness.h"

namespace lmo
{
/// Inverse of K + R by a sparse factorisation P (K + R) P^T = U^T D U, U unit upper triangular,
/// computed in double and applied in single precision.
class StiffnessFactorisation
{
public:
  /// \throw SolverError if the matrix is singular.
  explicit StiffnessFactorisation(const ShiftedStiffness& matrix);

  /// solution = (K + R)^-1 rightHandSide
  void Apply(const PackedPoints<float>& rightHandSide, PackedPoints<float>& solution);

private:
  using Values = Eigen::ArrayXf;

  std::vector<Index> PlaceOf; ///< of each vertex in the order of the factorisation
  std::vector<Index> Offsets; ///< of the rows of U without the diagonal
  std::vector<Index> Columns;
  std::vector<float> Entries;
  Values InverseD;
  PackedPoints<float> Work;
};
}

#endif
