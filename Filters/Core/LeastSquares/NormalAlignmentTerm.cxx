// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/LeastSquares/NormalAlignmentTerm.h"

#include "Core/Base/Threading.h"

#include <array>
#include <utility>

namespace lmo
{
namespace
{
/// m (x_k - mean of x) of a triangle's corners with the rows a, b and c of x.
template <typename Scalar, typename Row>
std::array<Scalar, 3> HeightsOf(const Row& normal, const Row& a, const Row& b, const Row& c)
{
  const Row mean = (a + b + c) / Scalar(3);
  return { (normal.array() * (a - mean).array()).sum(), (normal.array() * (b - mean).array()).sum(),
    (normal.array() * (c - mean).array()).sum() };
}
}

NormalAlignmentTerm::NormalAlignmentTerm(
  const Points& V, const Triangles& meshTriangles, AdjacencyLists corners, Points filteredNormals)
  : triangles(meshTriangles)
  , cornersAt(std::move(corners))
  , normals(std::move(filteredNormals))
  , heights(CornerValues::Zero(meshTriangles.rows(), 3))
{
  for (Index t = 0; t < static_cast<Index>(this->triangles.rows()); ++t)
  {
    if (IsDegenerate(this->triangles, t))
    {
      this->normals.row(t).setZero(); // its corners are not in cornersAt
    }
  }
  this->heights = this->MovedHeights(V);
}

Vector3 NormalAlignmentTerm::MovedHeightsOf(Index t, const Points& d) const
{
  if (d.rows() == 0)
  {
    return this->heights.row(t);
  }
  const auto ids = this->triangles.row(t);
  const std::array<double, 3> change =
    HeightsOf<double, Vector3>(this->normals.row(t), d.row(ids[0]), d.row(ids[1]), d.row(ids[2]));
  return this->heights.row(t) + Eigen::Map<const Vector3>(change.data());
}

CornerValues NormalAlignmentTerm::MovedHeights(const Points& d) const
{
  CornerValues moved(this->heights.rows(), 3);
  ParallelFor(
    static_cast<Index>(moved.rows()), [&](Index t) { moved.row(t) = this->MovedHeightsOf(t, d); });
  return moved;
}

double NormalAlignmentTerm::Energy(const Points& d) const
{
  return ParallelSum(static_cast<Index>(this->heights.rows()), 0.0,
    [&](double& sum, Index t) { sum += this->MovedHeightsOf(t, d).squaredNorm(); });
}

void NormalAlignmentTerm::AddDiagonal(Index i, DiagonalBlock& block) const
{
  this->ForEachCornerAt(i,
    [&](Index corner)
    {
      const Vector3 normal = this->normals.row(corner / 3);
      block.coupled += 2.0 / 3 * normal.transpose() * normal;
    });
}

void NormalAlignmentTerm::AddEntries(MatrixEntries& entries) const
{
  for (Index t = 0; t < static_cast<Index>(this->triangles.rows()); ++t)
  {
    const Vector3 normal = this->normals.row(t);
    for (int a = 0; a < 3; ++a)
    {
      for (int b = 0; b < 3; ++b)
      {
        const double factor = a == b ? 2.0 / 3 : -1.0 / 3;
        entries.coupled.push_back(
          { this->triangles(t, a), this->triangles(t, b), factor * normal.transpose() * normal });
      }
    }
  }
}

template <typename Scalar>
NormalAlignmentTerm::Product<Scalar>::Product(const NormalAlignmentTerm& term)
  : Term(term)
  , Normals(4, term.triangles.rows())
  , Heights(3, term.triangles.rows())
{
  ParallelFor(static_cast<Index>(term.triangles.rows()),
    [&](Index t) { this->Normals.col(t) = Pack<Scalar>(term.normals.row(t)); });
}

template <typename Scalar>
void NormalAlignmentTerm::Product<Scalar>::Prepare(const PackedPoints<Scalar>& x)
{
  ParallelFor(static_cast<Index>(this->Normals.cols()),
    [x = View(x), normals = View(std::as_const(this->Normals)), heights = this->Heights.data(),
      triangles = this->Term.triangles.data()](Index t)
    {
      const Index* const ids = triangles + 3 * std::ptrdiff_t(t);
      Scalar* const height = heights + 3 * std::ptrdiff_t(t);
      const std::array<Scalar, 3> values = HeightsOf<Scalar, PackedRow<Scalar>>(
        normals.col(t), x.col(ids[0]), x.col(ids[1]), x.col(ids[2]));
      std::copy(values.begin(), values.end(), height);
    });
}

template class NormalAlignmentTerm::Product<float>;
template class NormalAlignmentTerm::Product<double>;
}
