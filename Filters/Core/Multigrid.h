// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_Multigrid_h
#define lmo_Multigrid_h

#include "PackedStiffness.h"
#include "SparseProduct.h"

#include <Eigen/SparseCholesky>

namespace lmo
{
/// Approximate inverse of K + R, K the stiffness matrix of a Laplacian and R a diagonal: one
/// V-cycle of smoothed aggregation (Vanek, Mandel, Brezina 1996), which is symmetric itself.
class Multigrid
{
public:
  using Values = Eigen::Array<float, Eigen::Dynamic, 1>;

  /// Keeps a reference to \a K.
  /// \param shift the diagonal of R, >= 0
  /// \param isFixed vertices whose values are 0
  Multigrid(const PackedStiffness<float>& K, const Laplacian& L, Values shift, const Mask& isFixed);

  /// solution = approximately (K + R)^-1 rightHandSide
  void Cycle(const PackedPoints<float>& rightHandSide, PackedPoints<float>& solution);

  std::size_t GetNumberOfLevels() const { return this->Levels.size(); }

private:
  struct Level
  {
    SparseRows A;                ///< empty on the finest level, where it is K + R
    SparseRows prolongation;     ///< from the next, coarser level; empty on the coarsest
    SparseRows restriction;      ///< its transpose
    Values inverseDiagonal;      ///< 0 for unknowns that are 0
    float largestEigenvalue = 0; ///< bound for the matrix scaled by the inverse diagonal
    PackedPoints<float> residual;
    PackedPoints<float> step;
    PackedPoints<float> nextStep;
    PackedPoints<float> coarseRightHandSide;
    PackedPoints<float> coarseSolution;
  };

  void BuildLevels(SparseRows matrix);
  void CycleFrom(
    std::size_t index, const PackedPoints<float>& rightHandSide, PackedPoints<float>& solution);
  void SolveCoarsest(const PackedPoints<float>& rightHandSide, PackedPoints<float>& solution) const;

  /// The cycle with the function that multiplies a row of this level's matrix with a vector.
  template <typename MultiplyRow>
  void CycleWith(std::size_t index, const MultiplyRow& multiplyRow,
    const PackedPoints<float>& rightHandSide, PackedPoints<float>& solution);

  /// Chebyshev iteration on the upper part of the spectrum.
  /// \pre level.residual is that of \a solution.
  template <typename MultiplyRow>
  static void Smooth(Level& level, const MultiplyRow& multiplyRow, PackedPoints<float>& solution);

  const PackedStiffness<float>& K;
  Values Shift;
  std::vector<Level> Levels;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> Coarsest;
};
}

#endif
