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

/// \param projections PackProjections()
template <typename Scalar, typename... Rows>
Dots MultiplyCoupled(const PackedPoints<Scalar>& projections, const Vector3& freeAxes,
  const PackedPoints<Scalar>& x, PackedPoints<Scalar>& product, const Rows&... rows)
{
  PackedRow<Scalar> free;
  free << freeAxes.transpose().array().template cast<Scalar>(), 0;
  const Dots dots = ParallelSum(static_cast<Index>(x.cols()), DotSum(),
    [rows..., free, projections = View(projections), x = View(x), product = View(product)](
      DotSum& sum, Index i) mutable
    {
      const PackedRow<Scalar> xi = x.col(i);
      const PackedRow<Scalar> whole = free * SumRows(i, xi, rows...);
      const PackedRow<Scalar> axis = projections.col(i);
      const Scalar kept = axis[3];
      const Scalar along = (axis * whole).sum(); // the fourth of whole is 0
      PackedRow<Scalar> row = kept * whole + (1 - 2 * kept) * along * axis;
      row[3] = 0;
      product.col(i) = row;
      sum.Add(PackedRow<Scalar>(row * xi));
    }).Get();
  return Dots(dots.sum(), dots.sum(), dots.sum(), 0);
}

/// Constraints::Project() for products: with (axis, kept) in each column, x becomes
/// kept x + (1 - 2 kept) (x . axis) axis, where kept is 1 for a free vertex, whose axis is 0, and
/// in a plane, 0 along a line and where the vertex is fixed.
template <typename Scalar>
PackedPoints<Scalar> PackProjections(const LeastSquaresProblem& problem)
{
  const DisplacementConstraints& constraints = problem.constraints;
  PackedPoints<Scalar> projections(4, problem.IsCoupled() ? problem.Size() : 0);
  ParallelFor(static_cast<Index>(projections.cols()),
    [&](Index i)
    {
      const auto freedom = constraints.freedom[i];
      const bool hasAxis = freedom == DisplacementConstraints::IN_PLANE ||
                           freedom == DisplacementConstraints::ALONG_LINE;
      projections.col(i) =
        Pack<Scalar>(hasAxis ? Vector3(constraints.axes.row(i)) : Vector3(Vector3::Zero()));
      projections(3, i) = Scalar(freedom >= DisplacementConstraints::IN_PLANE);
    });
  return projections;
}
}

template <typename Scalar>
NormalOperator<Scalar>::NormalOperator(const LeastSquaresProblem& problem)
  : Problem(problem)
  , Products(problem.Terms())
  , Projections(PackProjections<Scalar>(problem))
{
}

template <typename Scalar>
Dots NormalOperator<Scalar>::Multiply(const PackedPoints<Scalar>& x, PackedPoints<Scalar>& product)
{
  Dots dots;
  const DisplacementConstraints& constraints = this->Problem.constraints;
  const auto multiply = [&](auto&... products)
  {
    (products.Prepare(x), ...);
    if (this->Problem.IsCoupled())
    {
      WithRows<true>([&](const auto&... rows)
        { dots = MultiplyCoupled(this->Projections, constraints.freeAxes, x, product, rows...); },
        products...);
    }
    else
    {
      WithRows<false>([&](const auto&... rows)
        { dots = MultiplyUncoupled(constraints, x, product, rows...); },
        products...);
    }
  };
  std::apply(multiply, this->Products);
  return dots;
}

template class NormalOperator<float>;
template class NormalOperator<double>;
}
