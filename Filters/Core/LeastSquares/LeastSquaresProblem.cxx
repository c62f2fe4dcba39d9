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
      const Vector3 laplacian =
        -problem.laplacian.L.rowScale[i] * StiffnessRow(problem.laplacian.L, x, i);
      sum += (problem.laplacian.weights[i] * (laplacian - problem.laplacian.target->row(i)))
               .squaredNorm() +
             (problem.position.weights[i] * x.row(i)).squaredNorm();
      if (problem.tangentPlanes.normals.rows() > 0)
      {
        const double height = problem.tangentPlanes.normals.row(i).dot(x.row(i));
        sum += std::pow(problem.tangentPlanes.weight * height, 2);
      }
    });
  for (const PolylineRow& row : problem.polylines.rows)
  {
    const Vector3 value = 0.5 * (x.row(row.previous) + x.row(row.next)) - x.row(row.vertex);
    energy += (row.weight * (value - row.target)).squaredNorm();
  }
  return energy;
}

Vector Diagonal(const LeastSquaresProblem& problem)
{
  const Laplacian& L = problem.laplacian.L;
  const AdjacencyLists& rings = *L.rings;
  Vector diagonal(problem.Size());
  ParallelFor(problem.Size(),
    [&](Index i)
    {
      const double sum = WeightSum(L, i);
      double value = problem.position.weights[i] * problem.position.weights[i] +
                     sum * sum * problem.laplacian.RowWeight(i);
      for (Index k = rings.offsets[i]; k < rings.offsets[i + 1]; ++k)
      {
        const double weight = L.edgeWeights ? (*L.edgeWeights)[k] : 1;
        value += weight * weight * problem.laplacian.RowWeight(rings.ids[k]);
      }
      diagonal[i] = value;
    });
  for (const PolylineRow& row : problem.polylines.rows)
  {
    diagonal[row.previous] += 0.25 * row.weight * row.weight;
    diagonal[row.next] += 0.25 * row.weight * row.weight;
    diagonal[row.vertex] += row.weight * row.weight;
  }
  return (diagonal.array() > 0).select(diagonal, 1.0);
}

Points WeightedRows(const LeastSquaresProblem& problem, const Points& d)
{
  const Laplacian& L = problem.laplacian.L;
  Points y(problem.Size(), 3);
  ParallelFor(problem.Size(),
    [&](Index i)
    {
      const double weight = problem.laplacian.weights[i];
      y.row(i) = L.rowScale[i] * weight * weight * problem.laplacian.target->row(i);
      if (d.rows() > 0)
      {
        y.row(i) += problem.laplacian.RowWeight(i) * StiffnessRow(L, d, i);
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
  const double weight = problem.position.weights[i];
  Vector3 force = -weight * weight * d.row(i);
  if (problem.tangentPlanes.normals.rows() > 0)
  {
    const Vector3 normal = problem.tangentPlanes.normals.row(i);
    const double w = problem.tangentPlanes.weight;
    force -= w * w * normal.dot(d.row(i)) * normal;
  }
  return force;
}

Points LineForces(const LeastSquaresProblem& problem, const Points& d)
{
  Points forces = Points::Zero(problem.polylines.rows.empty() ? 0 : problem.Size(), 3);
  for (const PolylineRow& row : problem.polylines.rows)
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
