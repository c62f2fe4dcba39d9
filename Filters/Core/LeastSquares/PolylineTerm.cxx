// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/LeastSquares/PolylineTerm.h"

#include <utility>

namespace lmo
{
Vector3 PolylineRow::Missing(const Points& d) const
{
  return d.rows() == 0 ? this->target : Vector3(this->target - this->Apply(d));
}

PolylineTerm::PolylineTerm(std::vector<PolylineRow> polylineRows, Index vertices)
  : rows(std::move(polylineRows))
{
  Triangles ids(this->rows.size(), 3);
  for (std::size_t k = 0; k < this->rows.size(); ++k)
  {
    ids.row(k) << this->rows[k].previous, this->rows[k].vertex, this->rows[k].next;
  }
  this->rowsAt = CornersAtVertices(vertices, ids);
}

double PolylineTerm::Energy(const Points& d) const
{
  double energy = 0;
  for (const PolylineRow& row : this->rows)
  {
    energy += (row.weight * row.Missing(d)).squaredNorm();
  }
  return energy;
}

Points PolylineTerm::Forces(const Points& d) const
{
  Points forces(this->rows.size(), 3);
  for (std::size_t k = 0; k < this->rows.size(); ++k)
  {
    forces.row(k) = this->rows[k].weight * this->rows[k].weight * this->rows[k].Missing(d);
  }
  return forces;
}

void PolylineTerm::AddEntries(MatrixEntries& entries) const
{
  for (const PolylineRow& row : this->rows)
  {
    const Index ids[3] = { row.previous, row.vertex, row.next };
    for (int a = 0; a < 3; ++a)
    {
      for (int b = 0; b < 3; ++b)
      {
        entries.isotropic.emplace_back(
          ids[a], ids[b], row.weight * row.Coefficient(a) * (row.weight * row.Coefficient(b)));
      }
    }
  }
}

template <typename Scalar>
void PolylineTerm::Product<Scalar>::Prepare(const PackedPoints<Scalar>& x)
{
  for (std::size_t k = 0; k < this->Term.rows.size(); ++k)
  {
    const PolylineRow& row = this->Term.rows[k];
    this->Forces.col(k) = Scalar(row.weight * row.weight) *
                          (Scalar(row.share) * x.col(row.previous) +
                            Scalar(1 - row.share) * x.col(row.next) - x.col(row.vertex));
  }
}

template class PolylineTerm::Product<float>;
template class PolylineTerm::Product<double>;
}
