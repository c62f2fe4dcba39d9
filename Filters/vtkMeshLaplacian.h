// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkMeshLaplacian
 * @brief   discrete Laplacians and curvatures of a triangle mesh as point data
 *
 * Section 3 of "Laplacian Mesh Optimization" (Nealen et al. 2006) as arrays, in double. All three
 * Laplacians point to the inner side of a convex surface.
 *
 * - `UniformLaplacian` (3): delta_u, mean of the one-ring minus the point (Eqns. 1 to 3, 6).
 * - `CotangentLaplacian` (3): delta_c, the same mean with normalised cotangent weights (Eqn. 4).
 * - `MeanCurvatureNormal` (3): kappa n, Eqn. 7; 1 / length.
 * - `MeanCurvature`: its length, 1 / length; below 1e-6 / bounding-box diagonal it is 0.
 * - `SignedMeanCurvature`: the same, negative where the surface is concave, positive where it is
 *   convex seen from outside. On surfaces that are not closed, or whose triangles differ in their
 *   orientation, outside is the side from which the triangles at the point are counter-clockwise.
 * - `GaussianCurvature`: angle defect divided by `VoronoiArea`; 1 / length^2.
 * - `VoronoiArea`: mixed Voronoi area (Meyer et al. 2003); their sum is the area of the surface.
 *
 * With PrincipalCurvatures on, also these:
 *
 * - `PrincipalCurvature1`, `PrincipalCurvature2`: k1 >= k2, 1 / length, positive where the surface
 *   is convex, as `SignedMeanCurvature`.
 * - `PrincipalDirection1`, `PrincipalDirection2` (3): unit tangent vectors along which the surface
 *   has these curvatures. Together with the outward normal they are right-handed. The largest
 *   component of the first is positive. Where k1 = k2 they are any two.
 *
 * Boundary points take the mean curvatures and the Gaussian curvature as means over their inner
 * neighbours, 0 if they have none. Points that no cell uses have 0 everywhere. Vertices and lines
 * may stand beside the polygons and triangle strips. On quads and larger polygons the one-ring is
 * that of the edges, and the other Laplacians, curvatures and areas are those of the virtual
 * refinement of Bunge, Herholz, Kazhdan and Botsch (2020), which relates all points of a polygon.
 *
 * Arrays of the input that have these names are kept unless a filter of this module made them; the
 * new ones are then named <name>Optimized, and a warning says so.
 *
 * @sa vtkLaplacianMeshOptimizer vtkCurvatures
 *
 * Inputs that are no vtkPolyData are taken for their surface: the cells that are one, and the outer
 * faces of those that fill a volume.
 */
#ifndef vtkMeshLaplacian_h
#define vtkMeshLaplacian_h

#include "vtkFiltersLaplacianMeshModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

class VTKFILTERSLAPLACIANMESH_EXPORT vtkMeshLaplacian : public vtkPolyDataAlgorithm
{
public:
  static vtkMeshLaplacian* New();
  vtkTypeMacro(vtkMeshLaplacian, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Whether the cotangent weights and the Voronoi areas are those of the intrinsic Delaunay
   * triangulation of the surface (Sharp and Crane 2020) instead of those of the mesh. No weight is
   * negative then, also on slivers, degenerate triangles and edges of three and more triangles.
   * Affects all arrays but `UniformLaplacian` and the principal curvatures. Default: off.
   */
  vtkSetMacro(RobustLaplacian, vtkTypeBool);
  vtkGetMacro(RobustLaplacian, vtkTypeBool);
  vtkBooleanMacro(RobustLaplacian, vtkTypeBool);
  ///@}

  ///@{
  /**
   * Whether to compute the principal curvatures and their directions, which takes longer than all
   * other arrays together: by a polynomial of degree 4 that is fitted to the points of three rings
   * around each point (Cazals and Pouget 2003), of lower degree where these are few. On smooth
   * surfaces the error falls with the third power of the edge length. On sharp edges the curvatures
   * are those of a rounding as wide as the triangles. Boundary points have fits of their own, which
   * are less exact. All are 0 where the points do not determine a polynomial of degree 2. On
   * polygons rings are those of the edges. Default: off.
   */
  vtkSetMacro(PrincipalCurvatures, vtkTypeBool);
  vtkGetMacro(PrincipalCurvatures, vtkTypeBool);
  vtkBooleanMacro(PrincipalCurvatures, vtkTypeBool);
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
  vtkMeshLaplacian() = default;
  ~vtkMeshLaplacian() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkTypeBool RobustLaplacian = 0;
  vtkTypeBool PrincipalCurvatures = 0;
  vtkTypeBool WeldCoincidentPoints = 1;

  vtkMeshLaplacian(const vtkMeshLaplacian&) = delete;
  void operator=(const vtkMeshLaplacian&) = delete;
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
#endif
