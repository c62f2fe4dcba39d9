// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Optimizer/ResultReview.h"

#include "Core/Base/Threading.h"
#include "Core/Optimizer/EnclosedRegions.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace lmo
{
namespace
{
/// Changes that are worth a warning; the mean radius ratio may fall by what the solver's tolerance
/// makes of it.
constexpr double LargestFlippedShare = 1e-3;
constexpr double LargestFall = 1e-4;

/// Triangles with a smaller radius ratio, which goes with the square of the height, have no area as
/// far as single precision can tell.
constexpr double SmallestRatio = 1e-12;

bool HasNoArea(const MeshTopology& topology, const Vector& ratios, Index i)
{
  const AdjacencyLists& corners = topology.cornersAt;
  return std::all_of(corners.Begin(i), corners.End(i),
    [&](Index corner) { return ratios[corner / 3] < SmallestRatio; });
}

/// "1 point does", "2 points do".
std::string Counted(std::int64_t count, const char* one, const char* many)
{
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

std::string Percent(double share)
{
  const double percent = 100 * share;
  std::ostringstream text;
  text.precision(2);
  std::abs(percent) < 10 ? text << percent : text << static_cast<int>(std::round(percent));
  return text.str() + " %";
}

/// What the user can change about the strength of a mode.
const char* StrengthRemedy(const OptimizerOptions& options)
{
  switch (options.mode)
  {
    case Mode::OPTIMIZE_TRIANGLES:
      return options.featureConstraints
               ? "Choose Mode OPTIMIZE_WITHIN_DEVIATION, or raise ScaleFactor."
               : "Choose Mode OPTIMIZE_WITHIN_DEVIATION, switch FeatureConstraints on, or raise "
                 "ScaleFactor.";
    case Mode::SMOOTH_GUIDED:
      return "Raise DetailWeight.";
    case Mode::PRESCRIBED_LAPLACIANS:
      return "Raise ScaleFactor, or prescribe smaller changes.";
    default:
      return "Raise ScaleFactor.";
  }
}

void WarnOfQuality(const OptimizerOptions& options, const SurfaceComparison& comparison,
  std::vector<std::string>& warnings)
{
  const double before = comparison.before->mean;
  const double after = comparison.after.mean;
  if (options.mode == Mode::OPTIMIZE_TRIANGLES && before - after > LargestFall)
  {
    std::ostringstream text;
    text.precision(4);
    text << "The mean radius ratio fell from " << before << " to " << after
         << ": the triangles are worse than before. " << StrengthRemedy(options);
    warnings.push_back(text.str());
  }
}

void WarnOfFlips(const OptimizerOptions& options, const SurfaceComparison& comparison,
  std::vector<std::string>& warnings)
{
  const double share = double(comparison.flippedTriangles) / double(comparison.triangles);
  if (share > LargestFlippedShare)
  {
    const bool smooths = options.mode == Mode::SMOOTH || options.mode == Mode::SMOOTH_GUIDED;
    warnings.push_back(
      std::to_string(comparison.flippedTriangles) + " of " +
      Counted(comparison.triangles, "triangle", "triangles") + " (" + Percent(share) +
      ") turned by more than a right angle" +
      (smooths ? ", which is right only where noise had turned them before. " : ". ") +
      StrengthRemedy(options));
  }
}

void WarnOfVolume(const OptimizerOptions& options, const SurfaceComparison& comparison,
  const VolumeLoss& loss, std::vector<std::string>& warnings)
{
  const double change = comparison.relativeVolumeChange;
  if (loss.shrunk > 0)
  {
    warnings.push_back(std::to_string(loss.shrunk) + " of " +
                       Counted(loss.closed, "closed component", "closed components") +
                       " lost more than a tenth of the volume, the largest loss is " +
                       Percent(loss.largest) + ". " +
                       (options.preserveVolume ? "Raise " : "Switch PreserveVolume on, or raise ") +
                       (options.mode == Mode::SMOOTH_GUIDED ? "DetailWeight." : "ScaleFactor."));
  }
  else if (options.mode == Mode::OPTIMIZE_TRIANGLES && std::abs(change) > LargestVolumeChange)
  {
    warnings.push_back("The volume changed by " + std::string(change > 0 ? "+" : "") +
                       Percent(change) + ". " + StrengthRemedy(options));
  }
}

void Count(VolumeLoss& loss, double change)
{
  ++loss.closed;
  loss.shrunk += change > LargestVolumeChange;
  loss.largest = std::max(loss.largest, change);
}
}

void VertexFreedom::operator+=(const VertexFreedom& other)
{
  this->movable += other.movable;
  this->movableWithoutArea += other.movableWithoutArea;
  this->unused += other.unused;
  this->pinned += other.pinned;
  this->onBoundary += other.onBoundary;
  this->corners += other.corners;
}

VertexFreedom CountFreedom(const MeshQuantities& mesh, const DisplacementConstraints& constraints,
  const OptimizerOptions& options, const VertexArrays& arrays)
{
  const MeshTopology& topology = mesh.GetTopology();
  const Subdomain& subdomain = mesh.GetSubdomain();
  const Vector& ratios = mesh.GetQuality()->triangles;
  const bool isBoundaryFixed = options.boundaryCondition == BoundaryCondition::FIXED;
  VertexFreedom freedom = ParallelSum(topology.vertices, VertexFreedom(),
    [&](VertexFreedom& sum, Index i)
    {
      if (!subdomain.OwnsVertex(i))
      {
        return;
      }
      const bool isMovable = constraints.freedom[i] != DisplacementConstraints::FIXED;
      const bool isPinned = arrays.fixedPoints && (*arrays.fixedPoints)[i] != 0;
      std::int64_t& reason = isMovable                                   ? sum.movable
                             : !topology.isUsed[i]                       ? sum.unused
                             : isPinned                                  ? sum.pinned
                             : isBoundaryFixed && topology.isBoundary[i] ? sum.onBoundary
                                                                         : sum.corners;
      ++reason;
      sum.movableWithoutArea += isMovable && HasNoArea(topology, ratios, i);
    });
  for (std::int64_t* count : { &freedom.movable, &freedom.movableWithoutArea, &freedom.unused,
         &freedom.pinned, &freedom.onBoundary, &freedom.corners })
  {
    *count = static_cast<std::int64_t>(subdomain.Sum(double(*count)));
  }
  return freedom;
}

std::string WarnOfFreedom(const VertexFreedom& freedom)
{
  if (freedom.movable > 0)
  {
    return freedom.movableWithoutArea < freedom.movable
             ? std::string()
             : "The triangles of all " + Counted(freedom.movable, "point", "points") +
                 " that can move have no area: there is no surface to optimize. Check the "
                 "coordinates, or remove these triangles and merge points that coincide, for "
                 "example with vtkCleanPolyData.";
  }
  struct Reason
  {
    std::int64_t count;
    const char* what;
    const char* remedy;
  };
  const Reason reasons[] = {
    { freedom.onBoundary, " on boundaries, which are fixed",
      " If neighbouring triangles do not share their points, switch WeldCoincidentPoints on, or "
      "merge points that nearly coincide with vtkCleanPolyData (the filter Clean). Otherwise "
      "choose "
      "BoundaryCondition SLIDING or FREE." },
    { freedom.pinned, " fixed by the array of fixed points or by the selection",
      " Fix fewer points." },
    { freedom.corners, " at corners of feature lines or boundaries",
      " Raise FeatureAngle, or choose a FEATURE_ARRAY or BoundaryCondition FREE." },
    { freedom.unused, " without a triangle", " Only polygons and triangle strips are optimized." },
  };
  std::string counts;
  std::string remedies;
  for (const auto& [count, what, remedy] : reasons)
  {
    if (count > 0)
    {
      counts += (counts.empty() ? " " : ", ") + std::to_string(count) + what;
      remedies += remedy;
    }
  }
  return counts.empty() ? std::string() : "No point can move:" + counts + "." + remedies;
}

VolumeLoss MeasureVolumeLoss(const MeshQuantities& mesh, const Points& after)
{
  VolumeLoss loss;
  const EnclosedRegions regions = FindEnclosedRegions(mesh.GetTriangles(), mesh.GetComponents());
  const RegionVolumes before = MeasureVolumes(mesh.GetPoints(), mesh.GetTriangles(), regions);
  const RegionVolumes now = MeasureVolumes(after, mesh.GetTriangles(), regions);
  for (Index k = 0; k < regions.count; ++k)
  {
    if (before.IsSignificant(k))
    {
      Count(loss, 1 - now.volume[k] / before.volume[k]);
    }
  }
  return loss;
}

VolumeLoss VolumeLossOfWhole(const SurfaceComparison& comparison)
{
  VolumeLoss loss;
  if (comparison.relativeVolumeChange != 0)
  {
    Count(loss, -comparison.relativeVolumeChange);
  }
  return loss;
}

std::string WarnOfIntersections(const IntersectionReport& report)
{
  return report.added == 0
           ? std::string()
           : Counted(report.added, "pair of triangles meets", "pairs of triangles meet") +
               " that did not before. Choose OPTIMIZE_WITHIN_DEVIATION, which prevents that, or a "
               "larger ScaleFactor.";
}

std::string WarnOfBeyond(Index triangles)
{
  return triangles == 0
           ? std::string()
           : Counted(triangles, "triangle", "triangles") +
               " of the surface and of its Reference began farther apart than MaximumDeviation. "
               "They did not move farther apart. Raise MaximumDeviation, or connect the Reference "
               "that the surface comes from.";
}

std::string WarnOfUnmoved(Index components)
{
  return components == 0
           ? std::string()
           : Counted(components, "closed component", "closed components") +
               " did not move: smoothing would take more than a twentieth of the volume, since the "
               "triangles are as large as the shape. Subdivide the surface, or choose SMOOTH.";
}

std::string WarnOfUnpreserved(Index volumes)
{
  return volumes == 0
           ? std::string()
           : "The volume of " + Counted(volumes, "component or label", "components or labels") +
               " is not preserved: the triangles are not closed, differ in their orientation, "
               "enclose nothing, or have no point that may move freely. Fill holes with "
               "vtkFillHolesFilter, orient the triangles with vtkPolyDataNormals (ConsistencyOn), "
               "or switch PreserveVolume off.";
}

std::vector<std::string> WarnOfDamage(
  const OptimizerOptions& options, const SurfaceComparison& comparison, const VolumeLoss& loss)
{
  std::vector<std::string> warnings;
  if (options.mode != Mode::OPTIMIZE_WITHIN_DEVIATION)
  {
    WarnOfQuality(options, comparison, warnings);
    WarnOfFlips(options, comparison, warnings);
    WarnOfVolume(options, comparison, loss, warnings);
  }
  return warnings;
}
}
