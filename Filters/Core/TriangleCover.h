// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_TriangleCover_h
#define lmo_TriangleCover_h

#include "TriangleNeighbours.h"

namespace lmo
{
/// A mesh by its parts, which somebody else keeps.
struct SurfaceView
{
  const Points& V;
  const Triangles& T;
  const Triangles& neighbours; ///< what FindTriangleNeighbours() returned
};

/// Corners a, b and c, one per row.
using TriangleCorners = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

inline TriangleCorners CornersOf(const Points& V, const Triangles& triangles, Index t)
{
  TriangleCorners corners;
  corners << V.row(triangles(t, 0)), V.row(triangles(t, 1)), V.row(triangles(t, 2));
  return corners;
}

/// Bounds the distance of a triangle to a mesh: the mesh's triangles are laid over it along its
/// normal. Those that meet it are collected across common edges; if each of them faces the same
/// side and no edge inside it is a boundary, they cover it (a local homeomorphism onto a disc is
/// one-to-one). Over each part the height is linear, so the largest one is at a corner of a part.
/// The cost does not depend on the distance allowed.
class TriangleCover
{
public:
  enum Verdict
  {
    WITHIN, ///< every point of the triangle is that close to the mesh
    BEYOND, ///< a part of the mesh is farther than that from the part of the triangle over it
    UNCLEAR ///< another test has to decide
  };

  /// \param mesh its triangle \a seed should be close to the centre of \a triangle
  /// \param distance that is allowed
  Verdict Test(
    const TriangleCorners& triangle, const SurfaceView& mesh, Index seed, double distance);

  /// The mesh's triangle over the centre, or -1: the next seed.
  Index GetCentre() const { return this->Used.empty() ? -1 : this->Used[0]; }

  /// The triangles that the verdict is based on; the last is the one that is BEYOND.
  const std::vector<Index>& GetUsed() const { return this->Used; }

  /// The largest distance, as far as it is known.
  double GetBound() const { return this->Bound; }

private:
  /// A point by its barycentric coordinates for b and c, and its height.
  using Projected = Eigen::Vector3d;

  struct ProjectedTriangle
  {
    Projected corners[3];
    double orientation; ///< twice the signed area, that of the covered triangle being 1
  };

  /// False if the triangle has no normal.
  bool SetFrame(const TriangleCorners& triangle);
  ProjectedTriangle Project(const SurfaceView& mesh, Index t) const;

  /// Walks to the triangle over the centre; -1 if there is no way.
  Index FindCentre(const SurfaceView& mesh, Index seed) const;

  /// Judges the part of t over the triangle.
  Verdict TestPart(const SurfaceView& mesh, Index t, const ProjectedTriangle& part, double distance);

  Vector3 Origin;
  Eigen::Matrix3d Frame; ///< maps an offset from Origin to Projected
  std::vector<Index> Used;
  double Bound = 0;
};
}

#endif
