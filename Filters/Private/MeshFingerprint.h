// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef MeshFingerprint_h
#define MeshFingerprint_h

#include "PolyDataConversion.h"

#include <array>

namespace lmo
{
/// Hashes of a mesh's points, corners of triangles and of polygons, and numbering: the same for the
/// same mesh. Two meshes that differ in one of these have the same with a probability of 2^-64.
using MeshFingerprint = std::array<std::size_t, 5>;

MeshFingerprint FingerprintOf(const SurfaceMesh& mesh);
}

#endif
