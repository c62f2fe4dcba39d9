// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_DistributedOptimizer_h
#define lmo_DistributedOptimizer_h

#include "Core/Optimizer/Optimizer.h"
#include "DistributedMesh.h"

namespace lmo
{
/// Optimizer for a surface over several processes. All functions are collective, and every process
/// throws what one throws.
class DistributedOptimizer
{
public:
  /// \param piece of this process; its owners need not be set
  /// \param triangles of the piece, with those of other processes that this one has too, for which
  ///   it wants radius ratios
  /// \throw InputError as DistributedMesh does.
  DistributedOptimizer(const Communicator& comm, Piece piece, Triangles triangles);

  /// Optimizer::Run() with a row for each point of the piece and each triangle given; the figures
  /// are those of the whole surface.
  /// \param arrays may lack in processes without points
  OptimizerResult Run(
    const OptimizerOptions& options, const VertexArrays& arrays, ProgressMonitor& monitor);

private:
  OptimizerResult ToPiece(OptimizerResult result) const;

  const Communicator Comm;
  const Triangles PieceTriangles;
  std::shared_ptr<DistributedMesh> Mesh; ///< null if no process has points
  std::unique_ptr<Optimizer> Vertices;   ///< of the vertices that this process knows
};
}

#endif
