// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_ProblemSetup_h
#define lmo_ProblemSetup_h

#include "Core/LeastSquares/LeastSquaresProblem.h"
#include "Core/Mesh/FeatureLines.h"
#include "Core/Operators/CotangentQuantities.h"
#include "Core/Optimizer/OptimizerOptions.h"

namespace lmo
{
/// The type of L: UNIFORM in the modes that do not choose it.
LaplacianType UsedLaplacian(const OptimizerOptions& options);

/// The diagonal of W_p: sections 5 and 6, times W_t of section 5.2 if asked for. A component that
/// neither a positive weight nor a fixed vertex holds gets the weight s.
/// \throw InputError if an array that the options need is missing.
Vector PositionWeights(const CotangentQuantities& quantities, const OptimizerOptions& options,
  const VertexArrays& arrays);

/// The diagonal of W_L: sections 5.3 and 6.
/// \throw InputError if an array that the options need is missing.
Vector LaplacianWeights(const CotangentQuantities& quantities, const OptimizerOptions& options,
  const VertexArrays& arrays);

/// True if the options ask for features.
bool HasFeatures(const OptimizerOptions& options);

/// The lines along which vertices slide: the boundary and features, as far as the options ask for
/// them.
std::optional<FeatureLines> SlidingLines(
  const MeshQuantities& mesh, const OptimizerOptions& options, const VertexArrays& arrays);

/// What each vertex may do.
/// \param lines what SlidingLines() returned
DisplacementConstraints ChooseMotion(const MeshTopology& topology, const OptimizerOptions& options,
  const VertexArrays& arrays, const std::optional<FeatureLines>& lines);

/// Eqn. 11 for the options.
/// \param lines what SlidingLines() returned
/// \throw InputError if an array that the options need is missing.
LeastSquaresProblem SetUpProblem(const CotangentQuantities& quantities,
  const OptimizerOptions& options, const VertexArrays& arrays,
  const std::optional<FeatureLines>& lines);
}

#endif
