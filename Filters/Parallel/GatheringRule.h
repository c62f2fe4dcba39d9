// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef GatheringRule_h
#define GatheringRule_h

#include "Communicator.h"

class vtkLaplacianMeshOptimizer;

namespace lmo
{
/// True if what the filter is to do with its input needs the whole surface in one process.
/// Collective.
bool NeedsOneProcess(vtkLaplacianMeshOptimizer* filter, const Communicator& comm);
}

#endif
