// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/LeastSquares/NormalAlignmentTerm.h"

#include "Core/Base/Threading.h"

#include <utility>

namespace lmo
{
namespace
{
/// Adds m (x_k - mean of x) of a triangle's corners with the rows a, b and c of x.
template <typename Scalar, typename Row>
void AddHeights(const Row& normal, const Row& a, const Row& b, const Row& c, Scalar* heights)
{
  const Row mean = (a + b + c) / Scalar(3);
  heights[0] += (normal.array() * (a - mean).array()).sum();
  heights[1] += (normal.array() * (b - mean).array()).sum();
  heights[2] += (normal.array() * (c - mean).array()).sum();
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

CornerValues NormalAlignmentTerm::MovedHeights(const Points& d) const
{
  CornerValues moved = this->heights;
  ParallelFor(static_cast<Index>(d.rows() > 0 ? moved.rows() : 0),
    [&](Index t)
    {
      const Index* const ids = this->triangles.row(t).data();
      AddHeights<double, Vector3>(
        this->normals.row(t), d.row(ids[0]), d.row(ids[1]), d.row(ids[2]), moved.row(t).data());
    });
  return moved;
}

double NormalAlignmentTerm::Energy(const Points& d) const
{
  return this->MovedHeights(d).squaredNorm();
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
      std::fill_n(height, 3, Scalar(0));
      AddHeights<Scalar, PackedRow<Scalar>>(
        normals.col(t), x.col(ids[0]), x.col(ids[1]), x.col(ids[2]), height);
    });
}

template class NormalAlignmentTerm::Product<float>;
template class NormalAlignmentTerm::Product<double>;
}
