// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Optimizer/DeviationOptimizer.h"

#include "Core/Base/Rounding.h"
#include "Core/Base/Threading.h"
#include "Core/Deviation/DeviationGuard.h"
#include "Core/Mesh/TriangleGeometry.h"
#include "Core/Optimizer/DeviationProblem.h"
#include "Core/Solvers/LinearSolver.h"
#include "Core/WorstTriangles/WorstTriangles.h"

#include <algorithm>
#include <optional>
#include <string>

namespace lmo
{
namespace
{
constexpr double SolverTolerance = 5e-3; ///< the next pass corrects what is left
constexpr double SmallestShare = 0.2;    ///< of a displacement that is worth keeping
constexpr double ReducedFactor = 1.3;    ///< of W_p where the guard reduced the displacement
constexpr double Release = 0.7;          ///< and where it was not
constexpr double OverRelaxation = 1.8;   ///< of the displacement where none was reduced
constexpr double Centring = 1.3;         ///< factor of that displacement
constexpr double SmallestGain = 2e-4;    ///< of t_mean, for which another pass is worth it
constexpr double SmallestRest = 0.5;     ///< of a gain, for which an earlier step is enough

/// The part of its share that a vertex loses where the guard fails; more each time, up to a half.
constexpr double LargestShareLoss = 0.5;
constexpr double SmallestShareLoss = 0.01;
constexpr double ShareLossGrowth = 1.25;

double MeanOf(const Vector& quality)
{
  return quality.size() > 0 ? quality.mean() : 0;
}

class Passes
{
public:
  Passes(const MeshQuantities& mesh, RunPlan& plan, ProgressMonitor& monitor)
    : Mesh(mesh)
    , Plan(plan)
    , Options(plan.options)
    , Features(*plan.lines)
    , Distance(LargestDistance(mesh, plan))
    , Guard(mesh.GetPoints(), mesh.GetTriangles(), mesh.GetTopology(), ReferenceOf(mesh, plan),
        plan.part, this->Distance, monitor)
    , InputQuality(MeanOf(this->Guard.GetAcceptedQuality()))
    , Problem(std::move(plan.problem))
    , Cumulative(std::move(this->Problem.position.weights))
    , AdaptiveFactors(Vector::Ones(this->Mesh.GetPoints().rows()))
    , Share(Vector::Zero(this->Mesh.GetPoints().rows()))
  {
    monitor.Report(0);
    this->SetPositionWeights();
    monitor.Report(0);
  }

  void Run(ProgressMonitor& monitor, ModeResult& result);

private:
  Index Size() const { return this->Mesh.GetTopology().vertices; }

  void SetPositionWeights()
  {
    lmo::SetPositionWeights(this->Mesh, this->Cumulative, this->Guard.GetAcceptedQuality(),
      this->AdaptiveFactors, this->Problem);
  }

  /// Of t_mean so far.
  double Gain() const { return MeanOf(this->Guard.GetAcceptedQuality()) - this->InputQuality; }

  /// Moves from the earlier step's result as its surface has moved since.
  /// \return whether the triangles are still much better than those of the mesh
  bool Follow(ProgressMonitor& monitor);

  /// The passes, and single vertices afterwards.
  void Improve(ProgressMonitor& monitor, ModeResult& result);

  /// The displacement that Eqn. 11 proposes.
  Solution Propose(ProgressMonitor& monitor);

  /// What Backtrack() asks for.
  struct Demand
  {
    double quality; ///< least t of triangles that had it
    double gain;    ///< of t_mean, below which nothing moves
    double loss;    ///< part of its share that a vertex loses at first
  };

  /// Moves as far as the guard allows, if that pays.
  /// \return whether it allows any displacement
  bool Backtrack(const Points& displacement, const Demand& demand, ProgressMonitor& monitor);

  /// The closest position that the vertex may have.
  Vector3 Place(Index i, const Vector3& position) const;

  /// Takes a part of their share from the vertices that are to blame for the failures.
  /// \return these vertices
  std::vector<Index> ReduceShares(
    const std::vector<DeviationGuard::Failure>& failures, double loss);

  Index CountRolledBack() const { return CountReduced(this->Share, this->Problem.constraints); }

