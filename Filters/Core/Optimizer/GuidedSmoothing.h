// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_GuidedSmoothing_h
#define lmo_GuidedSmoothing_h

#include "Core/Solvers/ConjugateGradient.h"

namespace lmo
{
/// Moves the vertices so that the triangles take given normals m: minimises
///   sum_f sum_{k in f} (m_f (v_k - c_f))^2 + sum_i |T_i (L v)_i|^2 + mu^2 |v - V|^2,
/// where c_f is the triangle's centroid and T_i projects on the directions in which the normals
/// around vertex i leave it free: two on a plane, one on an edge, none at a corner (the small
/// eigenvalues of the sum of m m^T).
/// \param normals m, one unit row per triangle, or 0
/// \param L uniform Laplacian
/// \param detailWeight mu > 0
/// \param guess of the displacement
/// \throw Cancelled if the monitor says so.
Solution FollowNormals(const Points& V, const Triangles& triangles, const MeshTopology& topology,
  Points normals, const Laplacian& L, const DisplacementConstraints& constraints,
  double detailWeight, Points guess, const SolverOptions& options, ProgressMonitor& monitor);
}

#endif
