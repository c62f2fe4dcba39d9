// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_Multigrid_h
#define lmo_Multigrid_h

#include "Monitor.h"
#include "ShiftedStiffness.h"
#include "SmoothedAggregation.h"

#include <Eigen/SparseCholesky>

namespace lmo
{
/// Approximate inverse of K + R: one V-cycle of smoothed aggregation (Vanek, Mandel, Brezina 1996),
/// which is symmetric itself.
class Multigrid
{
public:
  using Values = Eigen::ArrayXf;

  /// \throw Cancelled if the monitor says so; it is asked a few times for each level.
  Multigrid(std::shared_ptr<const ShiftedStiffness> matrix, Monitor& monitor);

  /// solution = approximately (K + R)^-1 rightHandSide
  /// \throw Cancelled if the monitor says so.
  void Apply(
    const PackedPoints<float>& rightHandSide, PackedPoints<float>& solution, Monitor& monitor);

  const ShiftedStiffness& GetMatrix() const { return *this->Matrix; }
  std::size_t GetNumberOfLevels() const { return this->Levels.size(); }

private:
  struct Level
  {
    SparseRows A;            ///< empty on the finest level, where it is K + R
    SparseRows prolongation; ///< from the next, coarser level; empty on the coarsest
    SparseRows restriction;  ///< its transpose
    Values smootherScale;    ///< 0 for unknowns that are 0
    PackedPoints<float> residual;
    PackedPoints<float> step;
    PackedPoints<float> nextStep;
    PackedPoints<float> coarseRightHandSide;
    PackedPoints<float> coarseSolution;
  };

  /// Adds a level but for its matrix.
  /// \return the matrix of the next, coarser level; empty if there is none
  template <typename Rows>
  SparseRows AddLevel(const Rows& matrix, Monitor& monitor);

  template <typename Rows>
  void FactoriseCoarsest(const Rows& matrix);

  void CycleFrom(
    std::size_t index, const PackedPoints<float>& rightHandSide, PackedPoints<float>& solution);
  void SolveCoarsest(const PackedPoints<float>& rightHandSide, PackedPoints<float>& solution) const;

  /// Calls body(rows), where rows(i) is row i of this level's matrix times x and cheap to copy.
  template <typename Body>
  void WithRows(std::size_t index, const PackedPoints<float>& x, const Body& body) const;

  /// Chebyshev iteration on the upper part of the spectrum.
  /// \pre The level's residual is that of \a solution.
  void Smooth(std::size_t index, PackedPoints<float>& solution);

  std::shared_ptr<const ShiftedStiffness> Matrix;
  std::vector<Level> Levels;
  Eigen::SimplicialLDLT<SparseMatrix> Coarsest;
};
}

#endif
