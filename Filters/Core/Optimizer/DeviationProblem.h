// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_DeviationProblem_h
#define lmo_DeviationProblem_h

#include "Core/LeastSquares/LeastSquaresProblem.h"
#include "Core/Mesh/FeatureLines.h"
#include "Core/Operators/MeshQuantities.h"

namespace lmo
{
/// The problem of a pass within a deviation (Eqn. 11), without its targets and position weights:
/// free vertices move in their tangent planes, vertices of high valence and their neighbours stay.
LeastSquaresProblem SetUpTangentialProblem(
  const MeshQuantities& mesh, const DisplacementConstraints& constraints);

/// Sets the part of L_u V along the normals as the target, and the axes of the constraints.
/// \param V where the vertices are now
void SetTargets(const MeshQuantities& mesh, const FeatureLines& features, const Points& V,
  LeastSquaresProblem& problem);

/// Sets W_p: cumulative weights, smaller at bad triangles.
/// \param cumulative C(kappa) of Eqn. 13
/// \param triangleQuality radius ratios as they are now
/// \param adaptiveFactors factor of each vertex
void SetPositionWeights(const MeshQuantities& mesh, const Vector& cumulative,
  const Vector& triangleQuality, const Vector& adaptiveFactors, LeastSquaresProblem& problem);
}

#endif
