// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_PolylineTerm_h
#define lmo_PolylineTerm_h

#include "Core/Base/Types.h"

namespace lmo
{
/// A Laplacian row of a polyline: weight ((d_previous + d_next) / 2 - d_vertex - target).
struct PolylineRow
{
  Index vertex;
  Index previous;
  Index next;
  double weight;
  Vector3 target;
};

/// The sum of the squared rows of polylines.
struct PolylineTerm
{
  std::vector<PolylineRow> rows; ///< for vertices whose row of L is empty
};
}

#endif
