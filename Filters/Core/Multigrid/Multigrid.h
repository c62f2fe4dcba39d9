// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_Multigrid_h
#define lmo_Multigrid_h

#include "Core/Base/ProgressMonitor.h"
#include "Core/Multigrid/SchurElimination.h"
#include "Core/Multigrid/SmoothedAggregation.h"

#include <Eigen/SparseCholesky>

namespace lmo
{
/// Approximate inverse B of K + R: one V-cycle of smoothed aggregation (Vanek, Mandel, Brezina
/// 1996) that smooths on its way down only. Its transpose smooths on its way up only. B^T Q^-1 B is
/// symmetric, so that neither has to smooth twice. Unknowns at which B has to be exact are
/// eliminated before.
class Multigrid
{
public:
  using Values = Eigen::ArrayXf;

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
  std::size_t GetNumberOfLevels() const { return this->Levels.size(); }

private:
  struct Level
  {
    PaddedCsrMatrix A;            ///< not used where it is K + R
    PaddedCsrMatrix prolongation; ///< from the next, coarser level; empty on the coarsest
    PaddedCsrMatrix restriction;  ///< its transpose
    Values smootherScale;         ///< 0 for unknowns that are 0
    PackedPoints<float> previous; ///< iterate of the smoother
    PackedPoints<float> residual;
    PackedPoints<float> coarseRightHandSide;
    PackedPoints<float> coarseSolution;
  };

  /// A step of the smoother: x + momentum (x - previous x) + factor D (b - A x).
  struct SmootherStep
  {
    float momentum;
    float factor;
  };

  using Smoother = std::vector<SmootherStep>;
  using Cycle = void (Multigrid::*)(
    std::size_t level, const PackedPoints<float>& b, PackedPoints<float>& x);

  /// Chebyshev iteration on eigenvalues above the largest / share.
  static Smoother ChebyshevSmoother(int degree, float share);

  /// Adds a level but for its matrix.
  /// \return the matrix of the next, coarser level; empty if there is none
  template <typename Rows>
  SparseRows AddLevel(const Rows& matrix, ProgressMonitor& monitor);

  template <typename Rows>
  void FactoriseCoarsest(const Rows& matrix);

  /// Calls the cycle for the unknowns that are not eliminated, and finds the others from these.
  void WithoutEliminated(const PackedPoints<float>& rightHandSide, PackedPoints<float>& solution,
    ProgressMonitor& monitor, Cycle cycle);

  /// B and its transpose, from a level on.
  void CycleFrom(std::size_t level, const PackedPoints<float>& b, PackedPoints<float>& x);
  void TransposedCycleFrom(std::size_t level, const PackedPoints<float>& b, PackedPoints<float>& x);

  /// x = A^-1 b on the coarsest level, the smoother's approximation if A is nearly diagonal there.
  void SolveCoarsest(const PackedPoints<float>& b, PackedPoints<float>& x);

  const Smoother& GetSmoother(std::size_t level) const
  {
    return level == 0 ? this->FinestSmoother : this->CoarseSmoother;
  }

  /// Calls body(rows), where rows(i) is row i of this level's matrix times x and cheap to copy.
  template <typename Body>
  void WithRows(std::size_t index, const PackedPoints<float>& x, const Body& body) const;

  /// All steps from x = 0.
  void SmoothFromZero(std::size_t level, const PackedPoints<float>& b, PackedPoints<float>& x);

  /// \param first step to do
  void Smooth(
    std::size_t level, const PackedPoints<float>& b, PackedPoints<float>& x, std::size_t first);

  std::shared_ptr<const ShiftedStiffness> Matrix;
  SchurElimination Eliminated;
  PackedPoints<float> RestrictedRightHandSide; ///< of the unknowns that are not eliminated
  PackedPoints<float> RestrictedSolution;
  Smoother FinestSmoother;
  Smoother CoarseSmoother;
  std::vector<Level> Levels;
  Eigen::SimplicialLDLT<SparseMatrix> Coarsest; ///< empty where A is nearly diagonal
};
}

#endif