  const MeshQuantities& Mesh;
  const RunPlan& Plan;
  const OptimizerOptions& Options;
  const FeatureLines& Features;
  const double Distance; ///< allowed
  DeviationGuard Guard;
  const double InputQuality; ///< t_mean
  LeastSquaresProblem Problem;
  std::optional<MultilevelBasis> Basis; ///< of the first pass, which serves for all
  const Vector Cumulative;              ///< C(kappa)
  Vector AdaptiveFactors;               ///< factor of W_p
  Vector Share;                         ///< of the displacement, 0 to 1
};

Solution Passes::Propose(ProgressMonitor& monitor)
{
  SetTargets(this->Mesh, this->Features, this->Guard.GetAccepted(), this->Problem);
  this->SetPositionWeights();
  SolverOptions solver = this->Options.solver;
  solver.tolerance = SolverTolerance;
  if (!this->Basis)
  {
    this->Basis.emplace(this->Problem, monitor);
  }
  Solution solution = SolveByLevels(this->Problem, *this->Basis, solver, monitor);
  ParallelFor(this->Size(),
    [&](Index i)
    {
      solution.displacement.row(i) *= this->Share[i] == 1 ? OverRelaxation : 1;
      if (this->Problem.constraints.freedom[i] == DisplacementConstraints::IN_PLANE)
      {
        solution.displacement.row(i) +=
          Centring * CentreAt(this->Guard, this->Mesh.GetTopology(), this->Distance, i) *
          this->Problem.constraints.axes.row(i);
      }
    });
  return solution;
}

Vector3 Passes::Place(Index i, const Vector3& position) const
{
  const Points& part = this->Plan.part.original;
  const Points& original = part.rows() > 0 ? part : this->Mesh.GetPoints();
  const Vector3 placed = this->Features.pointClass[i] == FeatureLines::EDGE
                           ? ProjectOntoLine(this->Features, original, i, position)
                           : position;
  return this->Options.roundToFloat ? RoundToFloat(placed) : placed;
}

std::vector<Index> Passes::ReduceShares(
  const std::vector<DeviationGuard::Failure>& failures, double loss)
{
  Mask isBlamed(this->Size(), false);
  ForEachToBlame(
    failures, this->Mesh.GetTriangles(), [this](Index i) { return this->Share[i] > 0; },
    [&](Index i) { isBlamed[i] = true; });
  std::vector<Index> vertices;
  for (Index i = 0; i < this->Size(); ++i)
  {
    if (isBlamed[i])
    {
      this->Share[i] *= 1 - loss;
      if (this->Share[i] < SmallestShare)
      {
        this->Share[i] = 0;
      }
      this->AdaptiveFactors[i] *= ReducedFactor;
      vertices.push_back(i);
    }
  }
  return vertices;
}

bool Passes::Backtrack(const Points& displacement, const Demand& demand, ProgressMonitor& monitor)
{
  double loss = demand.loss;
  std::vector<Index> moving;
  this->Share = Vector::Zero(this->Size());
  for (Index i = 0; i < this->Size(); ++i)
  {
    if (this->Problem.constraints.freedom[i] != DisplacementConstraints::FIXED)
    {
      this->Share[i] = 1;
      moving.push_back(i);
    }
  }
  for (;;)
  {
    monitor.Report(0);
    ParallelFor(static_cast<Index>(moving.size()),
      [&](Index k)
      {
        const Index i = moving[k];
        const Vector3 start = this->Guard.GetAccepted().row(i);
        const double share = this->Share[i];
        this->Guard.Propose(
          i, share > 0 ? this->Place(i, start + share * displacement.row(i)) : start);
      });
    const auto failures =
      this->Guard.Judge(moving, demand.quality, DeviationGuard::MANY_VERTICES, monitor);
    if (failures.empty())
    {
      break;
    }
    moving = this->ReduceShares(failures, loss);
    loss = std::min(ShareLossGrowth * loss, LargestShareLoss);
    if (moving.empty())
    {
      this->Guard.RollBack();
      return false;
    }
  }
  if (MeanOf(this->Guard.GetQuality()) < MeanOf(this->Guard.GetAcceptedQuality()) + demand.gain)
  {
    this->Guard.RollBack(); // the weights that have grown make the next proposal another one
    return true;
  }
  this->Guard.Accept();
  ParallelFor(
    this->Size(), [&](Index i) { this->AdaptiveFactors[i] *= this->Share[i] == 1 ? Release : 1; });
  return true;
}

bool Passes::Follow(ProgressMonitor& monitor)
{
  monitor.Begin("Following the previous time step");
  const Points displacement =
    DisplacementAfter(*this->Plan.earlier, this->Mesh, this->Problem.constraints);
  this->Backtrack(
    displacement, { LeastQuality(0, *this->Mesh.GetQuality()), 0, SmallestShareLoss }, monitor);
  this->AdaptiveFactors.setOnes();
  return this->Gain() >= SmallestRest * this->Plan.earlier->gain;
}

void Passes::Improve(ProgressMonitor& monitor, ModeResult& result)
{
  const int passes = this->Options.deviation.passes;
  for (int pass = 0; pass < passes; ++pass)
  {
    monitor.Begin(("Pass " + std::to_string(pass + 1) + " of " + std::to_string(passes)).c_str());
    PartialMonitor part(monitor, double(pass) / passes, (pass + 0.5) / passes);
    const Solution solution = this->Propose(part);
    result.iterations += solution.iterations;
    result.relativeResidual = solution.relativeResidual;
    const double before = MeanOf(this->Guard.GetAcceptedQuality());
    const double leastGain = pass == 0 ? LeastGain(this->Mesh, this->Plan) : 0;
    if (!this->Backtrack(solution.displacement,
          { LeastQuality(pass, *this->Mesh.GetQuality()), leastGain, LargestShareLoss }, monitor))
    {
      break;
    }
    const double after = MeanOf(this->Guard.GetAcceptedQuality());
    if (after < before + leastGain)
    {
      return;
    }
    result.deviation.passes += after != before;
    result.deviation.rolledBack = this->CountRolledBack();
    if (pass > 1 && after < before + SmallestGain)
    {
      break;
    }
  }
  if (this->Options.deviation.improveWorstTriangles)
  {
    monitor.Begin("Improving the worst triangles");
    ImproveWorstTriangles(
      this->Guard, this->Mesh.GetTriangles(), this->Mesh.GetTopology(), this->Problem.constraints,
      [this](Index i, const Vector3& position) { return this->Place(i, position); }, monitor);
  }
  result.deviation.gain = this->Gain();
}

void Passes::Run(ProgressMonitor& monitor, ModeResult& result)
{
  try
  {
    if (this->Plan.earlier && this->Follow(monitor))
    {
      result.deviation.gain = this->Plan.earlier->gain;
      result.deviation.rolledBack = this->CountRolledBack();
    }
    else
    {
      this->Improve(monitor, result);
    }
  }
  catch (const Cancelled&)
  {
    result.isCancelled = true;
  }
  result.positions = this->Guard.GetAccepted();
  result.deviation.beyond = this->Guard.CountBeyond();
  result.deviation.pinnedBad = CountPinnedBad(
    this->Mesh.GetTriangles(), this->Guard.GetAcceptedQuality(), this->Problem.constraints);
  result.intersections = ReportIntersections(this->Guard.GetInputPairs(),
    this->Guard.FindAcceptedPairs(), static_cast<Index>(this->Mesh.GetTriangles().rows()));
  result.deviation.bound = HausdorffBound(this->Guard, this->Mesh, this->Plan);
  result.deviation.relativeBound =
    result.deviation.bound > 0 ? result.deviation.bound / this->Mesh.GetDiagonal() : 0;
  result.positionWeights = std::move(this->Problem.position.weights);
  result.laplacianWeights = std::move(this->Problem.laplacian.weights);
}
}

ModeResult OptimizeWithinDeviation(
  const MeshQuantities& mesh, RunPlan& plan, ProgressMonitor& monitor)
{
  monitor.Report(0);
  ModeResult result;
  try
  {
    Passes(mesh, plan, monitor).Run(monitor, result);
  }
  catch (const Cancelled&)
  {
    result.positions = mesh.GetPoints();
    result.positionWeights = result.laplacianWeights = Vector::Zero(result.positions.rows());
    result.isCancelled = true;
  }
  return result;
}
}
