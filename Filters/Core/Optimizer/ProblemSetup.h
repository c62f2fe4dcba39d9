// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_ProblemSetup_h
#define lmo_ProblemSetup_h

#include "Core/Operators/CotangentQuantities.h"
#include "Core/Optimizer/RunPlan.h"

namespace lmo
{
/// What a run of the options needs, without the solver.
/// \param quantities of the options' choice of weights
/// \throw InputError if an array that the options need is missing.
/// \throw Cancelled if the monitor says so.
RunPlan MakePlan(const CotangentQuantities& quantities, const OptimizerOptions& options,
  const VertexArrays& arrays, ProgressMonitor& monitor);
}

#endif
