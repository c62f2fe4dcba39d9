// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SharedPoints_h
#define SharedPoints_h

#include "Core/Base/Types.h"

#include <cstdint>
#include <vector>

namespace lmo
{
/// Which points of the pieces of a surface are the same vertex by their coordinates: at the border
/// of a piece, all points of pieces at that place. Points inside of two pieces stay apart, so that
/// closed surfaces that touch do; points that no triangle uses, as those of ghost cells, join one
/// that a triangle of another piece uses.
/// \param pieceOf the piece of each point
/// \return for each point the lowest point that is the same vertex; empty if no two are the same
std::vector<Index> FindPointsOfSamePlace(
  const Points& V, const Triangles& triangles, const std::vector<Index>& pieceOf);

/// The same by global ids.
/// \throw InputError if points with the same id lie apart.
std::vector<Index> FindPointsOfSameId(const Points& V, const std::vector<std::int64_t>& ids);
}

#endif
