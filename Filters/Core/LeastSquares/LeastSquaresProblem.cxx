// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/LeastSquares/LeastSquaresProblem.h"

#include "Core/Base/Threading.h"

#include <cmath>

namespace lmo
{
double Energy(const LeastSquaresProblem& problem, const Points& d)
{
  const Points still = Points::Zero(d.rows() > 0 ? 0 : problem.Size(), 3);
  const Points& x = d.rows() > 0 ? d : still;
  double energy = ParallelSum(problem.Size(), 0.0,
    [&](double& sum, Index i)
    {
      const Vector3 laplacian = -problem.L.rowScale[i] * StiffnessRow(problem.L, x, i);
      sum += (problem.laplacianWeights[i] * (laplacian - problem.target->row(i))).squaredNorm() +
             (problem.positionWeights[i] * x.row(i)).squaredNorm();
      if (problem.tangentPlaneNormals.rows() > 0)
      {
        const double height = problem.tangentPlaneNormals.row(i).dot(x.row(i));
        sum += std::pow(problem.tangentPlaneWeight * height, 2);
      }
    });
  for (const LineRow& row : problem.lineRows)
  {
    const Vector3 value = 0.5 * (x.row(row.previous) + x.row(row.next)) - x.row(row.vertex);
    energy += (row.weight * (value - row.target)).squaredNorm();
  }
  return energy;
}

Vector Diagonal(const LeastSquaresProblem& problem)
{
  const Laplacian& L = problem.L;
  const AdjacencyLists& rings = *L.rings;
  Vector diagonal(problem.Size());
  ParallelFor(problem.Size(),
    [&](Index i)
    {
      const double sum = WeightSum(L, i);
      double value =
        problem.positionWeights[i] * problem.positionWeights[i] + sum * sum * RowWeight(problem, i);
      for (Index k = rings.offsets[i]; k < rings.offsets[i + 1]; ++k)
      {
        const double weight = L.edgeWeights ? (*L.edgeWeights)[k] : 1;
        value += weight * weight * RowWeight(problem, rings.ids[k]);
      }
      diagonal[i] = value;
    });
  for (const LineRow& row : problem.lineRows)
  {
    diagonal[row.previous] += 0.25 * row.weight * row.weight;
    diagonal[row.next] += 0.25 * row.weight * row.weight;
    diagonal[row.vertex] += row.weight * row.weight;
  }
  return (diagonal.array() > 0).select(diagonal, 1.0);
}

Points WeightedRows(const LeastSquaresProblem& problem, const Points& d)
{
  const Laplacian& L = problem.L;
  Points y(problem.Size(), 3);
  ParallelFor(problem.Size(),
    [&](Index i)
    {
      const double weight = problem.laplacianWeights[i];
      y.row(i) = L.rowScale[i] * weight * weight * problem.target->row(i);
      if (d.rows() > 0)
      {
        y.row(i) += RowWeight(problem, i) * StiffnessRow(L, d, i);
      }
    });
  return y;
}

Vector3 PositionForce(const LeastSquaresProblem& problem, const Points& d, Index i)
{
  if (d.rows() == 0)
  {
    return Vector3::Zero();
  }
  const double weight = problem.positionWeights[i];
  Vector3 force = -weight * weight * d.row(i);
  if (problem.tangentPlaneNormals.rows() > 0)
  {
    const Vector3 normal = problem.tangentPlaneNormals.row(i);
    const double w = problem.tangentPlaneWeight;
    force -= w * w * normal.dot(d.row(i)) * normal;
  }
  return force;
}

Points LineForces(const LeastSquaresProblem& problem, const Points& d)
{
  Points forces = Points::Zero(problem.lineRows.empty() ? 0 : problem.Size(), 3);
  for (const LineRow& row : problem.lineRows)
  {
    Vector3 rowValue = Vector3::Zero();
    if (d.rows() > 0)
    {
      rowValue = 0.5 * (d.row(row.previous) + d.row(row.next)) - d.row(row.vertex);
    }
    const Vector3 force = row.weight * row.weight * (row.target - rowValue);
    forces.row(row.previous) += 0.5 * force;
    forces.row(row.next) += 0.5 * force;
    forces.row(row.vertex) -= force;
  }
  return forces;
}

Points Residual(const LeastSquaresProblem& problem, const Points& d)
{
  Points residual(problem.Size(), 3);
  ComputeResidual(problem, d, [&](Index i, const Vector3& value) { residual.row(i) = value; });
  return residual;
}
}
