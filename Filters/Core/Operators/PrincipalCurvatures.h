// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_PrincipalCurvatures_h
#define lmo_PrincipalCurvatures_h

#include "Core/Base/ProgressMonitor.h"
#include "Core/Mesh/MeshTopology.h"

namespace lmo
{
/// The second fundamental form at each vertex, by its eigenvalues and eigenvectors.
struct PrincipalCurvatures
{
  Vector first;            ///< k1, 1 / length; positive where the surface is convex
  Vector second;           ///< k2 <= k1
  Points firstDirections;  ///< unit tangent vector along which the normal curvature is k1
  Points secondDirections; ///< the same for k2; with k1's and the normal a right-handed system

  explicit PrincipalCurvatures(Index vertices);
};

/// Fits a polynomial of degree 4 to the height of the surface over the tangent plane of each
/// vertex, by least squares over the vertices of three rings (Cazals and Pouget, Estimating
/// Differential Quantities Using Polynomial Fitting of Osculating Jets, 2003). With the distance h
/// of the vertices the error of the curvatures is O(h^3) inside the surface. The normal is that of
/// the polynomial.
///
/// Where three rings have few vertices, as at the boundary, more rings count. The degree is lower
/// where the vertices do not determine a polynomial of degree 4; where not even one of degree 2,
/// all is 0. Vertices whose normals turn away from the vertex's own by more than 72 degrees are
/// left out, since the surface is no height field there. Of the neighbours of a vertex with many,
/// some count. Curvatures below 1e-6 / diagonal are round-off and count as 0.
///
/// The sign of a first direction is such that its largest component is positive. Where k1 = k2, the
/// directions are any two.
/// \param vertexNormals unit normals; 0 where undefined, where all is 0
/// \param diagonal of the bounding box
/// \throw Cancelled if the monitor says so.
PrincipalCurvatures ComputePrincipalCurvatures(const Points& V, const Points& vertexNormals,
  const MeshTopology& topology, double diagonal, ProgressMonitor& monitor);
}

#endif
