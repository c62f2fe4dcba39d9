// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSurfaceDeviation
 * @brief   distance of a surface to a reference surface, both ways
 *
 * Measures how far the triangles of input port 0 are from those of the reference on port 1 and
 * back, as Metro does (P. Cignoni, C. Rocchini, R. Scopigno, Computer Graphics Forum 1998): at the
 * points of both surfaces and at samples inside their triangles that are distributed evenly over
 * the area. Each distance is that to the closest point of the other surface's triangles, not of its
 * points.
 *
 * Output: the input of port 0 with point array `Distance` (to the reference, in the mesh's unit)
 * and field arrays of one value with the names of the Get methods. If the reference is closed,
 * there is also the point array `SignedDistance`, the same but negative inside the reference, also
 * if its triangles are counter-clockwise seen from inside. The sign is that of the angle-weighted
 * pseudonormal of the closest triangle, edge or point (J. A. Baerentzen, H. Aanaes, IEEE TVCG
 * 2005). Closed means that each edge has exactly two triangles, which run along it in opposite
 * directions; points on boundaries with the same coordinates count as one. Where closed bodies
 * overlap, the sign is that of the one whose surface is closest. Both inputs may hold vertices and
 * lines; polygons and triangle strips count as triangles, cut as vtkLaplacianMeshOptimizer does. A
 * reference without triangles is an error unless the input has none either. Arrays of the input
 * that have these names are kept unless a filter of this module made them; the new ones are then
 * named <name>Optimized, and a warning says so.
 *
 * @sa vtkHausdorffDistancePointSetFilter
 *
 * Inputs that are no vtkPolyData are taken for their surface: the cells that are one, and the outer
 * faces of those that fill a volume. The blocks and partitions of a composite data set are one
 * surface, without their ghost cells: each point has the distance to the closest block of the
 * reference, and the field arrays of each block hold the figures of the whole. The output has the
 * structure of the input.
 */
#ifndef vtkSurfaceDeviation_h
#define vtkSurfaceDeviation_h

#include "vtkFiltersLaplacianMeshModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

class VTKFILTERSLAPLACIANMESH_EXPORT vtkSurfaceDeviation : public vtkPolyDataAlgorithm
{
public:
  static vtkSurfaceDeviation* New();
  vtkTypeMacro(vtkSurfaceDeviation, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  vtkTypeBool ProcessRequest(
    vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  /**
   * The surface on port 1.
   */
  void SetReferenceConnection(vtkAlgorithmOutput* reference);
  void SetReferenceData(vtkDataObject* reference);

  ///@{
  /**
   * Samples on each of the two surfaces, beside their points. Range: > 0. Default: 100000.
   */
  vtkSetMacro(NumberOfSamples, int);
  vtkGetMacro(NumberOfSamples, int);
  ///@}

  ///@{
  /**
   * Largest distance found in either direction: a lower bound of the two-sided Hausdorff distance.
   * In the mesh's unit, and divided by the bounding-box diagonal of the reference. Valid after
   * Update(), as the means; all are -1 before, and after an error.
   */
  vtkGetMacro(HausdorffDistance, double);
  vtkGetMacro(RelativeHausdorffDistance, double);
  ///@}

  ///@{
  /**
   * Average of the two directions' mean distances over the area.
   */
  vtkGetMacro(MeanDistance, double);
  vtkGetMacro(RelativeMeanDistance, double);
  ///@}

  /**
   * Executes the filter if it has executed before and its output is out of date. ParaView reads the
   * distances before it executes the filter: it calls this first, so that they are those of the
   * properties that were applied.
   * \return 1 if the distances are up to date; 0 before the first execution and over several
   * processes
   */
  int UpdateMetrics();

protected:
  vtkSurfaceDeviation();
  ~vtkSurfaceDeviation() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  int NumberOfSamples = 100000;
  double HausdorffDistance = -1;
  double RelativeHausdorffDistance = -1;
  double MeanDistance = -1;
  double RelativeMeanDistance = -1;

private:
  bool HasExecuted = false;

  vtkSurfaceDeviation(const vtkSurfaceDeviation&) = delete;
  void operator=(const vtkSurfaceDeviation&) = delete;

  void Compare(vtkDataObject* input, vtkDataObject* reference, vtkDataObject* output);
  void CompareSurfaces(vtkPolyData* surface, vtkPolyData* reference, vtkPolyData* output);
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
#endif
