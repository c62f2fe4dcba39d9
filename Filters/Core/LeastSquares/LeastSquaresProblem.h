// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_LeastSquaresProblem_h
#define lmo_LeastSquaresProblem_h

#include "Core/LeastSquares/LaplacianTerm.h"
#include "Core/LeastSquares/NormalAlignmentTerm.h"
#include "Core/LeastSquares/PolylineTerm.h"
#include "Core/LeastSquares/PositionTerm.h"
#include "Core/LeastSquares/TangentPlaneTerm.h"
#include "Core/Mesh/DisplacementConstraints.h"

#include <tuple>

namespace lmo
{
/// Eqn. 11 with the tangent planes of Eqn. 15 and more: minimise the sum of the terms over the
/// displacements d = V' - V that the constraints allow. All forms of the problem loop over Terms().
struct LeastSquaresProblem
{
  PositionTerm position;
  TangentPlaneTerm tangentPlanes;
  LaplacianTerm laplacian;
  PolylineTerm polylines;
  NormalAlignmentTerm normalAlignment;
  DisplacementConstraints constraints;

  /// The terms, in the order in which they are summed.
  auto Terms() const
  {
    return std::tie(
      this->position, this->tangentPlanes, this->laplacian, this->polylines, this->normalAlignment);
  }

  Index Size() const { return this->position.Size(); }

  /// True if a term mixes x, y and z.
  bool HasCoupledTerms() const
  {
    return std::apply(
      [](const auto&... terms) { return (terms.IsCoupled() || ...); }, this->Terms());
  }

  /// True if x, y and z are not three independent systems with one matrix.
  bool IsCoupled() const { return this->HasCoupledTerms() || this->constraints.axes.rows() > 0; }
};

/// The value that a solution minimises, from its definition.
/// \param d no rows stand for 0
double Energy(const LeastSquaresProblem& problem, const Points& d);

/// Block i of the diagonal of A, without the constraints; isotropic is 1 if no term sets it.
DiagonalBlock DiagonalAt(const LeastSquaresProblem& problem, Index i);

/// b - A d, the residual of the normal equations within the displacements allowed: -1/2 of the
/// gradient of the energy. The matrix A is applied, never formed; b is the residual of d = 0.
/// \param d no rows stand for 0
/// \param store called once for each vertex, on several threads, as store(i, residual of i)
/// \return its norm, the same for any number of threads
template <typename Store>
double ComputeResidual(const LeastSquaresProblem& problem, const Points& d, const Store& store);

/// What ComputeResidual() computes, one row per vertex.
Points Residual(const LeastSquaresProblem& problem, const Points& d);
}

#include "Core/LeastSquares/LeastSquaresProblem.txx"

#endif
