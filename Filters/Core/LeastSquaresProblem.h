// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_LeastSquaresProblem_h
#define lmo_LeastSquaresProblem_h

#include "Laplacian.h"

namespace lmo
{
/// |W_L (L V' - f)|^2, the upper half of Eqn. 11.
struct LaplacianTerm
{
  Laplacian L;
  Vector weights; ///< diagonal of W_L
  Points target;  ///< f, the prescribed Laplacians
};

/// What the vertices may do. A direction of motion that is taken away is eliminated from the
/// unknowns, not penalised.
struct MotionConstraints
{
  enum Freedom : unsigned char
  {
    FIXED = 0,
    ALONG_LINE = 1,
    FREE = 3
  };
  Mask freedom;    ///< Freedom of each vertex
  Points tangents; ///< unit direction of the vertices ALONG_LINE; no rows if there are none

  /// Removes the forbidden part of a displacement or force at vertex i.
  Vector3 Project(Index i, const Vector3& x) const
  {
    switch (this->freedom[i])
    {
      case FREE:
        return x;
      case ALONG_LINE:
        return x.dot(this->tangents.row(i)) * this->tangents.row(i);
      default:
        return Vector3::Zero();
    }
  }
};

/// Eqn. 11 with the tangent-plane rows of Eqn. 15: find V' that minimises
/// sum over the terms of |W_L (L V' - f)|^2 + |W_p (V' - V)|^2 + w^2 sum_i |n_i (v'_i - v_i)|^2.
struct LeastSquaresProblem
{
  Points V;
  std::vector<LaplacianTerm> terms; ///< a row is empty in all terms but one
  Vector positionWeights;           ///< diagonal of W_p
  Points tangentPlaneNormals;       ///< n_i; no rows if there are no tangent-plane constraints
  double tangentPlaneWeight = 0;    ///< w
  MotionConstraints motion;
};

/// The normal equations A d = b of a problem for the displacement d = V' - V. With K = E - S and
/// Q = (G W_L)^2 they are A = sum K Q K + W_p^2 + w^2 n n^T and b = sum L^T W_L^2 (f - L V),
/// restricted to the motion allowed. The matrix A is applied, never formed.
class NormalEquations
{
public:
  /// Keeps a reference to \a problem.
  explicit NormalEquations(const LeastSquaresProblem& problem);

  Index Size() const { return static_cast<Index>(this->Problem.V.rows()); }
  const LeastSquaresProblem& GetProblem() const { return this->Problem; }

  /// True if x, y and z are not three independent systems with one matrix.
  bool IsCoupled() const;

  Points RightHandSide() const;

  /// result = A x, for x within the motion allowed.
  void Apply(const Points& x, Points& result) const;

  /// Diagonal of sum K Q K + W_p^2, one value for x, y and z; 1 where no row of the problem touches
  /// the vertex.
  Vector Diagonal() const;

  /// Q = (G W_L)^2 of one term.
  const Vector& RowWeights(std::size_t term) const { return this->Q[term]; }

  /// w^2 n n^T x of Eqn. 15 for one vertex; 0 without tangent-plane constraints.
  Vector3 ApplyTangentPlane(Index i, const Vector3& x) const;

private:
  const LeastSquaresProblem& Problem;
  std::vector<Vector> Q;
  mutable Points RowResiduals;
};

/// sqrt of the sum of squares, the same for any number of threads.
double Norm(const Points& x);
}

#endif
