// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTriangleRadiusRatio
 * @brief   shape quality of triangles as cell and point data
 *
 * Adds the radius ratio t = 2 r / R of each triangle (Eqn. 12 of "Laplacian Mesh Optimization",
 * Nealen et al. 2006), with the radii r of the inscribed and R of the circumscribed circle: 1 for
 * an equilateral, 0 for a degenerate triangle. It is the inverse of vtkMeshQuality's RADIUS_RATIO
 * and is finite for every triangle of every size.
 *
 * Output: the input, which may have vertices, lines, triangle strips and larger polygons beside its
 * triangles, with cell array `RadiusRatio` (strips and polygons have the minimum over their
 * triangles, cut as vtkLaplacianMeshOptimizer does; vertices and lines have -1), point array
 * `RadiusRatio` (minimum over the triangles at the point, -1 if there are none), and field arrays
 * `MeanRadiusRatio` and `MinimumRadiusRatio` of one value.
 * Arrays of the input that have these names are kept unless a filter of this module made them; the
 * new ones are then named <name>Optimized, and a warning says so.
 */
#ifndef vtkTriangleRadiusRatio_h
#define vtkTriangleRadiusRatio_h

#include "vtkFiltersLaplacianMeshModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

class VTKFILTERSLAPLACIANMESH_EXPORT vtkTriangleRadiusRatio : public vtkPolyDataAlgorithm
{
public:
  static vtkTriangleRadiusRatio* New();
  vtkTypeMacro(vtkTriangleRadiusRatio, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Mean and minimum over all triangles, 0 to 1; -1 if there are none. Valid after Update().
   */
  vtkGetMacro(MeanRadiusRatio, double);
  vtkGetMacro(MinimumRadiusRatio, double);
  ///@}

protected:
  vtkTriangleRadiusRatio() = default;
  ~vtkTriangleRadiusRatio() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  double MeanRadiusRatio = -1;
  double MinimumRadiusRatio = -1;

private:
  vtkTriangleRadiusRatio(const vtkTriangleRadiusRatio&) = delete;
  void operator=(const vtkTriangleRadiusRatio&) = delete;
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
#endif
