// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPLaplacianMeshOptimizer
 * @brief   vtkLaplacianMeshOptimizer for a surface whose pieces are on the processes of an MPI job
 *
 * All pieces together are one mesh with one system of equations and one set of statistics, which
 * PETSc solves. vtkLaplacianMeshOptimizer::New() makes this class where its module is linked, or
 * imported in Python.
 *
 * Points that have the same global id (vtkDataSetAttributes::GetGlobalIds()) are one; without
 * global ids, points with the same coordinates are (vtkGenerateGlobalIds). Their ghosts come out
 * identical in all processes. Cells that vtkGhostType marks as duplicates do not count. Pieces may
 * be cut in any way and may be empty.
 *
 * Of a composite data set, the blocks with the same index on all processes are the pieces of one
 * surface; different blocks are different surfaces. The partitions of a vtkPartitionedDataSet are
 * pieces, too.
 *
 * What needs the whole surface is done by process 0, which gathers the pieces, optimizes them as
 * one process does, and hands the results back: SMOOTH_GUIDED, RobustLaplacian, FeatureSmoothing,
 * BoundaryCondition CURVE, PreserveVolume, CheckSelfIntersections, and OPTIMIZE_WITHIN_DEVIATION
 * of fewer than 20,000 points for each process, of polygons, with a Reference, with labels of cells
 * as features, and with StartFromPreviousTimeStep. All else is done where the pieces are.
 *
 * Every process has to execute the filter, with the same properties. An error in one process is an
 * error in all. The metrics, on every process, are those of the whole surface. With one process, or
 * without MPI, this is vtkLaplacianMeshOptimizer.
 *
 * Options of PETSc with the prefixes -lmo_ksp_ and -lmo_pc_ (conjugate gradients, which are PETSc's
 * from the start if there are such options), -lmo_amg_ (multigrid) and -lmo_direct_ (factorisation)
 * are read from the environment variable PETSC_OPTIONS.
 *
 * One thread for each process is used, unless a backend of vtkSMPTools is chosen.
 *
 * @sa vtkLaplacianMeshOptimizer vtkGenerateGlobalIds
 */
#ifndef vtkPLaplacianMeshOptimizer_h
#define vtkPLaplacianMeshOptimizer_h

#include "vtkFiltersLaplacianMeshParallelModule.h" // for export macro
#include "vtkLaplacianMeshOptimizer.h"

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

class vtkMultiProcessController;

class VTKFILTERSLAPLACIANMESHPARALLEL_EXPORT vtkPLaplacianMeshOptimizer
  : public vtkLaplacianMeshOptimizer
{
public:
  static vtkPLaplacianMeshOptimizer* New();
  vtkTypeMacro(vtkPLaplacianMeshOptimizer, vtkLaplacianMeshOptimizer);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The processes that hold the surface. Default: the global controller.
   */
  virtual void SetController(vtkMultiProcessController*);
  vtkGetObjectMacro(Controller, vtkMultiProcessController);
  ///@}

  /**
   * Over several processes, which have to execute together, this executes nothing.
   */
  int UpdateMetrics() override;

protected:
  vtkPLaplacianMeshOptimizer();
  ~vtkPLaplacianMeshOptimizer() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  std::unique_ptr<Session> MakeSession() override;

  vtkMultiProcessController* Controller = nullptr;

private:
  vtkPLaplacianMeshOptimizer(const vtkPLaplacianMeshOptimizer&) = delete;
  void operator=(const vtkPLaplacianMeshOptimizer&) = delete;

  class DistributedSession;
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
#endif
