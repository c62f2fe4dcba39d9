// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_Laplacian_h
#define lmo_Laplacian_h

#include "Core/Mesh/Subdomain.h"

#include <memory>

namespace lmo
{
/// L of Eqn. 11.
enum class LaplacianType
{
  UNIFORM,
  COTANGENT,
  MEAN_CURVATURE
};

/// A discrete Laplace operator L = G (S - E): S holds the symmetric edge weights omega_ij, the
/// diagonal E their sums over each one-ring, the diagonal G a scale for each row. With this sign
/// L V points to the inner side of a convex surface.
struct Laplacian
{
  std::shared_ptr<const AdjacencyLists> rings;
  std::shared_ptr<const Vector> edgeWeights; ///< omega_ij for each entry of rings; null: all 1
  Vector rowScale;                           ///< G; 0 makes an empty row
};

/// What L_c and L_ck of a mesh are made of.
struct CotangentParts
{
  std::shared_ptr<const AdjacencyLists> rings; ///< neighbours, which need not share a mesh edge
  std::shared_ptr<const Vector> edgeWeights;   ///< omega_ij for each entry of rings
  Vector voronoiAreas;                         ///< their sum is the area of the surface
};

/// Eqns. 2, 3, 5: L_u, each row the mean of the one-ring minus the vertex.
Laplacian UniformLaplacian(std::shared_ptr<const AdjacencyLists> oneRings);

/// Eqn. 4: omega_ij = cot alpha + cot beta for each entry of the one-rings; one cotangent at a
/// boundary edge.
std::shared_ptr<const Vector> CotangentEdgeWeights(
  const MeshTopology& topology, const Triangles& triangles, const CornerValues& cotangents);

/// The same with the cotangents of each needle, a triangle with an edge far shorter than the other
/// two, divided by one number so that none is above 70. Those of caps, whose corners are nearly in
/// line, are left alone.
/// \return null if there are no needles
std::shared_ptr<const Vector> ClampedEdgeWeights(
  const MeshTopology& topology, const Triangles& triangles, CornerValues cotangents);

/// Eqns. 2, 4, 5: L_c with normalised weights. A row whose weights cancel is empty.
Laplacian CotangentLaplacian(
  std::shared_ptr<const AdjacencyLists> oneRings, std::shared_ptr<const Vector> edgeWeights);

/// Eqn. 7: L_ck, rows scaled by 1 / 4A; its unit is 1 / length^2. A row without area is empty.
Laplacian MeanCurvatureLaplacian(std::shared_ptr<const AdjacencyLists> oneRings,
  std::shared_ptr<const Vector> edgeWeights, const Vector& voronoiAreas);

/// Square of a length that makes L_ck comparable to L_c: median over the vertices of
/// 4 A_i / sum_j omega_ij, taken where both are positive; 0 if there are none.
double SquaredLengthScale(
  const Laplacian& meanCurvatureLaplacian, const Subdomain& subdomain = Subdomain());

/// Row i of K x with K = E - S: the sum over the one-ring of omega_ij (x_i - x_j). Differences are
/// taken before they are summed, so that the distance of the mesh from the origin does no harm.
inline Vector3 StiffnessRow(const Laplacian& L, const Points& x, Index i)
{
  const AdjacencyLists& rings = *L.rings;
  const Vector3 centre = x.row(i);
  Vector3 sum = Vector3::Zero();
  if (L.edgeWeights)
  {
    for (Index k = rings.offsets[i]; k < rings.offsets[i + 1]; ++k)
    {
      sum += (*L.edgeWeights)[k] * (centre - x.row(rings.ids[k]));
    }
  }
  else
  {
    for (Index k = rings.offsets[i]; k < rings.offsets[i + 1]; ++k)
    {
      sum += centre - x.row(rings.ids[k]);
    }
  }
  return sum;
}

/// Row i of L x = -G K x.
inline Vector3 LaplacianRow(const Laplacian& L, const Points& x, Index i)
{
  return -L.rowScale[i] * StiffnessRow(L, x, i);
}

/// Eqn. 6: L x, one row per vertex.
Points Apply(const Laplacian& L, const Points& x);

/// Sum of the edge weights around vertex i: E_ii.
double WeightSum(const Laplacian& L, Index i);
}

#endif
