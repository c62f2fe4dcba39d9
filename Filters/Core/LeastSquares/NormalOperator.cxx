// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/LeastSquares/NormalOperator.h"

#include "Core/Base/Threading.h"

namespace lmo
{
namespace
{
/// Calls body(rows...) with the rows of the products, one for each term that a problem, coupled or
/// not, may have.
template <bool IsCoupled, typename Body>
void WithRows(const Body& body)
{
  body();
}

template <bool IsCoupled, typename Body, typename First, typename... Others>
void WithRows(const Body& body, const First& first, const Others&... others)
{
  if constexpr (First::IsForCoupled && !IsCoupled)
  {
    WithRows<IsCoupled>(body, others...);
  }
  else
  {
    first.WithRows([&](const auto& rows)
      { WithRows<IsCoupled>([&](const auto&... more) { body(rows, more...); }, others...); });
  }
}

/// Row i of A x without the constraints.
template <typename Scalar, typename... Rows>
PackedRow<Scalar> SumRows(Index i, const PackedRow<Scalar>& x, const Rows&... rows)
{
  PackedRow<Scalar> sum = PackedRow<Scalar>::Zero();
  (rows(i, x, sum), ...);
  return sum;
}

template <typename Scalar, typename... Rows>
Dots MultiplyUncoupled(const DisplacementConstraints& constraints, const PackedPoints<Scalar>& x,
  PackedPoints<Scalar>& product, const Rows&... rows)
{
  return ParallelSum(static_cast<Index>(x.cols()), DotSum(),
    [rows..., freedom = constraints.freedom.data(), x = View(x), product = View(product)](
      DotSum& sum, Index i) mutable
    {
      const PackedRow<Scalar> xi = x.col(i);
      PackedRow<Scalar> row = SumRows(i, xi, rows...);
      if (freedom[i] == DisplacementConstraints::FIXED)
      {
        row.setZero();
      }
      product.col(i) = row;
      sum.Add(PackedRow<Scalar>(row * xi));
    })
    .Get();
}

template <typename Scalar, typename Project, typename... Rows>
Dots MultiplyCoupled(const Project& project, const PackedPoints<Scalar>& x,
  PackedPoints<Scalar>& product, const Rows&... rows)
{
  const Dots dots = ParallelSum(static_cast<Index>(x.cols()), DotSum(),
    [rows..., project, x = View(x), product = View(product)](DotSum& sum, Index i) mutable
    {
      const PackedRow<Scalar> xi = x.col(i);
      const PackedRow<Scalar> row = project(i, SumRows(i, xi, rows...));
      product.col(i) = row;
      sum.Add(PackedRow<Scalar>(row * xi));
    }).Get();
  return Dots(dots.sum(), dots.sum(), dots.sum(), 0);
}
}

template <typename Scalar>
NormalOperator<Scalar>::NormalOperator(const LeastSquaresProblem& problem)
  : Problem(problem)
  , Products(problem.Terms())
  , Projections(problem)
{
}

template <typename Scalar>
Dots NormalOperator<Scalar>::Multiply(const PackedPoints<Scalar>& x, PackedPoints<Scalar>& product)
{
  Dots dots;
  const auto multiply = [&](auto&... products)
  {
    (products.Prepare(x), ...);
    if (this->Problem.IsCoupled())
    {
      WithRows<true>([&](const auto&... rows)
        { dots = MultiplyCoupled(this->Projections.GetRows(), x, product, rows...); },
        products...);
    }
    else
    {
      WithRows<false>([&](const auto&... rows)
        { dots = MultiplyUncoupled(this->Problem.constraints, x, product, rows...); },
        products...);
    }
  };
  std::apply(multiply, this->Products);
  return dots;
}

template class NormalOperator<float>;
template class NormalOperator<double>;
}
