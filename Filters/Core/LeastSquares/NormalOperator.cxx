// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/LeastSquares/NormalOperator.h"

#include "Core/Base/Threading.h"

namespace lmo
{
template <typename Scalar>
NormalOperator<Scalar>::NormalOperator(const LeastSquaresProblem& problem)
  : Problem(problem)
  , K(std::make_shared<const EllpackStiffness<Scalar>>(problem.laplacian.L))
  , Q(problem.Size())
  , SquaredPositionWeights(problem.Size())
  , RowValues(4, problem.Size())
{
  ParallelFor(problem.Size(),
    [&](Index i)
    {
      const double weight = problem.position.weights[i];
      this->Q[i] = static_cast<Scalar>(problem.laplacian.RowWeight(i));
      this->SquaredPositionWeights[i] = static_cast<Scalar>(weight * weight);
    });
}

template <typename Scalar>
Dots NormalOperator<Scalar>::Multiply(const PackedPoints<Scalar>& x, PackedPoints<Scalar>& product)
{
  auto rowValues = View(this->RowValues);
  this->K->WithRows(x,
    [&](const auto& Kx)
    {
      const Scalar* Q = this->Q.data();
      ParallelFor(this->Size(), [=](Index i) mutable { rowValues.col(i) = Q[i] * Kx(i); });
    });
  Dots dots;
  this->K->WithRows(this->RowValues,
    [&](const auto& KQKx)
    {
      const Scalar* squaredWeights = this->SquaredPositionWeights.data();
      const unsigned char* freedom = this->Problem.motion.freedom.data();
      dots = ParallelSum(this->Size(), DotSum(),
        [=, x = View(x), product = View(product)](DotSum& sum, Index i) mutable
        {
          const PackedRow<Scalar> xi = x.col(i);
          PackedRow<Scalar> row = KQKx(i) + squaredWeights[i] * xi;
          if (freedom[i] == DisplacementConstraints::FIXED)
          {
            row.setZero();
          }
          product.col(i) = row;
          sum.Add(PackedRow<Scalar>(row * xi));
        }).Get();
    });
  return this->Problem.IsCoupled() ? this->FinishCoupled(x, product) : dots;
}

template <typename Scalar>
Dots NormalOperator<Scalar>::FinishCoupled(
  const PackedPoints<Scalar>& x, PackedPoints<Scalar>& product)
{
  for (const PolylineRow& row : this->Problem.polylines.rows)
  {
    const PackedRow<Scalar> force =
      Scalar(row.weight * row.weight) *
      (Scalar(0.5) * (x.col(row.previous) + x.col(row.next)) - x.col(row.vertex));
    product.col(row.previous) += Scalar(0.5) * force;
    product.col(row.next) += Scalar(0.5) * force;
    product.col(row.vertex) -= force;
  }
  const bool hasPlanes = this->Problem.tangentPlanes.normals.rows() > 0;
  const double squaredWeight =
    this->Problem.tangentPlanes.weight * this->Problem.tangentPlanes.weight;
  const double dot = ParallelSum(this->Size(), 0.0,
    [&](double& sum, Index i)
    {
      const Vector3 xi = x.col(i).template head<3>().template cast<double>();
      Vector3 row = product.col(i).template head<3>().template cast<double>();
      if (hasPlanes)
      {
        const Vector3 normal = this->Problem.tangentPlanes.normals.row(i);
        row += squaredWeight * normal.dot(xi) * normal;
      }
      row = this->Problem.motion.Project(i, row);
      product.col(i).template head<3>() = row.transpose().array().template cast<Scalar>();
      sum += row.dot(xi);
    });
  return Dots(dot, dot, dot, 0);
}

template class NormalOperator<float>;
template class NormalOperator<double>;
}
