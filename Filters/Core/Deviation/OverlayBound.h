// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_OverlayBound_h
#define lmo_OverlayBound_h

#include "Core/Deviation/SubdivisionBound.h"
#include "Core/Mesh/TriangleGeometry.h"
#include "Core/Mesh/TriangleNeighbours.h"

#include <algorithm>

namespace lmo
{
/// A mesh by its parts, which somebody else keeps.
struct SurfaceView
{
  const Points& V;
  const Triangles& T;
  const Triangles& neighbours; ///< what FindTriangleNeighbours() returned
};

/// Of a mesh over a triangle, along its normal; 0 counts always.
struct HeightRange
{
  double lowest = 0;
  double highest = 0;

  void Add(double height)
  {
    this->lowest = std::min(this->lowest, height);
    this->highest = std::max(this->highest, height);
  }

  void Add(const HeightRange& other)
  {
    this->Add(other.lowest);
    this->Add(other.highest);
  }

  HeightRange WidenedBy(double distance) const
  {
    return { this->lowest - distance, this->highest + distance };
  }

  double Largest() const { return std::max(-this->lowest, this->highest); }
  double Centre() const { return 0.5 * (this->lowest + this->highest); }
};

/// Bounds the distance of a triangle to a mesh: the mesh's triangles are laid over it along its
/// normal. Those that meet it are collected across common edges; if each of them faces the same
/// side and no edge inside it is a boundary, they cover it (a local homeomorphism onto a disc is
/// onto). They cut it into convex pieces, and since the distance to the triangle over a piece, a
/// convex set, is a convex function, it is largest at a corner of the piece. The cost does not
/// depend on the distance allowed.
class OverlayBound
{
public:
  enum Verdict
  {
    WITHIN, ///< every point of the triangle is that close to the mesh
    BEYOND, ///< a piece is farther than that from the mesh's triangle over it
    UNCLEAR ///< another test has to decide
  };

  /// \param mesh its triangle \a seed should be close to the centre of \a triangle
  /// \param subdivision in which pieces find closer triangles than the one over them; if it is
  /// null, such pieces are UNCLEAR
  /// \param distance that is allowed
  Verdict Test(const TriangleCorners& triangle, const SurfaceView& mesh, Subdivision* subdivision,
    Index seed, double distance);

  /// The mesh's triangle over the centre of \a triangle, or -1.
  Index FindCentre(const TriangleCorners& triangle, const SurfaceView& mesh, Index seed);

  /// The same that Test() has found: the next seed.
  Index GetCentre() const { return this->Used.empty() ? -1 : this->Used[0]; }

  /// The triangles that the verdict is based on; the last is the one that is BEYOND.
  const std::vector<Index>& GetUsed() const { return this->Used; }

  /// Of what was WITHIN.
  const HeightRange& GetHeights() const { return this->Heights; }

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

  /// Judges the piece of the triangle under \a t.
  Verdict TestPiece(const SurfaceView& mesh, Subdivision* subdivision, Index t,
    const ProjectedTriangle& part, double distance);

  /// The point of the triangle with these barycentric coordinates.
  Vector3 PointAt(const Projected& p) const
  {
    return this->Origin + p[0] * this->AB + p[1] * this->AC;
  }

  Vector3 Origin = Vector3::Zero(); ///< the triangle's corner a
  Vector3 AB = Vector3::Zero();
  Vector3 AC = Vector3::Zero();
  Eigen::Matrix3d Frame = Eigen::Matrix3d::Zero(); ///< maps an offset from Origin to Projected
  std::vector<Index> Used;
  std::vector<Index> Closer; ///< triangles that prove a piece and are not over it
  HeightRange Heights;
};
}

#endif
