// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_SurfaceSampler_h
#define lmo_SurfaceSampler_h

#include "Core/Base/Types.h"

namespace lmo
{
/// Points spread over the triangles of a surface so that equal areas get equal numbers, as in Metro
/// (Cignoni et al. 1998). The points are the same in every run.
class SurfaceSampler
{
public:
  /// Keeps references to the arguments.
  SurfaceSampler(const Points& V, const Triangles& triangles);

  /// \param k number of the sample, 0 to \a count - 1
  /// \param count of all samples; the area must be positive
  Vector3 Sample(Index k, Index count) const;

  double Area() const { return this->AreaUpTo.empty() ? 0 : this->AreaUpTo.back(); }

private:
  const Points& V;
  const Triangles& T;
  std::vector<double> AreaUpTo; ///< area of each triangle and all before it
};
}

#endif
