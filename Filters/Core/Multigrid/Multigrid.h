// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_Multigrid_h
#define lmo_Multigrid_h

#include "Core/Multigrid/SchurElimination.h"
#include "Core/Multigrid/ShiftedStiffness.h"
#include "Core/Multigrid/VCycle.h"

namespace lmo
{
/// Approximate inverse B of K + R: a V-cycle, without products of a stored matrix on the finest
/// level. Where (K + R) Q (K + R) would amplify its error, unknowns are eliminated before, and the
/// V-cycle is that of their Schur complement.
class Multigrid
{
public:
  /// \throw Cancelled if the monitor says so; it is asked a few times for each level.
  Multigrid(std::shared_ptr<const ShiftedStiffness> matrix, ProgressMonitor& monitor);

  /// solution = B rightHandSide, approximately (K + R)^-1 rightHandSide
  /// \throw Cancelled if the monitor says so.
  void Apply(const PackedPoints<float>& rightHandSide, PackedPoints<float>& solution,
    ProgressMonitor& monitor);

  /// solution = B^T rightHandSide
  /// \throw Cancelled if the monitor says so.
  void ApplyTransposed(const PackedPoints<float>& rightHandSide, PackedPoints<float>& solution,
    ProgressMonitor& monitor);

  const ShiftedStiffness& GetMatrix() const { return *this->Matrix; }
  std::size_t GetNumberOfLevels() const;

private:
  std::shared_ptr<const ShiftedStiffness> Matrix;
  std::unique_ptr<VCycle<ShiftedStiffness>> Whole; ///< null if unknowns are eliminated
  std::unique_ptr<SchurInverse<VCycle<PaddedCsrMatrix>>> Eliminated;
};
}

#endif
