// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OptimizerTables_h
#define OptimizerTables_h

#include "Core/Operators/Weights.h"
#include "Core/Optimizer/Optimizer.h"

#include "OptimizerSession.h"

#include "vtkLaplacianMeshOptimizer.h"

#include <limits>

namespace lmo
{
/// The values of a property that is on or off.
struct Switch
{
};

/// The values of an enumeration: 0 to \a last.
struct Choices
{
  int last;
};

/// The values of a number and their description for error messages.
struct Range
{
  const char* text;
  double least;
  double largest = std::numeric_limits<double>::max();
};

constexpr double AboveZero = std::numeric_limits<double>::denorm_min();
constexpr double BelowOne = 1 - std::numeric_limits<double>::epsilon() / 2;
}

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

/// The tables of properties and metrics, one row each, in the order of their declarations.
struct vtkLaplacianMeshOptimizer::Tables
{
  /// Calls row() with the name of each property, its value, its valid values, and its option if
  /// ReadOptions() copies it.
  template <typename Filter, typename Options, typename Row>
  static void VisitProperties(Filter& filter, Options& options, const Row& row)
  {
    using namespace lmo;
    const Range positive{ "more than 0", AboveZero };
    const Range scale{ "more than 0, from 1e-40 to 1e40", SmallestScaleFactor, LargestWeight };
    const Range weight{ "0 or more, up to 1e40", 0, LargestWeight };
    const Range positiveWeight{ "more than 0, up to 1e40", AboveZero, LargestWeight };
    const Range fraction{ "between 0 and 1", AboveZero, BelowOne };
    const Range deviation{ "more than 0, up to 1", AboveZero, 1 };
    const Range angle{ "from 0 to 180", 0, 180 };
    const Range count{ "0 or more", 0 };
    row("Mode", filter.Mode, Choices{ SMOOTH_GUIDED }, options.mode);
    row("LaplacianType", filter.LaplacianType, Choices{ MEAN_CURVATURE }, options.laplacianType);
    row("RobustLaplacian", filter.RobustLaplacian, Switch{}, options.robustLaplacian);
    row("PositionWeighting", filter.PositionWeighting, Choices{ ARRAY }, options.positionWeighting);
    row("ScaleFactor", filter.ScaleFactor, scale, options.scaleFactor);
    row("LaplacianWeighting", filter.LaplacianWeighting, Choices{ ARRAY },
      options.laplacianWeighting);
    row("GaussianWidth", filter.GaussianWidth, positive, options.gaussianWidth);
    row("ModulateByTriangleQuality", filter.ModulateByTriangleQuality, Switch{},
      options.modulateByTriangleQuality);
    row("TangentPlaneConstraints", filter.TangentPlaneConstraints, Switch{},
      options.tangentPlaneConstraints);
    row("TangentPlaneWeight", filter.TangentPlaneWeight, weight, options.tangentPlaneWeight);
    row("BoundaryCondition", filter.BoundaryCondition, Choices{ CURVE }, options.boundaryCondition);
    row("SelectionUse", filter.SelectionUse, Choices{ ONLY_SELECTED_POINTS_MOVE });
    row("SolverType", filter.SolverType, Choices{ ITERATIVE }, options.solverType);
    row("Tolerance", filter.Tolerance, fraction, options.solver.tolerance);
    row("MaximumNumberOfIterations", filter.MaximumNumberOfIterations, positive,
      options.solver.maximumIterations);
    row("MaximumDeviation", filter.MaximumDeviation,
      filter.DeviationIsAbsolute ? positive : deviation, options.deviation.maximum);
    row("DeviationIsAbsolute", filter.DeviationIsAbsolute, Switch{}, options.deviation.isAbsolute);
    row("NumberOfPasses", filter.NumberOfPasses, positive, options.deviation.passes);
    row("ImproveWorstTriangles", filter.ImproveWorstTriangles, Switch{},
      options.deviation.improveWorstTriangles);
    row("FeatureConstraints", filter.FeatureConstraints, Switch{}, options.featureConstraints);
    row("DetectFeatures", filter.DetectFeatures, Switch{}, options.detectFeatures);
    row("FeatureAngle", filter.FeatureAngle, angle, options.featureAngle);
    row("NormalIterations", filter.NormalIterations, count, options.guide.normalIterations);
    row("NormalWidth", filter.NormalWidth, positive, options.guide.normalWidth);
    row("DetailWeight", filter.DetailWeight, positiveWeight, options.guide.detailWeight);
    row("PreserveVolume", filter.PreserveVolume, Switch{}, options.preserveVolume);
    row("Twicing", filter.Twicing, Switch{}, options.twicing);
    row("FeatureSmoothing", filter.FeatureSmoothing, Switch{}, options.featureSmoothing);
    row("FreeAxes", filter.FreeAxes[0], Switch{}, options.freeAxes[0]);
    row("FreeAxes", filter.FreeAxes[1], Switch{}, options.freeAxes[1]);
    row("FreeAxes", filter.FreeAxes[2], Switch{}, options.freeAxes[2]);
    row("ComputeNormals", filter.ComputeNormals, Switch{});
    row("InterpolatePointData", filter.InterpolatePointData, Switch{});
    row("WeldCoincidentPoints", filter.WeldCoincidentPoints, Switch{});
    row("CheckSelfIntersections", filter.CheckSelfIntersections, Switch{},
      options.checkSelfIntersections);
    row("DiagnosticArrays", filter.DiagnosticArrays, Switch{});
    row("StartFromPreviousTimeStep", filter.StartFromPreviousTimeStep, Switch{});
  }

