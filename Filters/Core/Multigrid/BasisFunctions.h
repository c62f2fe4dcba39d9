// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_BasisFunctions_h
#define lmo_BasisFunctions_h

#include "Core/Base/ProgressMonitor.h"
#include "Core/Mesh/AdjacencyLists.h"
#include "Core/Multigrid/SparseProduct.h"

#include <vector>

namespace lmo
{
/// Smooth functions on a mesh, on several scales. Those of the first are a few edges wide. Each
/// function of the next scale is a sum of some of them, and about eight times as many vertices
/// wide, and so on until a few functions are left.
/// \param rings the neighbours of each vertex
/// \return for each scale a matrix of the values of its functions (columns) at the vertices, or of
/// their shares in the functions of the scale before (rows). A row has at most four entries, which
/// are positive and sum to 1; that of a vertex without neighbours is empty.
/// \throw Cancelled if the monitor says so; it is asked a few times for each scale.
std::vector<SparseRows> BasisFunctions(const AdjacencyLists& rings, ProgressMonitor& monitor);
}

#endif
