// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef GatheredPieces_h
#define GatheredPieces_h

#include "../Private/JoinedPieces.h"
#include "Communicator.h"

class vtkMultiProcessController;

namespace lmo
{
/// The pieces of all processes in process 0. All functions are collective.
class GatheredPieces
{
public:
  /// Keeps what was gathered as long as the pieces of all processes stay as they are.
  /// \param pieces of this process
  /// \return in process 0 all pieces, those of a lower rank first; nothing in the others
  /// \throw InputError if a piece has arrays that cannot be sent.
  const SurfacePieces& Gather(
    vtkMultiProcessController* controller, const Communicator& comm, const SurfacePieces& pieces);

  /// Sends what became of the pieces back.
  /// \param changed all pieces in process 0
  /// \param pieces as in Gather()
  /// \return the pieces of this process
  SurfacePieces Return(vtkMultiProcessController* controller, const Communicator& comm,
    const SurfacePieces& changed, const SurfacePieces& pieces) const;

private:
  /// A piece that was gathered.
  struct Source
  {
    vtkPolyData* data; ///< to be compared only
    vtkMTimeType time;

    bool operator==(vtkPolyData* piece) const;
  };

  bool HasGathered = false;
  std::vector<Source> Sources;
  std::vector<int> Counts; ///< of the pieces of each process
  SurfacePieces Pieces;
};
}

#endif
