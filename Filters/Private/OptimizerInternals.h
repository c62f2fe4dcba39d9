// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OptimizerInternals_h
#define OptimizerInternals_h

#include "OptimizerEngine.h"
#include "ResultArrays.h"

#include "vtkLaplacianMeshOptimizer.h"

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

class vtkDataArray;
class vtkFieldData;
class vtkPolyData;
class vtkSelection;

/// What needs the numerics' types.
struct vtkLaplacianMeshOptimizer::Internals
{
  explicit Internals(vtkLaplacianMeshOptimizer* filter)
    : Filter(filter)
  {
  }

  vtkLaplacianMeshOptimizer* const Filter;

  std::unique_ptr<vtkLaplacianMeshOptimizer::Engine> Engine;

  /// \throw lmo::InputError if a property is out of range.
  lmo::OptimizerOptions ReadOptions() const;

  /// The point array of an index; null if none is chosen.
  /// \throw lmo::InputError if the chosen one does not exist.
  vtkDataArray* FindArray(int index, vtkPolyData* input) const;

  /// \param selection may be null
  lmo::VertexArrays ReadArrays(vtkPolyData* input, vtkSelection* selection) const;

  /// \param selection may be null
  /// \param pieces in which the whole surface comes
  void Execute(vtkPolyData* input, vtkSelection* selection, vtkPolyData* output, int pieces);

  /// Says what the user should know of a result: what could not move and what got worse.
  void Warn(const lmo::OptimizerOptions& options, const lmo::OptimizerResult& result) const;

  void WritePoints(lmo::OptimizerResult result, vtkPolyData* input, lmo::ResultArrays& results,
    vtkPolyData* output) const;

  /// Point and cell normals of the new surface where the input has them.
  void WriteNormals(const lmo::Points& pointNormals, vtkPolyData* output) const;

  /// Sets the metrics that the Get methods return.
  void SetMetrics(const lmo::OptimizerResult& result) const;

  /// Writes them to the field data.
  void WriteMetrics(
    const lmo::OptimizerResult& result, lmo::ResultArrays& results, vtkFieldData* fieldData) const;
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

#endif
