// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_PackedProjections_h
#define lmo_PackedProjections_h

#include "Core/Base/Threading.h"
#include "Core/LeastSquares/LeastSquaresProblem.h"

namespace lmo
{
/// DisplacementConstraints::Project() for products: with (axis, kept) for each vertex, x becomes
/// kept x + (1 - 2 kept) (x . axis) axis, where kept is 1 for a free vertex, whose axis is 0, and
/// in a plane, 0 along a line and where the vertex is fixed.
template <typename Scalar>
class PackedProjections
{
public:
  /// Stores nothing for a problem that is not coupled.
  explicit PackedProjections(const LeastSquaresProblem& problem)
    : Axes(4, problem.IsCoupled() ? problem.Size() : 0)
  {
    const DisplacementConstraints& constraints = problem.constraints;
    this->FreeAxes = Pack<Scalar>(constraints.freeAxes);
    ParallelFor(static_cast<Index>(this->Axes.cols()),
      [&](Index i)
      {
        const auto freedom = constraints.freedom[i];
        const bool hasAxis = freedom == DisplacementConstraints::IN_PLANE ||
                             freedom == DisplacementConstraints::ALONG_LINE;
        this->Axes.col(i) =
          Pack<Scalar>(hasAxis ? Vector3(constraints.axes.row(i)) : Vector3(Vector3::Zero()));
        this->Axes(3, i) = Scalar(freedom >= DisplacementConstraints::IN_PLANE);
      });
  }

  /// A function (i, x) that projects row x of vertex i, whose fourth entry is 0; cheap to copy.
  auto GetRows() const
  {
    return [free = this->FreeAxes, axes = View(this->Axes)](Index i, const PackedRow<Scalar>& x)
    {
      const PackedRow<Scalar> whole = free * x;
      const PackedRow<Scalar> axis = axes.col(i);
      const Scalar kept = axis[3];
      const Scalar along = (axis * whole).sum(); // the fourth of whole is 0
      PackedRow<Scalar> row = kept * whole + (1 - 2 * kept) * along * axis;
      row[3] = 0;
      return row;
    };
  }

private:
  PackedPoints<Scalar> Axes; ///< with what is kept in the fourth row
  PackedRow<Scalar> FreeAxes;
};
}

#endif
