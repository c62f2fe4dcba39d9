// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_SeamSelection_h
#define lmo_SeamSelection_h

#include "Core/Optimizer/RunPlan.h"
#include "DistributedSubdomain.h"

#include <array>

namespace lmo
{
/// The vertices of a triangle, by their rows over all processes.
using RowTriple = std::array<std::int64_t, 3>;

RowTriple RowsOf(const DistributedMesh& mesh, const Triangles& triangles, Index t);

/// A vertex at the seam between pieces, on its way to process 0.
struct SeamVertex
{
  std::int64_t row;
  double original[3];
  double position[3];
  double tangent[3];          ///< of its line
  double positionWeight;      ///< C(kappa)
  std::int64_t neighbours[2]; ///< along its line; -1 if it is in none
  int sender;                 ///< the process that sends this
  bool isOwned;               ///< by that process
  bool isFree;                ///< may move
  unsigned char pointClass;   ///< FeatureLines::Class
};

/// A triangle at the seam.
struct SeamTriangle
{
  RowTriple rows;
  int home; ///< the process that owns it
};

/// What a process sends of the seam.
struct SeamPart
{
  std::vector<SeamVertex> vertices;
  std::vector<SeamTriangle> triangles; ///< those that move, and those around and near them
  std::vector<RowTriple> reference;    ///< original triangles that the ones that move are near
};

/// For each vertex whether it may move while the vertices of all other processes do: its triangles
/// are farther from those that other processes own than two surfaces can come towards each other.
/// Collective.
/// \param distance by which a surface may move
Vector FindInnerVertices(
  const MeshQuantities& mesh, const DistributedSubdomain& subdomain, double distance);

/// Chooses what moves when the inner vertices have moved: the other ones, and those within some
/// edges of them. Collective.
/// \param plan of the mesh as it was at first
/// \param isInner what FindInnerVertices() returned
/// \param edges how many
/// \param V positions of the vertices now
/// \param distance that any surface may be from the original one
SeamPart SelectSeam(const MeshQuantities& mesh, const DistributedSubdomain& subdomain,
  const RunPlan& plan, const Vector& isInner, int edges, const Points& V, double distance);
}

#endif
