// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_LeastSquaresProblem_h
#define lmo_LeastSquaresProblem_h

#include "Core/LeastSquares/LaplacianTerm.h"
#include "Core/LeastSquares/PolylineTerm.h"
#include "Core/LeastSquares/PositionTerm.h"
#include "Core/LeastSquares/TangentPlaneTerm.h"
#include "Core/Mesh/DisplacementConstraints.h"

namespace lmo
{
/// Eqn. 11 with the tangent-plane rows of Eqn. 15, for the displacement d = V' - V: minimise
/// |W_L (L d - c)|^2 + sum of the squared line rows + |W_p d|^2 + w^2 sum_i (n_i d_i)^2,
/// where c = f - L V.
struct LeastSquaresProblem
{
  LaplacianTerm laplacian;
  PositionTerm position;
  PolylineTerm polylines;
  TangentPlaneTerm tangentPlanes;
  DisplacementConstraints motion;

  Index Size() const { return static_cast<Index>(this->position.weights.size()); }

  /// True if x, y and z are not three independent systems with one matrix.
  bool IsCoupled() const
  {
    return this->tangentPlanes.normals.rows() > 0 || this->motion.axes.rows() > 0;
  }
};

/// The value that a solution minimises, from its definition.
/// \param d no rows stand for 0
double Energy(const LeastSquaresProblem& problem, const Points& d);

/// Diagonal of L^T W_L^2 L + W_p^2 and the line rows, one value for x, y and z; 1 where no row of
/// the problem touches the vertex.
Vector Diagonal(const LeastSquaresProblem& problem);

/// b - A d, the residual of the normal equations within the motion allowed. The matrix
/// A = K Q K + line rows + W_p^2 + w^2 n n^T is applied, never formed; b = L^T W_L^2 c is the
/// residual of d = 0.
/// \param d no rows stand for 0
/// \param store called once for each vertex, on several threads, as store(i, residual of i)
/// \return its norm, the same for any number of threads
template <typename Store>
double ComputeResidual(const LeastSquaresProblem& problem, const Points& d, const Store& store);

/// What ComputeResidual() computes, one row per vertex.
Points Residual(const LeastSquaresProblem& problem, const Points& d);

/// The rows y = G W_L^2 c + Q K d, with which L^T W_L^2 (c - L d) is -K y. As below, no rows of d
/// stand for 0.
Points WeightedRows(const LeastSquaresProblem& problem, const Points& d);

/// Part of the residual at vertex i that the other rows give: positions and tangent planes.
Vector3 PositionForce(const LeastSquaresProblem& problem, const Points& d, Index i);

/// Part of the residual that the line rows give; no rows if there are none.
Points LineForces(const LeastSquaresProblem& problem, const Points& d);
}

#include "Core/LeastSquares/LeastSquaresProblem.txx"

#endif
