// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "DistributedDeviation.h"

#include "SeamOptimizer.h"

#include "Core/Deviation/SurfaceComparison.h"
#include "Core/Mesh/TriangleSeparation.h"
#include "Core/Optimizer/DeviationOptimizer.h"
#include "Core/Optimizer/DeviationProblem.h"

#include <algorithm>
#include <set>
#include <utility>

namespace lmo
{
namespace
{
/// Share of the distance that the first step uses, so that the others can prove again, in another
/// way, what it did.
constexpr double FirstShare = 0.995;

/// Edges from the vertices that have not moved yet to the last ones that move with them.
constexpr int SeamWidth = 12;

/// The same of triangles that are bad in the end.
constexpr int WorstWidth = 3;
constexpr double WorstQuality = 0.75; ///< they have a smaller t
constexpr double WorstShare = 0.02;   ///< of the triangles of one process that they are at most

class Steps
{
public:
  Steps(const MeshQuantities& mesh, const DistributedSubdomain& subdomain, RunPlan& plan)
    : Mesh(mesh)
    , T(mesh.GetTriangles())
    , Domain(subdomain)
    , Comm(subdomain.GetMesh().GetCommunicator())
    , Plan(plan)
    , Distance(LargestDistance(mesh, plan))
    , IsInner(FindInnerVertices(mesh, subdomain, this->Distance))
  {
  }

  ModeResult Run(ProgressMonitor& monitor)
  {
    monitor.Report(0);
    this->MoveInner(monitor);
    SeamResult seam;
    if (!this->IsCancelled())
    {
      seam = this->MoveSeam(this->IsInner, SeamWidth, monitor);
    }
    if (this->Comm.Maximum(!seam.areSeparate) > 0)
    {
      this->Result.positions = this->Mesh.GetPoints();
      seam = this->MoveSeam(this->IsInner, SeamWidth, monitor);
    }
    if (!this->IsCancelled() && this->Plan.options.deviation.improveWorstTriangles)
    {
      this->MoveWorst(monitor);
    }
    this->CountPairs(seam);
    this->Report();
    return std::move(this->Result);
  }

private:
  bool IsCancelled() const { return this->Comm.Maximum(this->Result.isCancelled) > 0; }

  void MoveInner(ProgressMonitor& monitor)
  {
    // What the seam needs of the problem is kept, the rest would be memory twice.
    DisplacementConstraints constraints;
    constraints.freedom = this->Plan.problem.constraints.freedom;
    constraints.freeAxes = this->Plan.problem.constraints.freeAxes;
    Vector positionWeights = this->Plan.problem.position.weights;
    double& maximum = this->Plan.options.deviation.maximum;
    const double wanted = maximum;
    maximum *= FirstShare;
    for (Index i = 0; i < static_cast<Index>(this->IsInner.size()); ++i)
    {
      if (!this->IsInner[i])
      {
        this->Plan.problem.constraints.freedom[i] = DisplacementConstraints::FIXED;
      }
    }
    this->Comm.Try(
      [&]
      {
        const Meeting end(this->Comm);
        this->Result = OptimizeWithinDeviation(this->Mesh, this->Plan, monitor.OfThisProcess());
      });
    this->UpdateGhosts();
    maximum = wanted;
    this->Plan.problem.constraints = std::move(constraints);
    this->Plan.problem.position.weights = std::move(positionWeights);
  }

  SeamResult MoveSeam(const Vector& isInner, int edges, ProgressMonitor& monitor)
  {
    SeamPart part = SelectSeam(
      this->Mesh, this->Domain, this->Plan, isInner, edges, this->Result.positions, this->Distance);
    part.vertices = this->Comm.Gather(std::move(part.vertices));
    part.triangles = this->Comm.Gather(std::move(part.triangles));
    part.reference = this->Comm.Gather(std::move(part.reference));
    SeamResult seam;
    this->Comm.Try(
      [&]
      {
        const Meeting end(this->Comm);
        if (this->Comm.Rank() == 0 && !part.triangles.empty())
        {
          const DeviationOptions& deviation = this->Plan.options.deviation;
          const double unit = deviation.isAbsolute ? 1 : this->Mesh.GetDiagonal();
          seam = OptimizeSeam(std::move(part), this->Plan, deviation.maximum * unit,
            this->Comm.Size(), monitor.OfThisProcess());
        }
      });
    seam.moved.resize(this->Comm.Size());
    this->Take(seam);
    return seam;
  }

  /// Tries once more what is left of bad triangles: at the borders of what moved at one time they
  /// had less freedom than in one process.
  void MoveWorst(ProgressMonitor& monitor)
  {
    const Vector quality = RadiusRatios(this->Result.positions, this->T);
    std::vector<double> ofOwned;
    for (Index t = 0; t < static_cast<Index>(this->T.rows()); ++t)
    {
      if (this->Domain.OwnsTriangle(t))
      {
        ofOwned.push_back(quality[t]);
      }
    }
    const double least = std::min(
      WorstQuality, this->Domain.Quantile(std::move(ofOwned), WorstShare / this->Comm.Size()));
    Vector isBad = Vector::Zero(this->Mesh.GetTopology().vertices);
    for (Index t = 0; t < static_cast<Index>(this->T.rows()); ++t)
    {
      if (this->Domain.OwnsTriangle(t) && quality[t] < least)
      {
        isBad(this->T.row(t)).setOnes();
      }
    }
    this->Domain.GetMesh().UniteMaximum(isBad);
    const Vector isInner = 1 - isBad.array();
    const int passes = std::exchange(this->Plan.options.deviation.passes, 0);
    this->MoveSeam(isInner, WorstWidth, monitor);
    this->Plan.options.deviation.passes = passes;
  }

