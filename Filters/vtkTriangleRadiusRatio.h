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
 * triangles, with cell array `RadiusRatio`, which is the active one, point array `RadiusRatio`
 * (minimum over the cells at the point, -1 if there are none), and field arrays `MeanRadiusRatio`
 * and `MinimumRadiusRatio` of one value over all cells. A strip has the minimum of its triangles,
 * each of which counts in the mean. A polygon with n > 3 corners has the minimum over its corners
 * of 2 |a x b| / ((a^2 + b^2) sin theta_n), clipped to 1, with the edges a and b of the corner and
 * the angle theta_n of the regular polygon: for convex quads Verdict's Shape. Vertices and lines
 * have -1.
 *
 * Inputs that are no vtkPolyData are taken for their surface: the cells that are one, and the outer
 * faces of those that fill a volume.
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

  ///@{
  /**
   * Points on the boundary that have exactly the same coordinates are one vertex: a soup of
   * triangles, as STL and OBJ files hold it, and the sides of a seam of texture coordinates are
   * connected there. The output keeps all points, their ids and their data. Points inside a surface
   * are not compared, so that closed surfaces that touch stay apart. Default: on.
   */
  vtkSetMacro(WeldCoincidentPoints, vtkTypeBool);
  vtkGetMacro(WeldCoincidentPoints, vtkTypeBool);
  vtkBooleanMacro(WeldCoincidentPoints, vtkTypeBool);
  ///@}

protected:
  vtkTriangleRadiusRatio() = default;
  ~vtkTriangleRadiusRatio() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  double MeanRadiusRatio = -1;
  double MinimumRadiusRatio = -1;
  vtkTypeBool WeldCoincidentPoints = 1;

private:
  vtkTriangleRadiusRatio(const vtkTriangleRadiusRatio&) = delete;
  void operator=(const vtkTriangleRadiusRatio&) = delete;
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
#endif
