// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_HaloTriangles_h
#define lmo_HaloTriangles_h

#include "Ownership.h"

namespace lmo
{
/// The triangles that one process brings along.
struct Piece
{
  Points points;
  Triangles triangles;
  std::vector<GlobalId> ids; ///< of each point
  std::vector<int> owners;   ///< of each point
};

/// A triangle on its way between processes.
struct TravellingTriangle
{
  std::int64_t number; ///< over all processes
  int home;            ///< the process that brought it along
  OwnedVertex vertices[3];
};

/// The triangles within two edges of the vertices that a process owns.
struct Neighbourhood
{
  std::vector<Index> own;                  ///< those of its piece, ascending
  std::vector<TravellingTriangle> foreign; ///< those of other pieces, ascending
};

/// \param firstNumber over all processes, of the first triangle of \a piece
Neighbourhood GatherNeighbourhood(
  const Communicator& comm, const Piece& piece, std::int64_t firstNumber);
}

#endif