  /// Calls row() with the name of each metric, the filter's value and that of a result, how it is
  /// combined over blocks, and whether the field data of the filter's mode have it if that depends
  /// on the mode.
  template <typename Filter, typename Row>
  static void VisitMetrics(Filter& filter, const lmo::OptimizerResult& result, const Row& row)
  {
    const lmo::SurfaceComparison& comparison = result.comparison;
    const lmo::MeshQuality& after = comparison.after;
    const lmo::MeshQuality& before = *comparison.before;
    const lmo::DeviationReport& deviation = result.deviation;
    const bool isWithin = filter.Mode == OPTIMIZE_WITHIN_DEVIATION;
    row("MeanRadiusRatio", filter.MeanRadiusRatio, after.mean, Session::MEAN);
    row("MinimumRadiusRatio", filter.MinimumRadiusRatio, after.minimum, Session::LEAST);
    row("InputMeanRadiusRatio", filter.InputMeanRadiusRatio, before.mean, Session::MEAN);
    row("InputMinimumRadiusRatio", filter.InputMinimumRadiusRatio, before.minimum, Session::LEAST);
    row("MaximumDisplacement", filter.MaximumDisplacement, comparison.maximumDisplacement,
      Session::LARGEST);
    row("RelativeMaximumDisplacement", filter.RelativeMaximumDisplacement,
      comparison.relativeMaximumDisplacement, Session::LARGEST);
    row("RelativeVolumeChange", filter.RelativeVolumeChange, comparison.relativeVolumeChange,
      Session::LARGEST);
    row("FlippedTriangles", filter.FlippedTriangles, comparison.flippedTriangles, Session::SUM);
    row("Iterations", filter.Iterations, result.iterations, Session::SUM);
    row("RelativeResidual", filter.RelativeResidual, result.relativeResidual, Session::LARGEST);
    row("HausdorffBound", filter.HausdorffBound, deviation.bound, Session::LARGEST, isWithin);
    row("RelativeHausdorffBound", filter.RelativeHausdorffBound, deviation.relativeBound,
      Session::LARGEST, isWithin);
    row("Passes", filter.Passes, deviation.passes, Session::LARGEST, isWithin);
    row("RolledBackPoints", filter.RolledBackPoints, deviation.rolledBack, Session::SUM, isWithin);
    row(
      "PinnedBadTriangles", filter.PinnedBadTriangles, deviation.pinnedBad, Session::SUM, isWithin);
    const lmo::IntersectionReport& intersections = result.intersections;
    row("InputSelfIntersections", filter.InputSelfIntersections, intersections.before, Session::SUM,
      intersections.isKnown);
    row("SelfIntersections", filter.SelfIntersections, intersections.after, Session::SUM,
      intersections.isKnown);
  }
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

#endif
