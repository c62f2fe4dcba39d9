// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef DistributedSession_h
#define DistributedSession_h

#include "../Private/OptimizerSession.h"
#include "GatheredPieces.h"

#include "vtkPLaplacianMeshOptimizer.h"

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

/// Optimizes the pieces where they are, or, for what needs the whole surface, gathers them in
/// process 0. With one process, the session of the superclass.
class vtkPLaplacianMeshOptimizer::DistributedSession : public vtkLaplacianMeshOptimizer::Session
{
public:
  explicit DistributedSession(vtkPLaplacianMeshOptimizer* filter);

  /// The processes of a controller; MPI_COMM_NULL if there is only one, or no MPI.
  static MPI_Comm CommunicatorOf(vtkMultiProcessController* controller);

  /// How many threads this process should use: one, as the other processes work at the same time,
  /// and in process 0, while the others wait for it, those of all processes on its computer.
  static int NumberOfThreads(vtkPLaplacianMeshOptimizer* filter);

protected:
  void CheckPieces(int pieces) const override;
  void Try(const std::function<void()>& body) const override;
  std::unique_ptr<lmo::ProgressMonitor> MakeMonitor() const override;
  vtkSmartPointer<vtkPointData> PointDataAtNewPlaces(
    vtkPolyData* input, const lmo::OptimizerResult& result) const override;

  /// The surfaces of which any process has a part.
  std::vector<lmo::SurfaceBlock> FindBlocks(vtkDataObject* data) const override;

  lmo::SurfacePieces Optimize(const Job& job) override;
  void SetInput(vtkPolyData* input, const std::vector<lmo::Index>& firstPoints) override;

private:
  /// False while process 0 works on what it has gathered.
  bool IsDistributed() const;
  lmo::Communicator GetCommunicator() const;

  Job Gather(const Job& job);
  lmo::SurfacePieces OptimizeGathered(const Job& job);
  void ShareMetrics();
  void Distribute(vtkPolyData* input);

  vtkPLaplacianMeshOptimizer* const ParallelFilter;
  lmo::GatheredPieces Input;
  lmo::GatheredPieces ReferenceInput;
  bool IsAlone = false;        ///< process 0 works on what it has gathered
  bool WasDistributed = false; ///< the optimizer is a lmo::DistributedOptimizer
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

#endif
