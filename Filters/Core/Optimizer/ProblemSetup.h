// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_ProblemSetup_h
#define lmo_ProblemSetup_h

#include "Core/Operators/CotangentQuantities.h"
#include "Core/Optimizer/RunPlan.h"

namespace lmo
{
/// The diagonal of W_p: sections 5 and 6, times W_t of section 5.2 if asked for. A component that
/// neither a positive weight nor a fixed vertex holds gets the weight s.
/// \throw InputError if an array that the options need is missing.
Vector PositionWeights(const CotangentQuantities& quantities, const OptimizerOptions& options,
  const VertexArrays& arrays);

/// The diagonal of W_L: sections 5.3 and 6.
/// \throw InputError if an array that the options need is missing.
Vector LaplacianWeights(const CotangentQuantities& quantities, const OptimizerOptions& options,
  const VertexArrays& arrays);

/// What a run of the options needs, without the solver.
/// \param quantities of the options' choice of weights
/// \throw InputError if an array that the options need is missing.
/// \throw Cancelled if the monitor says so.
RunPlan MakePlan(const CotangentQuantities& quantities, const OptimizerOptions& options,
  const VertexArrays& arrays, ProgressMonitor& monitor);
}

#endif
