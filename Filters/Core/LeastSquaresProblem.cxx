// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LeastSquaresProblem.h"

#include "Parallel.h"

#include <cmath>

namespace lmo
{
NormalEquations::NormalEquations(const LeastSquaresProblem& problem)
  : Problem(problem)
  , RowResiduals(problem.V.rows(), 3)
{
  for (const LaplacianTerm& term : problem.terms)
  {
    this->Q.emplace_back((term.L.rowScale.array() * term.weights.array()).square());
  }
}

bool NormalEquations::IsCoupled() const
{
  return this->Problem.tangentPlaneNormals.rows() > 0 || this->Problem.motion.tangents.rows() > 0;
}

Points NormalEquations::RightHandSide() const
{
  Points b = Points::Zero(this->Size(), 3);
  for (const LaplacianTerm& term : this->Problem.terms)
  {
    // L^T y = -K G y
    Points y = term.target - lmo::Apply(term.L, this->Problem.V);
    ParallelFor(this->Size(),
      [&](Index i) { y.row(i) *= term.L.rowScale[i] * term.weights[i] * term.weights[i]; });
    ParallelFor(this->Size(), [&](Index i) { b.row(i) -= StiffnessRow(term.L, y, i); });
  }
  ParallelFor(this->Size(), [&](Index i) { b.row(i) = this->Problem.motion.Project(i, b.row(i)); });
  return b;
}

void NormalEquations::Apply(const Points& x, Points& result) const
{
  const Vector& Wp = this->Problem.positionWeights;
  ParallelFor(this->Size(), [&](Index i)
    { result.row(i) = Wp[i] * Wp[i] * x.row(i) + this->ApplyTangentPlane(i, x.row(i)); });
  for (std::size_t term = 0; term < this->Q.size(); ++term)
  {
    const Laplacian& L = this->Problem.terms[term].L;
    ParallelFor(this->Size(),
      [&](Index i) { this->RowResiduals.row(i) = this->Q[term][i] * StiffnessRow(L, x, i); });
    ParallelFor(
      this->Size(), [&](Index i) { result.row(i) += StiffnessRow(L, this->RowResiduals, i); });
  }
  ParallelFor(
    this->Size(), [&](Index i) { result.row(i) = this->Problem.motion.Project(i, result.row(i)); });
}

Vector NormalEquations::Diagonal() const
{
  Vector diagonal = this->Problem.positionWeights.array().square();
  for (std::size_t term = 0; term < this->Q.size(); ++term)
  {
    const Laplacian& L = this->Problem.terms[term].L;
    const AdjacencyLists& rings = *L.rings;
    ParallelFor(this->Size(),
      [&](Index i)
      {
        const double sum = WeightSum(L, i);
        diagonal[i] += sum * sum * this->Q[term][i];
        for (Index k = rings.offsets[i]; k < rings.offsets[i + 1]; ++k)
        {
          const double weight = L.edgeWeights ? (*L.edgeWeights)[k] : 1;
          diagonal[i] += weight * weight * this->Q[term][rings.ids[k]];
        }
      });
  }
  return (diagonal.array() > 0).select(diagonal, 1.0);
}

Vector3 NormalEquations::ApplyTangentPlane(Index i, const Vector3& x) const
{
  if (this->Problem.tangentPlaneNormals.rows() == 0)
  {
    return Vector3::Zero();
  }
  const Vector3 normal = this->Problem.tangentPlaneNormals.row(i);
  const double weight = this->Problem.tangentPlaneWeight;
  return weight * weight * normal.dot(x) * normal;
}

double Norm(const Points& x)
{
  return std::sqrt(ParallelSum(static_cast<Index>(x.rows()), 0.0,
    [&](double& sum, Index i) { sum += x.row(i).squaredNorm(); }));
}
}
