// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_ChosenWeights_h
#define lmo_ChosenWeights_h

#include "Core/Base/Exceptions.h"
#include "Core/Operators/CotangentQuantities.h"
#include "Core/Optimizer/OptimizerOptions.h"

#include <string>

namespace lmo
{
/// The array that the user has to give.
/// \throw InputError if it is missing.
template <typename Values>
const Values& Require(
  const MeshQuantities& mesh, const std::optional<Values>& array, const char* what)
{
  static const Values none;
  if (!array && mesh.GetPoints().rows() == 0)
  {
    return none; // an empty piece has no arrays
  }
  if (!array)
  {
    throw InputError(
      std::string(what) + ", and none is chosen. Choose one, or another scheme or mode.");
  }
  return *array;
}

/// 1 at vertices that do not move: used by no triangle, on a fixed boundary, or in
/// VertexArrays::fixedPoints.
Mask FixedVertices(
  const MeshTopology& topology, BoundaryCondition condition, const VertexArrays& arrays);

/// The diagonal of W_p: sections 5 and 6, times W_t of section 5.2 if asked for. A component that
/// neither a positive weight nor a fixed vertex holds gets the weight s.
/// \throw InputError if an array that the options need is missing.
Vector PositionWeights(const CotangentQuantities& quantities, const OptimizerOptions& options,
  const VertexArrays& arrays);

/// The diagonal of W_L: sections 5.3 and 6.
/// \throw InputError if an array that the options need is missing.
Vector LaplacianWeights(const CotangentQuantities& quantities, const OptimizerOptions& options,
  const VertexArrays& arrays);
}

#endif
