// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_GhostVertices_h
#define lmo_GhostVertices_h

#include "Communicator.h"
#include "Core/Base/Types.h"
#include "PetscSupport.h"

namespace lmo
{
/// Where a vertex is owned: in which process, and its number there.
struct VertexPlace
{
  int rank;
  Index number;
};

/// A list of vertices, each of which is owned by some process.
class GhostVertices
{
public:
  /// \param owned number of vertices that this process owns
  GhostVertices(const Communicator& comm, Index owned, const std::vector<VertexPlace>& places);

  /// Gives each copy the values of its owner.
  /// \param owners \a components values for each vertex owned, one vertex after the other
  /// \param ghosts room for as many values for each copy; does not overlap \a owners
  void Update(const double* owners, double* ghosts, int components) const;
  void Update(const float* owners, float* ghosts, int components) const;

  /// Gives each owner the largest of its own value and those of the ghosts.
  void ReduceMaximum(const double* ghosts, double* owners) const;

private:
  void UpdateUnits(const void* owners, void* ghosts, MPI_Datatype unit) const;

  PetscStarForest Forest;
};
}

#endif
