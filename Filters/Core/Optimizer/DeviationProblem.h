// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_DeviationProblem_h
#define lmo_DeviationProblem_h

#include "Core/Deviation/DeviationGuard.h"
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

/// Least t that a pass may give a triangle which had it, none below the least of the input.
double LeastQuality(int pass, const MeshQuality& input);

/// The gain of t_mean without which the first pass moves nothing: a result of an earlier run, which
/// has the triangles of its reference, is to stay as it is.
double LeastGain(const MeshQuantities& mesh, const RunPlan& plan);

/// From the mesh to the earlier step's result, moved as its surface has moved since, as far as the
/// constraints allow.
Points DisplacementAfter(const EarlierStep& earlier, const MeshQuantities& mesh,
  const DisplacementConstraints& constraints);

/// How far along its normal a vertex has to move for its triangles to be, at their extremes, as far
/// above the reference as below it; 0 if there is distance left.
/// \param distance allowed
double CentreAt(
  const DeviationGuard& guard, const MeshTopology& topology, double distance, Index i);

/// Bound of the Hausdorff distance of reference and accepted mesh: what is certified; where the
/// mesh itself is the reference, the largest displacement if that is smaller.
double HausdorffBound(const DeviationGuard& guard, const MeshQuantities& mesh, const RunPlan& plan);

/// Number of vertices that may move and have a share below 1 of their displacement.
Index CountReduced(const Vector& shares, const DisplacementConstraints& constraints);

/// Number of bad triangles of which no corner may move.
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
