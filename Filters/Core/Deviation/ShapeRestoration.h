// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_ShapeRestoration_h
#define lmo_ShapeRestoration_h

#include "Core/Mesh/MeshTopology.h"

namespace lmo
{
/// Tells what smoothing takes from the shape from what it takes from noise: a triangle that turns
/// over is noise only if others were inverted before.
class ShapeRestoration
{
public:
  /// Keeps references to the arguments.
  /// \param start positions before smoothing
  /// \param component connected component of each vertex
  ShapeRestoration(const Points& start, const Triangles& triangles, const MeshTopology& topology,
    const std::vector<Index>& component);

  /// For each component whether more triangles have turned over than had been inverted
  /// (NormalsToKeep) and one in a hundred.
  Mask FindTurned(const Points& positions) const;

  /// Takes half and more of their displacement from the corners of triangles that have turned over,
  /// until none has.
  /// \param isChosen for the components that this is done for
  void Restore(const Mask& isChosen, Points& positions) const;

private:
  bool IsTurned(const Points& positions, Index t) const;
  Index ComponentOf(Index t) const { return this->Component[this->T(t, 0)]; }

  const Points& Start;
  const Triangles& T;
  const std::vector<Index>& Component;
  const Index Components;
  const Points Normals;
};
}

#endif
