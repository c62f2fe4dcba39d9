// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_NormalOperator_h
#define lmo_NormalOperator_h

#include "Core/LeastSquares/LeastSquaresProblem.h"
#include "Core/LeastSquares/PackedProjections.h"

#include <utility>

namespace lmo
{
/// Inner products of the columns x, y and z; the fourth is 0.
using Dots = Eigen::Array4d;

/// Sums inner products.
struct DotSum
{
  Eigen::Array2d xy = Eigen::Array2d::Zero();
  double z = 0;

  template <typename Scalar>
  void Add(const PackedRow<Scalar>& products)
  {
    this->xy += products.template head<2>().template cast<double>();
    this->z += double(products[2]);
  }

  void operator+=(const DotSum& other)
  {
    this->xy += other.xy;
    this->z += other.z;
  }

  Dots Get() const { return Dots(this->xy[0], this->xy[1], this->z, 0); }
};

/// The matrix A of a problem's normal equations, stored for speed. In single precision it serves to
/// find search directions: residuals that decide are computed by Residual().
template <typename Scalar>
class NormalOperator
{
public:
  /// Keeps a reference to \a problem.
  explicit NormalOperator(const LeastSquaresProblem& problem);

  Index Size() const { return this->Problem.Size(); }
  const LeastSquaresProblem& GetProblem() const { return this->Problem; }
  std::shared_ptr<const EllpackStiffness<Scalar>> GetStiffness() const
  {
    return std::get<LaplacianTerm::Product<Scalar>>(this->Products).GetStiffness();
  }

  /// product = A x, for x within the displacements allowed.
  /// \return the inner products of x and A x; three times their sum if the problem is coupled
  Dots Multiply(const PackedPoints<Scalar>& x, PackedPoints<Scalar>& product);

private:
  template <typename... Terms>
  static std::tuple<typename Terms::template Product<Scalar>...> ProductsOf(
    const std::tuple<const Terms&...>&);

  const LeastSquaresProblem& Problem;
  decltype(ProductsOf(std::declval<LeastSquaresProblem>().Terms())) Products;
  PackedProjections<Scalar> Projections;
};

extern template class NormalOperator<float>;
extern template class NormalOperator<double>;
}

#endif
