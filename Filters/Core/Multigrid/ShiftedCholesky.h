// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_ShiftedCholesky_h
#define lmo_ShiftedCholesky_h

#include "Core/Base/ProgressMonitor.h"
#include "Core/Multigrid/ShiftedStiffness.h"

namespace lmo
{
/// Inverse of K + R by a sparse factorisation P (K + R) P^T = U^T D U, U unit upper triangular,
/// computed in double and applied in single precision.
class ShiftedCholesky
{
public:
  /// \param previous if it has the same pattern, its order of the unknowns is taken over; may be
  /// null
  /// \throw SolverError if the matrix is singular.
  ShiftedCholesky(std::shared_ptr<const ShiftedStiffness> matrix, const ShiftedCholesky* previous);

  /// solution = (K + R)^-1 rightHandSide
  /// \throw Cancelled if the monitor says so.
  void Apply(const PackedPoints<float>& rightHandSide, PackedPoints<float>& solution,
    ProgressMonitor& monitor);

  /// The same: the matrix is symmetric.
  /// \throw Cancelled if the monitor says so.
  void ApplyTransposed(const PackedPoints<float>& rightHandSide, PackedPoints<float>& solution,
    ProgressMonitor& monitor)
  {
    this->Apply(rightHandSide, solution, monitor);
  }

  const ShiftedStiffness& GetMatrix() const { return *this->Matrix; }

  /// Place of each vertex in the order of the unknowns; the same object if it was taken over.
  std::shared_ptr<const std::vector<Index>> GetOrder() const { return this->PlaceOf; }

private:
  using Values = Eigen::ArrayXf;

  std::shared_ptr<const ShiftedStiffness> Matrix;
  std::shared_ptr<const std::vector<Index>> PlaceOf;
  std::vector<Index> Offsets; ///< of the rows of U without the diagonal
  std::vector<Index> Columns;
  std::vector<float> Entries;
  Values InverseD;
  PackedPoints<float> Work;
};
}

#endif
