// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_Multigrid_h
#define lmo_Multigrid_h

#include "PackedEquations.h"
#include "SparseProduct.h"

#include <Eigen/SparseCholesky>

#include <memory>

namespace lmo
{
/// Approximate inverse of a symmetric, diagonally dominant sparse matrix with positive diagonal:
/// one V-cycle of smoothed aggregation (Vanek, Mandel, Brezina 1996), which is symmetric itself.
class Multigrid
{
public:
  explicit Multigrid(SparseRows matrix);

  /// solution = approximately matrix^-1 rightHandSide
  void Cycle(const PackedPoints<float>& rightHandSide, PackedPoints<float>& solution);

  std::size_t GetNumberOfLevels() const { return this->Levels.size(); }

private:
  using Values = Eigen::Array<float, Eigen::Dynamic, 1>;

  struct Level
  {
    SparseRows A;
    SparseRows prolongation; ///< from the next, coarser level; empty on the coarsest
    SparseRows restriction;  ///< its transpose
    Values inverseDiagonal;
    float largestEigenvalue; ///< bound for the scaled matrix
    PackedPoints<float> residual;
    PackedPoints<float> step;
    PackedPoints<float> nextStep;
    PackedPoints<float> coarseRightHandSide;
    PackedPoints<float> coarseSolution;
  };

  /// Chebyshev iteration on the upper part of the spectrum; level.residual is that of \a solution
  /// before and after.
  static void Smooth(Level& level, PackedPoints<float>& solution);

  void CycleFrom(
    std::size_t level, const PackedPoints<float>& rightHandSide, PackedPoints<float>& solution);
  void SolveCoarsest(const PackedPoints<float>& rightHandSide, PackedPoints<float>& solution) const;

  std::vector<Level> Levels;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> Coarsest;
};
}

#endif