  void Take(const SeamResult& seam)
  {
    const std::int64_t firstRow = this->Domain.GetMesh().GetFirstRow();
    for (const std::vector<MovedVertex>& moved : this->Comm.Exchange(seam.moved))
    {
      for (const MovedVertex& vertex : moved)
      {
        const auto i = static_cast<Index>(vertex.row - firstRow);
        this->Result.positions.row(i) = Eigen::Map<const Vector3>(vertex.position);
        this->Result.positionWeights[i] = vertex.positionWeight;
        this->Result.laplacianWeights[i] = vertex.laplacianWeight;
      }
    }
    this->UpdateGhosts();
    const ModeResult& report = seam.report;
    this->Result.iterations += report.iterations;
    this->Result.relativeResidual =
      std::max(this->Result.relativeResidual, report.relativeResidual);
    this->Result.isCancelled = this->Result.isCancelled || report.isCancelled;
    DeviationReport& deviation = this->Result.deviation;
    deviation.passes = std::max(deviation.passes, report.deviation.passes);
    deviation.rolledBack += report.deviation.rolledBack;
    deviation.bound = std::max(deviation.bound, report.deviation.bound);
  }

  void UpdateGhosts()
  {
    this->Domain.UpdateGhosts(this->Result.positions);
    this->Domain.UpdateGhosts(this->Result.positionWeights);
    this->Domain.UpdateGhosts(this->Result.laplacianWeights);
  }

  /// Makes the pairs of this process and those that process 0 counted those of the whole surface.
  void CountPairs(const SeamResult& seam)
  {
    IntersectionReport pairs;
    pairs.isKnown = true;
    pairs.before = seam.pairsBefore;
    pairs.after = seam.pairsAfter;
    pairs.isIntersecting.assign(this->T.rows(), 0);
    for (const auto& [s, t] : this->Result.intersections.pairsBefore)
    {
      if (this->Domain.OwnsTriangle(s) && this->Domain.OwnsTriangle(t))
      {
        ++pairs.before;
        const bool meet = !AreSeparate(this->Result.positions, this->T, s, t);
        pairs.after += meet;
        pairs.isIntersecting[s] = pairs.isIntersecting[s] || meet;
        pairs.isIntersecting[t] = pairs.isIntersecting[t] || meet;
      }
    }
    const std::vector<RowTriple> joined = this->Comm.Join(seam.meeting);
    const std::set<RowTriple> meeting(joined.begin(), joined.end());
    for (Index t = 0; t < static_cast<Index>(this->T.rows()) && !meeting.empty(); ++t)
    {
      const bool meets = meeting.count(RowsOf(this->Domain.GetMesh(), this->T, t)) > 0;
      pairs.isIntersecting[t] = pairs.isIntersecting[t] || meets;
    }
    pairs.before = this->Comm.Sum(pairs.before);
    pairs.after = this->Comm.Sum(pairs.after);
    this->Result.intersections = std::move(pairs);
  }

  /// Makes figures of this process those of the whole surface.
  void Report()
  {
    ModeResult& result = this->Result;
    result.iterations = static_cast<Index>(this->Comm.Maximum(result.iterations));
    result.relativeResidual = this->Comm.Maximum(result.relativeResidual);
    result.isCancelled = this->Comm.Maximum(result.isCancelled) > 0;
    DeviationReport& deviation = result.deviation;
    deviation.passes = static_cast<Index>(this->Comm.Maximum(deviation.passes));
    deviation.rolledBack = static_cast<Index>(this->Comm.Sum(std::int64_t(deviation.rolledBack)));
    deviation.bound = std::min(this->Comm.Maximum(deviation.bound),
      LargestDisplacement(this->Mesh.GetPoints(), result.positions, this->Domain));
    const double diagonal = this->Mesh.GetDiagonal();
    deviation.relativeBound = deviation.bound > 0 ? deviation.bound / diagonal : 0;
    deviation.pinnedBad = this->CountPinnedBadTriangles();
  }

  Index CountPinnedBadTriangles() const
  {
    Vector quality = RadiusRatios(this->Result.positions, this->T);
    for (Index t = 0; t < static_cast<Index>(this->T.rows()); ++t)
    {
      quality[t] = this->Domain.OwnsTriangle(t) ? quality[t] : 1;
    }
    const Index pinned = CountPinnedBad(this->T, quality, this->Plan.problem.constraints);
    return static_cast<Index>(this->Comm.Sum(std::int64_t(pinned)));
  }

  const MeshQuantities& Mesh;
  const Triangles& T;
  const DistributedSubdomain& Domain;
  const Communicator& Comm;
  RunPlan& Plan;
  const double Distance;
  const Vector IsInner;
  ModeResult Result;
};
}

ModeResult OptimizeWithinDeviation(const MeshQuantities& mesh,
  const DistributedSubdomain& subdomain, RunPlan& plan, ProgressMonitor& monitor)
{
  return Steps(mesh, subdomain, plan).Run(monitor);
}
}
