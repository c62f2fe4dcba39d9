// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OptimizerEngine_h
#define OptimizerEngine_h

#include "Core/Optimizer/Optimizer.h"
#include "PolyDataConversion.h"

#include "vtkLaplacianMeshOptimizer.h"

#include <functional>

/// What a vtkLaplacianMeshOptimizer has its input optimized by: this class in one process, derived
/// classes in several. The optimizer is kept for the next execution, which often differs in a
/// property alone.
class VTKFILTERSLAPLACIANMESH_EXPORT vtkLaplacianMeshOptimizer::Engine
{
public:
  explicit Engine(vtkLaplacianMeshOptimizer* filter);
  virtual ~Engine();
  Engine(const Engine&) = delete;
  void operator=(const Engine&) = delete;

  /// \throw InputError if the surface is to come in several pieces that cannot be solved together.
  virtual void CheckPieces(int pieces);

  /// Calls body(), which looks at the data of this process.
  /// \throw if body() does in this or another process
  virtual void Try(const std::function<void()>& body);

  virtual std::unique_ptr<lmo::ProgressMonitor> MakeMonitor();

  /// \throw InputError as lmo::ReadMesh() does.
  virtual void SetInput(vtkPolyData* input);

  /// As lmo::Optimizer::Run(), with a row for each point and each triangle of the input; regions
  /// are those of the cells.
  virtual lmo::OptimizerResult Run(const lmo::OptimizerOptions& options,
    const lmo::VertexArrays& arrays, lmo::ProgressMonitor& monitor);

  const lmo::TriangleCells& GetTriangleCells() const { return this->TriangleCells; }

protected:
  /// True if Optimizer is not that of the input as it is now.
  bool IsNew(vtkPolyData* input) const;

  /// Reads the input and its TriangleCells.
  lmo::SurfaceMesh Read(vtkPolyData* input);

  vtkLaplacianMeshOptimizer* const Filter;
  std::unique_ptr<lmo::Optimizer> Optimizer;

private:
  vtkPolyData* Input = nullptr; ///< to be compared only
  vtkMTimeType InputTime = 0;
  lmo::TriangleCells TriangleCells;
};

#endif
