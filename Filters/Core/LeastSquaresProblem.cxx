// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LeastSquaresProblem.h"

#include "Parallel.h"

#include <cmath>

namespace lmo
{
namespace
{
/// Adds weight^2 times the transpose of a line row times its residual.
void AddLineRow(const LineRow& row, const Points& d, Points& residual)
{
  const Vector3 rowValue = 0.5 * (d.row(row.previous) + d.row(row.next)) - d.row(row.vertex);
  const Vector3 force = row.weight * row.weight * (row.target - rowValue);
  residual.row(row.previous) += 0.5 * force;
  residual.row(row.next) += 0.5 * force;
  residual.row(row.vertex) -= force;
}

Vector3 PositionForce(const LeastSquaresProblem& problem, const Points& d, Index i)
{
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

Points Residual(const LeastSquaresProblem& problem, const Points& d)
{
  // L^T W_L^2 (c - L d) with L = -G K is -K y, y = G W_L^2 c + Q K d.
  const Laplacian& L = problem.L;
  Points y(problem.Size(), 3);
  ParallelFor(problem.Size(),
    [&](Index i)
    {
      const double weight = problem.laplacianWeights[i];
      y.row(i) = L.rowScale[i] * weight * weight * problem.target.row(i) +
                 RowWeight(problem, i) * StiffnessRow(L, d, i);
    });
  Points residual(problem.Size(), 3);
  ParallelFor(problem.Size(),
    [&](Index i) { residual.row(i) = PositionForce(problem, d, i) - StiffnessRow(L, y, i); });
  for (const LineRow& row : problem.lineRows)
  {
    AddLineRow(row, d, residual);
  }
  ParallelFor(
    problem.Size(), [&](Index i) { residual.row(i) = problem.motion.Project(i, residual.row(i)); });
  return residual;
}

double Norm(const Points& x)
{
  return std::sqrt(ParallelSum(static_cast<Index>(x.rows()), 0.0,
    [&](double& sum, Index i) { sum += x.row(i).squaredNorm(); }));
}
}
