// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_Curvature_h
#define lmo_Curvature_h

#include "Core/Operators/Laplacian.h"

namespace lmo
{
/// Eqn. 7: the mean curvature normal kappa n of each vertex, 1 / length, pointing to the inner side
/// of a convex surface. A boundary vertex takes the mean over its inner neighbours, as for all
/// curvatures below; 0 if it has none.
Points MeanCurvatureNormals(
  const Laplacian& meanCurvatureLaplacian, const Points& V, const MeshTopology& topology);

/// kappa = |kappa n| >= 0, 1 / length. Values below 1e-6 / diagonal are round-off and count as 0.
/// \param diagonal of the bounding box
Vector MeanCurvatures(
  const Points& meanCurvatureNormals, double diagonal, const MeshTopology& topology);

/// Mean curvature with a sign, 1 / length: kappa where the surface is convex seen from the side to
/// which the vertex normals point, -kappa where it is concave, that is where kappa n points to that
/// side.
Vector SignedMeanCurvatures(const Points& meanCurvatureNormals, const Vector& meanCurvatures,
  const Points& vertexNormals, const MeshTopology& topology);

/// Gaussian curvature, 1 / length^2: angle defect divided by the mixed Voronoi area.
Vector GaussianCurvatures(
  const Vector& angleDefects, const Vector& voronoiAreas, const MeshTopology& topology);

/// n of Eqn. 14: unit normal of Eqn. 7; the vertex normal where kappa is 0 or at the boundary,
/// where Eqn. 7 does not define it.
Points TangentPlaneNormals(const Points& meanCurvatureNormals, const Vector& meanCurvatures,
  const Points& vertexNormals, const MeshTopology& topology);
}

#endif
