// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_OptimizerOptions_h
#define lmo_OptimizerOptions_h

#include "Core/Operators/MeshQuantities.h"
#include "Core/Solvers/SolverOptions.h"

#include <memory>
#include <optional>

namespace lmo
{
/// Section 4: what L and f are.
enum class Mode
{
  OPTIMIZE_TRIANGLES,        ///< L = L_u, f = delta_c (section 5)
  SMOOTH,                    ///< f = 0 (section 6)
  PRESCRIBED_LAPLACIANS,     ///< f from the user
  OPTIMIZE_WITHIN_DEVIATION, ///< passes of the first, within an error
  SMOOTH_GUIDED              ///< the triangles follow filtered normals
};

enum class PositionWeighting
{
  CONSTANT,
  LINEAR,
  CDF,
  ANCHORS,
  ARRAY
};

enum class LaplacianWeighting
{
  CONSTANT,
  LINEAR_COMPLEMENT,
  CDF_COMPLEMENT,
  GAUSSIAN,
  ARRAY
};

enum class BoundaryCondition
{
  FIXED,   ///< no displacement, no Laplacian row
  SLIDING, ///< along the boundary curve, with a Laplacian row of the curve
  FREE,    ///< as inner vertices
  CURVE    ///< smoothed as a curve of its own where the mode smooths, otherwise SLIDING
};

/// Mode::OPTIMIZE_WITHIN_DEVIATION.
struct DeviationOptions
{
  double maximum = 0.002;  ///< two-sided Hausdorff distance, divided by the bounding-box diagonal
  bool isAbsolute = false; ///< the maximum is a length, not divided
  int passes = 5;
  bool improveWorstTriangles = true;
};

/// Mode::SMOOTH_GUIDED.
struct GuideOptions
{
  int normalIterations = 10;
  double normalWidth = 0.25;
  double detailWeight = 0.3;
};

/// The properties of vtkLaplacianMeshOptimizer; see there for meaning and ranges.
struct OptimizerOptions
{
  Mode mode = Mode::OPTIMIZE_WITHIN_DEVIATION;
  LaplacianType laplacianType = LaplacianType::UNIFORM;
  bool robustLaplacian = false;
  PositionWeighting positionWeighting = PositionWeighting::CDF;
  double scaleFactor = 1;
  LaplacianWeighting laplacianWeighting = LaplacianWeighting::CONSTANT;
  double gaussianWidth = 0.5;
  bool modulateByTriangleQuality = false;
  bool tangentPlaneConstraints = false;
  double tangentPlaneWeight = 1;
  BoundaryCondition boundaryCondition = BoundaryCondition::FIXED;
  SolverType solverType = SolverType::AUTOMATIC;
  SolverOptions solver;
  DeviationOptions deviation;
  GuideOptions guide;
  bool featureConstraints = false;
  bool detectFeatures = true;
  double featureAngle = 40;           ///< degrees
  bool featureSmoothing = false;      ///< feature lines are smoothed as curves of their own
  Vector3 freeAxes = Vector3::Ones(); ///< 1 for each of x, y and z that may change, else 0
  bool preserveVolume = false;
  bool twicing = false;
  bool checkSelfIntersections = false; ///< in modes that do not prevent them
  bool computeNormals = false;         ///< fill OptimizerResult::normals
  bool roundToFloat = false;           ///< round V' as the caller will, so that all metrics fit it
};

/// A mesh with the same triangles at an earlier time.
struct EarlierStep
{
  Points before;
  Points after;    ///< what OPTIMIZE_WITHIN_DEVIATION has made of it
  double gain = 0; ///< of t_mean when passes optimised it last
  Triangles triangles;
};

/// What the user may give beside the mesh: values for each vertex and each triangle, and a surface.
struct VertexArrays
{
  std::optional<Vector> positionWeights;           ///< W_p or anchors, from 0 to LargestWeight
  std::optional<Vector> laplacianWeights;          ///< W_L, from 0 to LargestWeight
  std::optional<Points> prescribedLaplacians;      ///< f
  std::optional<Vector> fixedPoints;               ///< not 0: does not move
  std::optional<Vector> featurePoints;             ///< not 0: on a feature line or corner
  std::optional<TriangleLabels> labels;            ///< feature lines are between different ones
  std::shared_ptr<const MeshQuantities> reference; ///< to stay near; null: the mesh as it is
  std::shared_ptr<const EarlierStep> earlier;      ///< to start from; null: from the mesh as it is
};
}

#endif
