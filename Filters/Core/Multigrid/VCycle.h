// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_VCycle_h
#define lmo_VCycle_h

#include "Core/Base/ProgressMonitor.h"
#include "Core/Multigrid/ChebyshevSmoother.h"
#include "Core/Multigrid/PaddedCsrMatrix.h"

#include <Eigen/SparseCholesky>

#include <memory>
#include <vector>

namespace lmo
{
/// Approximate inverse B of a symmetric positive definite matrix A: one V-cycle of smoothed
/// aggregation (Vanek, Mandel, Brezina 1996) that smooths on its way down only. Its transpose
/// smooths on its way up only: the product B^T Q B with a diagonal Q is symmetric, so that neither
/// has to smooth twice.
/// \tparam Matrix the finest level's, with the functions that ChebyshevSmoother describes. Coarser
/// levels have PaddedCsrMatrix.
template <typename Matrix>
class VCycle
{
public:
  /// \param finestDegree of the smoother on the finest level, > 0
  /// \throw Cancelled if the monitor says so; it is asked a few times for each level.
  VCycle(std::shared_ptr<const Matrix> matrix, int finestDegree, ProgressMonitor& monitor);

  /// solution = B rightHandSide
  void Apply(const PackedPoints<float>& rightHandSide, PackedPoints<float>& solution)
  {
    this->CycleFrom(0, rightHandSide, solution);
  }

  /// solution = B^T rightHandSide
  void ApplyTransposed(const PackedPoints<float>& rightHandSide, PackedPoints<float>& solution)
  {
    this->TransposedCycleFrom(0, rightHandSide, solution);
  }

  std::size_t GetNumberOfLevels() const { return this->Levels.size(); }

private:
  struct Level
  {
    PaddedCsrMatrix A; ///< empty on the finest level
    ChebyshevSmoother smoother;
    PaddedCsrMatrix prolongation; ///< from the next, coarser level; empty on the coarsest
    PaddedCsrMatrix restriction;  ///< its transpose
    PackedPoints<float> residual;
    PackedPoints<float> coarseRightHandSide;
    PackedPoints<float> coarseSolution;
  };

  /// Adds a level but for its matrix.
  /// \return the matrix of the next, coarser level; empty if there is none
  template <typename LevelMatrix>
  SparseRows AddLevel(const LevelMatrix& A, int smootherDegree, ProgressMonitor& monitor);

  template <typename LevelMatrix>
  void FactoriseCoarsest(const LevelMatrix& A);

  /// Calls body(A) with the matrix of a level.
  template <typename Body>
  void WithMatrix(std::size_t level, const Body& body) const
  {
    if (level == 0)
    {
      body(*this->Finest);
    }
    else
    {
      body(this->Levels[level].A);
    }
  }

  /// B and its transpose, from a level on.
  void CycleFrom(std::size_t level, const PackedPoints<float>& b, PackedPoints<float>& x);
  void TransposedCycleFrom(std::size_t level, const PackedPoints<float>& b, PackedPoints<float>& x);

  /// x = A^-1 b on the coarsest level, the smoother's approximation if A is nearly diagonal there.
  void SolveCoarsest(const PackedPoints<float>& b, PackedPoints<float>& x);

  std::shared_ptr<const Matrix> Finest;
  std::vector<Level> Levels;
  Eigen::SimplicialLDLT<SparseMatrix> Coarsest; ///< empty where A is nearly diagonal
};
}

#include "Core/Multigrid/VCycle.txx"

#endif
