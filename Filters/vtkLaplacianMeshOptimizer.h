// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLaplacianMeshOptimizer
 * @brief   better triangles on the same surface, or a smoother surface with its features
 *
 * Implements "Laplacian Mesh Optimization" (A. Nealen, T. Igarashi, O. Sorkine, M. Alexa, GRAPHITE
 * 2006). All points move at once, to the solution of one weighted least-squares system (Eqn. 11):
 *
 *     minimise |W_L (L V' - f)|^2 + |W_p (V' - V)|^2
 *
 * L is a discrete Laplacian, f the Laplacians that the new points V' should have, and the diagonal
 * matrices W_L and W_p say how much each Laplacian and each position counts. Points, cells and
 * their order stay; only the coordinates change.
 *
 * - Mode OPTIMIZE_TRIANGLES makes the triangles well shaped and keeps the surface (section 5).
 * - Mode SMOOTH removes noise (section 6).
 * - Mode PRESCRIBED_LAPLACIANS takes f from a point array.
 * - Mode OPTIMIZE_WITHIN_DEVIATION makes the triangles as good as they can be within an error that
 *   you name, and guarantees that error; no triangles meet that did not meet before.
 * - Mode SMOOTH_GUIDED removes noise from shapes with flat faces and sharp edges.
 *
 * The paper's recommendations: for smooth models PositionWeighting CDF; for CAD models with sharp
 * edges PositionWeighting LINEAR together with LaplacianWeighting LINEAR_COMPLEMENT. The weights
 * are relative to the range of curvature of the mesh: on tessellations whose points all lie on
 * sharp edges use FeatureConstraints.
 *
 * Warnings say, with figures and the remedy, that no point can move, and in all modes but
 * OPTIMIZE_WITHIN_DEVIATION what got worse: the mean radius ratio in OPTIMIZE_TRIANGLES, more than
 * one triangle in a thousand that turned by more than a right angle, more than a tenth of the
 * volume.
 *
 * Input: a vtkPolyData, or any other data set, whose surface is extracted with its data and with
 * the arrays vtkOriginalPointIds and vtkOriginalCellIds: the cells that are a surface, and the
 * outer faces of those that fill a volume. Of the surface, polygons and triangle strips are
 * optimized; vertices and lines pass through and their points do not move unless a polygon uses
 * them too. Quads and larger polygons, which may be concave, have neighbours along their edges
 * only, and cotangents by virtual refinement (Bunge et al. 2020). Distances, normals of triangles,
 * volumes, RobustLaplacian and SMOOTH_GUIDED take the triangles into which the filter cuts them:
 * quads along the diagonal that is inside, the shorter one if both are; larger polygons as
 * vtkPolygon does. Over several processes, what works on pieces is done on these triangles. Points
 * with float coordinates give float coordinates, all others double.
 *
 * The partitions of a vtkPartitionedDataSet are pieces of one surface: ghost cells are ignored, and
 * points of different partitions are one if they have the same global id or, without global ids,
 * the same coordinates at the border of a partition. Different blocks of a composite data set are
 * different surfaces, each with statistics of its own. The output has the structure of the input. A
 * surface in pieces on several processes needs vtkPLaplacianMeshOptimizer, which New() makes if the
 * program has the module VTK::FiltersLaplacianMeshParallel; without it, pieces are an error.
 *
 * Output: the input with new coordinates and with these arrays.
 * - Cell data `RadiusRatio` and `InputRadiusRatio`: 2 r / R of each triangle (Eqn. 12), from 0
 *   (degenerate) to 1 (equilateral); of a polygon with n > 3 corners the minimum over its corners
 *   of 2 |a x b| / ((a^2 + b^2) sin theta_n), clipped to 1, with the edges a and b of the corner
 * and the angle theta_n of the regular polygon (Verdict's Shape for convex quads); of a strip the
 *   minimum over its triangles; -1 for vertices and lines. Means count each cell once.
 * - Point data `RadiusRatio` and `InputRadiusRatio`: minimum over the cells at the point; -1
 *   if there are none. `MeanCurvature`: of the input, 1 / length, never negative.
 *   `PositionWeight`, `LaplacianWeight`: the diagonals of W_p and W_L that the weighting schemes
 *   gave. `Displacement`: new minus old coordinates. With features also `FeatureClass`: 0 smooth, 1
 *   on a feature line, 2 corner; a boundary counts as a line where it slides.
 * - Cell data `SelfIntersecting`, in OPTIMIZE_WITHIN_DEVIATION and with CheckSelfIntersections: 1
 *   for cells that meet others elsewhere than in the points and the edge that they share, else 0.
 * - Field data, one value each: the metrics that the Get methods below return, under their names.
 * An array of the input that has one of these names is kept, and the result is then named
 * <name>Optimized; only results of the filters of this module are replaced by new ones.
 *
 * @sa vtkMeshLaplacian vtkTriangleRadiusRatio vtkSurfaceDeviation vtkWindowedSincPolyDataFilter
 */
#ifndef vtkLaplacianMeshOptimizer_h
#define vtkLaplacianMeshOptimizer_h

#include "vtkFiltersLaplacianMeshModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

class vtkDataSet;
class vtkSelection;

class VTKFILTERSLAPLACIANMESH_EXPORT vtkLaplacianMeshOptimizer : public vtkPolyDataAlgorithm
{
public:
  static vtkLaplacianMeshOptimizer* New();
  vtkTypeMacro(vtkLaplacianMeshOptimizer, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Makes an output of the type of the input.
  vtkTypeBool ProcessRequest(
    vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  enum ModeType
  {
    OPTIMIZE_TRIANGLES = 0,
    SMOOTH = 1,
    PRESCRIBED_LAPLACIANS = 2,
    OPTIMIZE_WITHIN_DEVIATION = 3,
    SMOOTH_GUIDED = 4
  };

  enum LaplacianTypeType
  {
    UNIFORM = 0,
    COTANGENT = 1,
    MEAN_CURVATURE = 2
  };

  /**
   * CONSTANT and ARRAY have the same value in both weightings.
   */
  enum PositionWeightingType
  {
    CONSTANT = 0,
    LINEAR = 1,
    CDF = 2,
    ANCHORS = 3,
    ARRAY = 4
  };

  enum LaplacianWeightingType
  {
    LINEAR_COMPLEMENT = 1,
    CDF_COMPLEMENT = 2,
    GAUSSIAN = 3
  };

  enum BoundaryConditionType
  {
    FIXED = 0,
    SLIDING = 1,
    FREE = 2,
    CURVE = 3
  };

  enum SelectionUseType
  {
    SELECTED_POINTS_STAY = 0,
    ONLY_SELECTED_POINTS_MOVE = 1
  };

  enum SolverTypeType
  {
    AUTOMATIC = 0,
    DIRECT = 1,
    ITERATIVE = 2
  };

  /**
   * Input arrays for SetInputArrayToProcess(), of any numeric type; point arrays but for the last.
   */
  enum InputArrayIndex
  {
    POSITION_WEIGHT_ARRAY = 0,      ///< 1 component, 0 to 1e40: PositionWeighting ARRAY, ANCHORS
    LAPLACIAN_WEIGHT_ARRAY = 1,     ///< 1 component, 0 to 1e40: LaplacianWeighting ARRAY
    PRESCRIBED_LAPLACIAN_ARRAY = 2, ///< 3 components, up to 1e70: PRESCRIBED_LAPLACIANS
    FIXED_POINT_ARRAY = 3, ///< 1 component, optional: points with a value other than 0 do not move
    FEATURE_ARRAY = 4      ///< optional: 1 component at points, 1 or 2 at cells, which are labels
  };

  ///@{
  /**
   * What to do. OPTIMIZE_TRIANGLES (0): L = L_u and f = delta_c, the cotangent Laplacians of the
   * input (section 5; Eqn. 10 with PositionWeighting ANCHORS). SMOOTH (1): f = 0 (section 6; Eqn. 9
   * with ANCHORS). PRESCRIBED_LAPLACIANS (2): f from PRESCRIBED_LAPLACIAN_ARRAY.
   * OPTIMIZE_WITHIN_DEVIATION (3): passes with L = L_u and f = n n^T L_u V, in which each point
   * stays in its tangent plane; after each pass the displacements that exceed MaximumDeviation or
   * damage a triangle are reduced. The mode has weights of its own. The smallest radius ratio does
   * not fall, and no additional triangle is inverted or folded. If you abort the filter, the output
   * is the best mesh found so far. SMOOTH_GUIDED (4): smooths lightly, then filters the normals of
   * the triangles and lets the triangles follow them, three times; it has weights of its own.
   * Closed components that would lose more than a twentieth of their volume, since their triangles
   * are as large as their shape, do not move, and a warning counts them. Only
   * OPTIMIZE_WITHIN_DEVIATION guarantees how close the surface stays.
   * Default: OPTIMIZE_WITHIN_DEVIATION.
   */
  vtkSetMacro(Mode, int);
  vtkGetMacro(Mode, int);
  ///@}

  ///@{
  /**
   * L of the modes SMOOTH and PRESCRIBED_LAPLACIANS. UNIFORM (0): L_u, Eqn. 3, evens out the
   * triangles as well. COTANGENT (1): L_c, Eqn. 4, leaves their shapes. MEAN_CURVATURE (2): L_ck,
   * Eqn. 7, weights the rows by 1 / area; it is multiplied by the median of 4A / sum of cotangents,
   * so that the result does not depend on the unit of length. Prescribed Laplacians are those that
   * vtkMeshLaplacian computes: UniformLaplacian, CotangentLaplacian or MeanCurvatureNormal, the
   * last in 1 / length; those of the input itself move nothing. Default: UNIFORM.
   */
  vtkSetMacro(LaplacianType, int);
  vtkGetMacro(LaplacianType, int);
  ///@}

  ///@{
  /**
   * Whether the cotangent weights of L_c, L_ck and delta_c are those of the intrinsic Delaunay
   * triangulation of the surface (Sharp and Crane 2020), which are never negative, instead of those
   * of Eqn. 4. For meshes with slivers, obtuse or degenerate triangles and edges of three and more
   * triangles; elsewhere it changes little and costs time. Default: off.
   */
  vtkSetMacro(RobustLaplacian, vtkTypeBool);
  vtkGetMacro(RobustLaplacian, vtkTypeBool);
  vtkBooleanMacro(RobustLaplacian, vtkTypeBool);
  ///@}

  ///@{
  /**
   * How strongly each point is attracted to its input position: the diagonal of W_p (section 5).
   * CONSTANT (0): s. LINEAR (1): from 0 at the least to s at the largest mean curvature, outliers
   * clamped by a box-plot test; for CAD models. CDF (2): s times the share of points with at most
   * the same mean curvature, Eqn. 13; for smooth models. ANCHORS (3): s where POSITION_WEIGHT_ARRAY
   * is not 0, else 0. ARRAY (4): the values of POSITION_WEIGHT_ARRAY. A connected component that
   * neither a positive weight nor a fixed point holds gets the weight s. Default: CDF.
   */
  vtkSetMacro(PositionWeighting, int);
  vtkGetMacro(PositionWeighting, int);
  ///@}

  ///@{
  /**
   * The factor s of PositionWeighting; no unit. A larger value keeps the points closer to where
   * they were: for smoothing 1 is a slight, 0.1 a medium and 0.01 a strong effect.
   * Range: > 0, from 1e-40 to 1e40. Default: 1.
   */
  vtkSetMacro(ScaleFactor, double);
  vtkGetMacro(ScaleFactor, double);
  ///@}

  ///@{
  /**
   * How strongly each Laplacian is imposed: the diagonal of W_L. Low values at high curvature keep
   * features. CONSTANT (0): 1. LINEAR_COMPLEMENT (1): (s - W_linear) / s, section 5.3.
   * CDF_COMPLEMENT (2): 1 - C, with C of Eqn. 13. GAUSSIAN (3): exp(-k^2 / 2 sigma^2) of the mean
   * curvature k. ARRAY (4): the values of LAPLACIAN_WEIGHT_ARRAY. Default: CONSTANT.
   */
  vtkSetMacro(LaplacianWeighting, int);
  vtkGetMacro(LaplacianWeighting, int);
  ///@}

  ///@{
  /**
   * sigma of LaplacianWeighting GAUSSIAN as a multiple of the box-plot threshold of the mean
   * curvature, above which a value counts as an outlier. Range: > 0. Default: 0.5.
   */
  vtkSetMacro(GaussianWidth, double);
  vtkGetMacro(GaussianWidth, double);
  ///@}

  ///@{
  /**
   * Multiply the position weight of each point by the least radius ratio of its triangles, so that
   * bad triangles may move more (section 5.2). Default: off.
   */
  vtkSetMacro(ModulateByTriangleQuality, vtkTypeBool);
  vtkGetMacro(ModulateByTriangleQuality, vtkTypeBool);
  vtkBooleanMacro(ModulateByTriangleQuality, vtkTypeBool);
  ///@}

  ///@{
  /**
   * Also penalise displacements along the normal of each point (Eqns. 14 and 15), which keeps the
   * points closer to the surface. x, y and z then form one coupled system. Default: off.
   */
  vtkSetMacro(TangentPlaneConstraints, vtkTypeBool);
  vtkGetMacro(TangentPlaneConstraints, vtkTypeBool);
  vtkBooleanMacro(TangentPlaneConstraints, vtkTypeBool);
  ///@}

  ///@{
  /**
   * Weight of the rows of Eqn. 15; no unit. Range: 0 to 1e40. Default: 1.
   */
  vtkSetMacro(TangentPlaneWeight, double);
  vtkGetMacro(TangentPlaneWeight, double);
  ///@}

  ///@{
  /**
   * What the points on edges of exactly one triangle do. FIXED (0): they do not move and have no
   * Laplacian row; neighbouring pieces of a cut surface still match. SLIDING (1): they move along
   * the boundary curve, its ends, junctions and turns above 60 degrees stay. FREE (2): as inner
   * points. CURVE (3), in the modes that smooth: the boundary is smoothed as a curve of its own, in
   * all directions and before the surface, with the same weights; a boundary in a plane stays in
   * it, and ends, junctions and turns above 60 degrees stay. In the other modes CURVE acts as
   * SLIDING. Default: FIXED.
   */
  vtkSetMacro(BoundaryCondition, int);
  vtkGetMacro(BoundaryCondition, int);
  ///@}

  ///@{
  /**
   * Optional selection of points or cells on port 1, as the user makes it in a view; a cell stands
   * for its points. SelectionUse sets what happens to them. Points that FIXED_POINT_ARRAY or
   * BoundaryCondition fixes do not move in either case. Of a composite data set, each block or
   * partition reads the nodes of its COMPOSITE_INDEX. Selections that are queries, name blocks in
   * another way, or mix points and cells are errors.
   */
  void SetSelectionConnection(vtkAlgorithmOutput* selection);
  void SetSelectionData(vtkSelection* selection);
  ///@}

  ///@{
  /**
   * Optional surface on port 2 that OPTIMIZE_WITHIN_DEVIATION stays near, in the place of the
   * input: the surface that the input was made from by remeshing, or by earlier runs, whose errors
   * add up otherwise. Of a composite data set, all blocks are the reference. Its triangles should
   * face the same side as those of the input. What begins farther away than MaximumDeviation does
   * not move farther away; a warning counts these triangles. An input with the triangles of the
   * Reference is an earlier result: its features are those of the Reference, and it stays as it is
   * if a pass would gain less than a twentieth of what its mean radius ratio lacks to 1. With
   * InterpolatePointData the output gets the point data and field data that the reference has and
   * the input has not. Other modes do not use it. Without triangles it is an error.
   */
  void SetReferenceConnection(vtkAlgorithmOutput* reference);
  void SetReferenceData(vtkDataObject* reference);
  ///@}

  ///@{
  /**
   * SELECTED_POINTS_STAY (0): the selected points do not move. ONLY_SELECTED_POINTS_MOVE (1): all
   * others do not. Without a selection on port 1 this has no effect. Default: SELECTED_POINTS_STAY.
   */
  vtkSetMacro(SelectionUse, int);
  vtkGetMacro(SelectionUse, int);
  ///@}

  ///@{
  /**
   * DIRECT (1): factorise the normal equations; an error if they are singular or if points have
   * thousands of neighbours. ITERATIVE (2): conjugate gradients without forming
   * them; with strong smoothing or very thin triangles they switch to a multigrid preconditioner or
   * to a factorisation of a smaller matrix. AUTOMATIC (0): iterative, and direct if that does not
   * reach the tolerance. Default: AUTOMATIC.
   */
  vtkSetMacro(SolverType, int);
  vtkGetMacro(SolverType, int);
  ///@}

  ///@{
  /**
   * Residual |b - A d| / |b| of the normal equations for the displacement d at which the iteration
   * stops. 1e-6 leaves the points within about 1e-5 of the bounding-box diagonal of the exact
   * solution, mostly much closer. Range: between 0 and 1. Default: 1e-6.
   */
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /**
   * Iterations after which the iterative solver gives up: AUTOMATIC then solves directly, ITERATIVE
   * keeps the best it has and warns with the residual. Range: > 0. Default: 5000.
   */
  vtkSetMacro(MaximumNumberOfIterations, int);
  vtkGetMacro(MaximumNumberOfIterations, int);
  ///@}

  ///@{
  /**
   * For OPTIMIZE_WITHIN_DEVIATION: the largest distance allowed between the surfaces before and
   * after, every point of either to the other (Hausdorff), divided by the diagonal of the input's
   * bounding box; with a Reference, between that and the surface after. Range: more than 0, up to
   * 1; with DeviationIsAbsolute, more than 0. Default: 0.002.
   */
  vtkSetMacro(MaximumDeviation, double);
  vtkGetMacro(MaximumDeviation, double);
  ///@}

  ///@{
  /**
   * MaximumDeviation is a length in the unit of the points, not a fraction. Default: off.
   */
  vtkSetMacro(DeviationIsAbsolute, vtkTypeBool);
  vtkGetMacro(DeviationIsAbsolute, vtkTypeBool);
  vtkBooleanMacro(DeviationIsAbsolute, vtkTypeBool);
  ///@}

  ///@{
  /**
   * For OPTIMIZE_WITHIN_DEVIATION: the largest number of passes; it stops earlier when they gain
   * nothing. 3 is fast. At least 1. Default: 5.
   */
  vtkSetMacro(NumberOfPasses, int);
  vtkGetMacro(NumberOfPasses, int);
  ///@}

  ///@{
  /**
   * For OPTIMIZE_WITHIN_DEVIATION: after the passes move single points where that raises the radius
   * ratio of triangles that have less than 0.45, and then of the worst ones as long as the minimum
   * rises. The mean may fall by 0.002. The effort is limited to a few times that of the passes.
   * Default: on.
   */
  vtkSetMacro(ImproveWorstTriangles, vtkTypeBool);
  vtkGetMacro(ImproveWorstTriangles, vtkTypeBool);
  vtkBooleanMacro(ImproveWorstTriangles, vtkTypeBool);
  ///@}

  ///@{
  /**
   * For OPTIMIZE_TRIANGLES and SMOOTH: corners of features stay, points on feature lines slide
   * along them. OPTIMIZE_WITHIN_DEVIATION does so always. Features come from FEATURE_ARRAY if it is
   * chosen: point data, edges whose ends both are not 0; or cell data, edges between cells with
   * different labels. Otherwise DetectFeatures finds them. Default: off.
   */
  vtkSetMacro(FeatureConstraints, vtkTypeBool);
  vtkGetMacro(FeatureConstraints, vtkTypeBool);
  vtkBooleanMacro(FeatureConstraints, vtkTypeBool);
  ///@}

  ///@{
  /**
   * Find features where no FEATURE_ARRAY is chosen: lines at which the surface turns by more than
   * FeatureAngle; if they end inside the surface, of at least 10 edges. Default: on.
   */
  vtkSetMacro(DetectFeatures, vtkTypeBool);
  vtkGetMacro(DetectFeatures, vtkTypeBool);
  vtkBooleanMacro(DetectFeatures, vtkTypeBool);
  ///@}

  ///@{
  /**
   * The angle between the normals of two triangles above which their edge may belong to a feature,
   * in degrees, 0 to 180. Default: 40.
   */
  vtkSetMacro(FeatureAngle, double);
  vtkGetMacro(FeatureAngle, double);
  ///@}

  ///@{
  /**
   * For SMOOTH_GUIDED: iterations of the filter of normals, 0 or more; 20 for strong noise. Each
   * of the three filters takes half of them. Default: 10.
   */
  vtkSetMacro(NormalIterations, int);
  vtkGetMacro(NormalIterations, int);
  ///@}

  ///@{
  /**
   * For SMOOTH_GUIDED: the difference of two unit normals beyond which they no longer influence
   * each other; 0.4 times that in the second and third filter. More than 0. Larger values round off
   * blunt edges. Default: 0.25.
   */
  vtkSetMacro(NormalWidth, double);
  vtkGetMacro(NormalWidth, double);
  ///@}

  ///@{
  /**
   * For SMOOTH_GUIDED: how strongly points are attracted to their input positions. More than 0.
   * Default: 0.3.
   */
  vtkSetMacro(DetailWeight, double);
  vtkGetMacro(DetailWeight, double);
  ///@}

  ///@{
  /**
   * For SMOOTH and SMOOTH_GUIDED: give each closed component the volume that it had, by an offset
   * along the normals of its points. Points that are fixed or slide are not offset. If
   * FEATURE_ARRAY is cell data, each label keeps its volume: with one component, the cells of a
   * label if they are closed; with two, the regions on both sides of each cell, as vtkSurfaceNets3D
   * writes them. A warning counts the volumes that cannot be preserved. Default: off.
   */
  vtkSetMacro(PreserveVolume, vtkTypeBool);
  vtkGetMacro(PreserveVolume, vtkTypeBool);
  vtkBooleanMacro(PreserveVolume, vtkTypeBool);
  ///@}

  ///@{
  /**
   * For SMOOTH: apply the same smoothing to what it removed, and add the result: less than half the
   * shrinkage at the same ScaleFactor (S (2 I - S) instead of S; Tukey 1977). Default: off.
   */
  vtkSetMacro(Twicing, vtkTypeBool);
  vtkGetMacro(Twicing, vtkTypeBool);
  vtkBooleanMacro(Twicing, vtkTypeBool);
  ///@}

  ///@{
  /**
   * For SMOOTH: smooth feature lines as curves of their own, in all directions and before the
   * surface, with the same weights: lines that FeatureConstraints finds, which this switches on,
   * and edges of three and more polygons, as between labels. Their ends, junctions and turns above
   * 60 degrees stay. Off: points slide along the lines, whose shape stays. Default: off.
   */
  vtkSetMacro(FeatureSmoothing, vtkTypeBool);
  vtkGetMacro(FeatureSmoothing, vtkTypeBool);
  vtkBooleanMacro(FeatureSmoothing, vtkTypeBool);
  ///@}

  ///@{
  /**
   * Which coordinates may change: for each of x, y and z 1 if it may, 0 if it stays exactly as it
   * is. Height fields keep x and y with (0, 0, 1), a part of a symmetric body its plane with (1, 1,
   * 0). Points on feature lines and sliding boundaries move only where their line keeps these
   * coordinates. Default: (1, 1, 1).
   */
  vtkSetVector3Macro(FreeAxes, int);
  vtkGetVector3Macro(FreeAxes, int);
  ///@}

  ///@{
  /**
   * Recompute the point and cell normals that the input has: area-weighted at points, in the
   * direction in which the cells are counter-clockwise. Off: the input's normals pass through.
   * Default: on.
   */
  vtkSetMacro(ComputeNormals, vtkTypeBool);
  vtkGetMacro(ComputeNormals, vtkTypeBool);
  vtkBooleanMacro(ComputeNormals, vtkTypeBool);
  ///@}

  ///@{
  /**
   * For OPTIMIZE_WITHIN_DEVIATION and OPTIMIZE_TRIANGLES, where points slide along the surface:
   * each point takes the point data of the place of the input that is closest to its new position,
   * found from the triangles at the point. Floating-point arrays and colours (three or four
   * unsigned chars) are interpolated in the triangle there and stay within the range around it;
   * the point normals are interpolated too, with unit length, instead of computed anew.
   * Other arrays take the values of the nearest corner. Global, pedigree and original ids and ghost
   * flags stay with the point, and cell data with their cells. Off: all point data stay with their
   * points, and fields are displaced with them. On several processes, strings stay with their
   * points in either case, and so do arrays with several values at one place, of which a warning
   * tells. Default: on.
   */
  vtkSetMacro(InterpolatePointData, vtkTypeBool);
  vtkGetMacro(InterpolatePointData, vtkTypeBool);
  vtkBooleanMacro(InterpolatePointData, vtkTypeBool);
  ///@}

  ///@{
  /**
   * Points on the boundary that have exactly the same coordinates are one vertex: a soup of
   * triangles, as STL and OBJ files hold it, and the sides of a seam of texture coordinates are
   * connected there and stay together. A vertex is fixed if one of its points is, and takes
   * other point arrays that the properties choose from the first of its points. The output keeps
   * all points, their ids and their data. Points inside a surface are not compared, so that closed
   * surfaces that touch stay apart. Default: on.
   */
  vtkSetMacro(WeldCoincidentPoints, vtkTypeBool);
  vtkGetMacro(WeldCoincidentPoints, vtkTypeBool);
  vtkBooleanMacro(WeldCoincidentPoints, vtkTypeBool);
  ///@}

  ///@{
  /**
   * Search for pairs of triangles that meet elsewhere than in the points and the edge that they
   * share, before and after, and warns if new ones appear: field data InputSelfIntersections and
   * SelfIntersections, and the cell array SelfIntersecting. OPTIMIZE_WITHIN_DEVIATION does so
   * always and prevents new ones. Default: off.
   */
  vtkSetMacro(CheckSelfIntersections, vtkTypeBool);
  vtkGetMacro(CheckSelfIntersections, vtkTypeBool);
  vtkBooleanMacro(CheckSelfIntersections, vtkTypeBool);
  ///@}

  ///@{
  /**
   * Attach the arrays that only explain the result: MeanCurvature, PositionWeight, LaplacianWeight,
   * Displacement and InputRadiusRatio. Default: on.
   */
  vtkSetMacro(DiagnosticArrays, vtkTypeBool);
  vtkGetMacro(DiagnosticArrays, vtkTypeBool);
  vtkBooleanMacro(DiagnosticArrays, vtkTypeBool);
  ///@}

  ///@{
  /**
   * For OPTIMIZE_WITHIN_DEVIATION of a surface that deforms over time, with the same polygons:
   * start from the previous execution's result, moved as the surface has moved since, so that
   * points move as smoothly as those of the input. That is the result as long as it keeps half of
   * what the last passes gained in mean radius ratio; otherwise new passes follow, and points jump.
   * The distance is guaranteed as ever. The result depends on the steps before, which must be
   * executed in order. Default: off.
   */
  vtkSetMacro(StartFromPreviousTimeStep, vtkTypeBool);
  vtkGetMacro(StartFromPreviousTimeStep, vtkTypeBool);
  vtkBooleanMacro(StartFromPreviousTimeStep, vtkTypeBool);
  ///@}

  ///@{
  /**
   * Mean and minimum of the triangles' radius ratios after and before, 0 to 1; -1 if there are no
   * triangles. Like all metrics below, these are valid after Update(), and are those of all
   * surfaces of a composite data set: means of all triangles, sums, and values of largest
   * magnitude. They are -1 or 0 when the output is out of date.
   */
  vtkGetMacro(MeanRadiusRatio, double);
  vtkGetMacro(MinimumRadiusRatio, double);
  vtkGetMacro(InputMeanRadiusRatio, double);
  vtkGetMacro(InputMinimumRadiusRatio, double);
  ///@}

  ///@{
  /**
   * Length of the longest displacement, in the unit of the mesh and divided by the diagonal of the
   * bounding box. Every point of the new surface is within this distance of the old one.
   */
  vtkGetMacro(MaximumDisplacement, double);
  vtkGetMacro(RelativeMaximumDisplacement, double);
  ///@}

  /**
   * (new volume - old volume) / |old volume| of a closed surface; 0 if the surface is open, which
   * has no volume.
   */
  vtkGetMacro(RelativeVolumeChange, double);

  /**
   * 1 if the surface, or one of the blocks, is closed and thus has a RelativeVolumeChange; else 0.
   */
  int HasVolume() const { return this->IsClosed; }

  /**
   * Number of triangles whose normal turned by more than a right angle.
   */
  vtkGetMacro(FlippedTriangles, vtkIdType);

  /**
   * Iterations of the iterative solver; 0 if the system was solved directly from the start.
   */
  vtkGetMacro(Iterations, int);

  /**
   * |b - A d| / |b| of the solution, computed from the equations.
   */
  vtkGetMacro(RelativeResidual, double);

  ///@{
  /**
   * For OPTIMIZE_WITHIN_DEVIATION: guaranteed upper bound of the Hausdorff distance between input,
   * or Reference, and output, as a length and divided by the diagonal of the input's bounding box.
   * Zero in all other modes, like the three metrics that follow.
   */
  vtkGetMacro(HausdorffBound, double);
  vtkGetMacro(RelativeHausdorffBound, double);
  ///@}

  /**
   * Passes that moved the surface.
   */
  vtkGetMacro(Passes, int);

  /**
   * Number of points that the last pass moved less than its equations asked for.
   */
  vtkGetMacro(RolledBackPoints, vtkIdType);

  /**
   * Number of triangles, or triangles of polygons, with a quality below 0.45 of which no corner may
   * move: what only remeshing can improve.
   */
  vtkGetMacro(PinnedBadTriangles, vtkIdType);

  ///@{
  /**
   * Number of pairs of triangles that meet elsewhere than in the points and the edge that they
   * share, before and after; see CheckSelfIntersections. Pairs that are closer than round-off
   * count. Pairs of triangles that both have a point of more than 100 triangles are not examined.
   * 0 if pairs were not searched for.
   */
  vtkGetMacro(InputSelfIntersections, vtkIdType);
  vtkGetMacro(SelfIntersections, vtkIdType);
  ///@}

  /**
   * Executes the filter if it has executed before and its output is out of date. ParaView reads the
   * metrics before it executes the filter: it calls this first, so that they are those of the
   * properties that were applied.
   * \return 1 if the metrics are up to date; 0 before the first execution and over several
   * processes
   */
  virtual int UpdateMetrics();

  /**
   * MaximumDeviation as a length in the unit of the points, for the input as it is now; the largest
   * if the input has several blocks, and -1 if there is no input.
   */
  double GetDeviationLength();

protected:
  vtkLaplacianMeshOptimizer();
  ~vtkLaplacianMeshOptimizer() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  /// What executes the filter and keeps state between executions, made before the first one.
  class Session;
  virtual std::unique_ptr<Session> MakeSession();

  /// The tables of properties and metrics.
  struct Tables;

  int Mode = OPTIMIZE_WITHIN_DEVIATION;
  int LaplacianType = UNIFORM;
  vtkTypeBool RobustLaplacian = 0;
  int PositionWeighting = CDF;
  double ScaleFactor = 1;
  int LaplacianWeighting = CONSTANT;
  double GaussianWidth = 0.5;
  vtkTypeBool ModulateByTriangleQuality = 0;
  vtkTypeBool TangentPlaneConstraints = 0;
  double TangentPlaneWeight = 1;
  int BoundaryCondition = FIXED;
  int SelectionUse = SELECTED_POINTS_STAY;
  int SolverType = AUTOMATIC;
  double Tolerance = 1e-6;
  int MaximumNumberOfIterations = 5000;
  double MaximumDeviation = 0.002;
  vtkTypeBool DeviationIsAbsolute = 0;
  int NumberOfPasses = 5;
  vtkTypeBool ImproveWorstTriangles = 1;
  vtkTypeBool FeatureConstraints = 0;
  vtkTypeBool DetectFeatures = 1;
  double FeatureAngle = 40;
  int NormalIterations = 10;
  double NormalWidth = 0.25;
  double DetailWeight = 0.3;
  vtkTypeBool PreserveVolume = 0;
  vtkTypeBool Twicing = 0;
  vtkTypeBool FeatureSmoothing = 0;
  int FreeAxes[3] = { 1, 1, 1 };
  vtkTypeBool ComputeNormals = 1;
  vtkTypeBool InterpolatePointData = 1;
  vtkTypeBool WeldCoincidentPoints = 1;
  vtkTypeBool CheckSelfIntersections = 0;
  vtkTypeBool DiagnosticArrays = 1;
  vtkTypeBool StartFromPreviousTimeStep = 0;

  double MeanRadiusRatio = -1;
  double MinimumRadiusRatio = -1;
  double InputMeanRadiusRatio = -1;
  double InputMinimumRadiusRatio = -1;
  double MaximumDisplacement = 0;
  double RelativeMaximumDisplacement = 0;
  double RelativeVolumeChange = 0;
  bool IsClosed = false;
  vtkIdType FlippedTriangles = 0;
  int Iterations = 0;
  double RelativeResidual = 0;
  double HausdorffBound = 0;
  double RelativeHausdorffBound = 0;
  int Passes = 0;
  vtkIdType RolledBackPoints = 0;
  vtkIdType PinnedBadTriangles = 0;
  vtkIdType InputSelfIntersections = 0;
  vtkIdType SelfIntersections = 0;

private:
  vtkLaplacianMeshOptimizer(const vtkLaplacianMeshOptimizer&) = delete;
  void operator=(const vtkLaplacianMeshOptimizer&) = delete;

  std::unique_ptr<Session> State;
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
#endif
