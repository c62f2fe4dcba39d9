// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_DistributedOptimizer_h
#define lmo_DistributedOptimizer_h

#include "Core/Optimizer/Optimizer.h"
#include "DistributedPlaces.h"

namespace lmo
{
/// Optimizer for a surface over several processes, for what needs no more of it in one of them: not
/// for SMOOTH_GUIDED, robust Laplacians, curves that are smoothed, volumes, self-intersections of
/// other modes than OPTIMIZE_WITHIN_DEVIATION, labels, a reference and earlier steps. All functions
/// are collective, and every process throws what one throws.
class DistributedOptimizer : public Optimizer
{
public:
  /// \param piece of this process; its owners need not be set
  /// \param triangles of the piece, with those of other processes that this one has too, for which
  ///   it wants radius ratios
  /// \throw InputError as DistributedMesh does.
  DistributedOptimizer(const Communicator& comm, Piece piece, Triangles triangles);

  /// Optimizer::Run() with a row for each point of the piece and each triangle given; the metrics
  /// are those of the whole surface.
  /// \param arrays may lack in processes without points
  OptimizerResult Run(
    const OptimizerOptions& options, const VertexArrays& arrays, ProgressMonitor& monitor) override;

  /// The places to which the points of the piece have moved.
  std::unique_ptr<const DistributedPlaces> FindPlaces(const Points& positions) const;

protected:
  ModeResult OptimizeWithin(RunPlan& plan, ProgressMonitor& monitor) override;

private:
  /// What the vertices that this process knows are made of.
  struct Parts
  {
    std::shared_ptr<DistributedMesh> mesh; ///< null if no process has points
    Points points = Points(0, 3);
    Triangles triangles = Triangles(0, 3);
    std::shared_ptr<const Subdomain> subdomain = std::make_shared<Subdomain>();
    ProblemSolver solve = [](auto&&...) { return Solution{ Points(0, 3), 0, 0, 0 }; };
  };

  static Parts Distribute(const Communicator& comm, Piece piece);

  DistributedOptimizer(const Communicator& comm, Parts parts, Triangles triangles);

  OptimizerResult ToPiece(OptimizerResult result) const;

  /// Whether each triangle of the piece is one of the marked triangles of the mesh.
  Mask MarksOfPiece(const Mask& isMarked) const;

  const Communicator Comm;
  const Triangles PieceTriangles;
  const std::shared_ptr<const DistributedMesh> Mesh; ///< null if no process has points
};
}

#endif
