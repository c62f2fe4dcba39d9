// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_DeviationProblem_h
#define lmo_DeviationProblem_h

#include "Core/Deviation/ReferenceSurface.h"
#include "Core/Operators/MeshQuantities.h"
#include "Core/Optimizer/RunPlan.h"

namespace lmo
{
/// The surface that the mesh has to stay near: the plan's reference, or the mesh as it is.
ReferenceSurface ReferenceOf(const MeshQuantities& mesh, const RunPlan& plan);

/// Of distances between that surface and the mesh.
double DistanceRoundOff(const MeshQuantities& mesh, const RunPlan& plan);

/// How far these may be apart, less the round-off.
double LargestDistance(const MeshQuantities& mesh, const RunPlan& plan);

/// The problem of a pass within a deviation (Eqn. 11), without its targets and position weights:
/// free vertices move in their tangent planes, vertices of high valence and their neighbours stay.
LeastSquaresProblem SetUpTangentialProblem(
  const MeshQuantities& mesh, const DisplacementConstraints& constraints);

/// Sets the part of L_u V along the normals as the target, and the axes of the constraints.
/// \param V where the vertices are now
void SetTargets(const MeshQuantities& mesh, const FeatureLines& features, const Points& V,
  LeastSquaresProblem& problem);

/// Number of triangles with t < 0.45 of which no corner may move.
Index CountPinnedBad(const Triangles& triangles, const Vector& triangleQuality,
  const DisplacementConstraints& constraints);

/// Sets W_p: cumulative weights, smaller at bad triangles.
/// \param cumulative C(kappa) of Eqn. 13
/// \param triangleQuality radius ratios as they are now
/// \param adaptiveFactors factor of each vertex
void SetPositionWeights(const MeshQuantities& mesh, const Vector& cumulative,
  const Vector& triangleQuality, const Vector& adaptiveFactors, LeastSquaresProblem& problem);
}

#endif
