// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Deviation/WorstTriangles.h"

#include "Core/Deviation/StarSearch.h"
#include "Core/Mesh/TriangleGeometry.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>

namespace lmo
{
extern int g_reason;
namespace
{
std::vector<double> Env(const char* n, std::vector<double> d) { if (const char* s = getenv(n)) { d.clear(); char* e; for (double x = strtod(s, &e); e != s; x = strtod(s, &e)) { d.push_back(x); s = e; if (*s) ++s; } } return d; }
 ///< of t, one after the other
constexpr double GoalStep = 0.01;              ///< beyond, as long as all triangles reach the goal
constexpr int Directions = 8;
constexpr int MostSweeps = 10;
constexpr double SmallestGain = 1e-3;
constexpr double LargestLoss = 2e-3; ///< of t_mean, at which triangles are raised
const double Shares[] = { 1, 0.5, 0.25 }; ///< of a displacement, which the guard is asked for

struct Counters { long reasons[256] = {}; long solves = 0, found = 0, tries = 0, accepted = 0, acc[4] = {}; double solve=0, judge=0, accept=0; } C;
double Now() { timespec t; clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t); return t.tv_sec + 1e-9 * t.tv_nsec; }

class Search
{
public:
  Search(DeviationGuard& guard, const Triangles& triangles, const MeshTopology& topology,
    const DisplacementConstraints& constraints, const PlaceVertex& place)
    : Guard(guard)
    , T(triangles)
    , Topology(topology)
    , Constraints(constraints)
    , Place(place)
    , Star(guard.GetAccepted(), triangles, topology)
    , LossLeft(LargestLoss * static_cast<double>(topology.polygons.IsEmpty()
                                                   ? triangles.rows()
                                                   : Eigen::Index(topology.polygons.Size())))
    , IsExhausted(topology.vertices, false)
  {
  }

  /// Raises the triangles with t below the goal, the worst first.
  void Raise(double goal, ProgressMonitor& monitor)
  {
    for (int sweep = 0; sweep < MostSweeps && this->Sweep(goal, monitor); ++sweep)
    {
    }
  }

  /// Whether all triangles but those that cannot move have reached the goal.
  bool HaveReached(double goal) const
  {
    const std::vector<Index> below = this->WorstFirst(goal);
    return below.empty() || this->Guard.GetAcceptedQuality()[below.front()] > goal - SmallestGain;
  }

private:
public:
  void Debug(double goal)
  {
    for (int r = 0; r < 256; ++r) if (C.reasons[r]) fprintf(stderr, "reason %d: %ld\n", r, C.reasons[r]);
    const auto worst = WorstFirst(goal);
    for (size_t n = 0; n < std::min<size_t>(worst.size(), 8); ++n)
    {
      const Index t = worst[n];
      fprintf(stderr, "triangle %d t %.4f:\n", t, this->Guard.GetAcceptedQuality()[t]);
      for (int k = 0; k < 3; ++k)
      {
        const Index vertex = T(t, k);
        this->Star.SetVertex(vertex);
        const Vector3 here = this->Guard.GetAccepted().row(vertex);
        const StarSearch::Place start{ here, this->Star.Measure(here) };
        fprintf(stderr, "   %d freedom %d valence %d min %.4f", vertex, this->Constraints.freedom[vertex], this->Topology.cornersAt.Size(vertex), start.shape.minimum);
        if (!this->IsFixed(vertex)) {
        const auto place = [&](const Vector3& x) { return this->Place(vertex, x); };
        const StarSearch::Place best = this->Star.FindBest(start, this->DirectionsOf(vertex), goal, place,
        [&](const Vector3& x) { return this->Guard.IsValid(vertex, x); });
        fprintf(stderr, " best %.4f:", best.shape.minimum);
        for (double share : {1., .5, .25, .1, .05})
        {
          const Vector3 position = place(here + share * (best.position - here));
          const StarShape shape = this->Star.Measure(position);
          ProgressMonitor unwatched;
          this->Guard.Propose(vertex, position);
          this->Guard.Judge({ vertex }, start.shape.minimum, DeviationGuard::FIRST_FAILURE, unwatched).empty();
          this->Guard.RollBack();
          fprintf(stderr, " %.2f %.4f reason %d;", share, shape.minimum, g_reason);
        } }
        fprintf(stderr, "\n");
      }
    }
  }
private:
  bool IsFixed(Index i) const
  {
    return this->Constraints.freedom[i] == DisplacementConstraints::FIXED;
  }

  bool Sweep(double goal, ProgressMonitor& monitor)
  {
    bool hasMoved = false;
    for (const Index t : this->WorstFirst(goal))
    {
      monitor.Report(0);
      for (int k = 0; k < 3 && this->Guard.GetAcceptedQuality()[t] < goal; ++k)
      {
        hasMoved |= this->Improve(this->T(t, k), goal);
      }
    }
    return hasMoved;
  }

  std::vector<Index> WorstFirst(double goal) const
  {
    const Vector& quality = this->Guard.GetAcceptedQuality();
    std::vector<Index> worst;
    for (Index t = 0; t < static_cast<Index>(quality.size()); ++t)
    {
      if (quality[t] < goal && !IsDegenerate(this->T, t) &&
          !(this->IsFixed(this->T(t, 0)) && this->IsFixed(this->T(t, 1)) &&
            this->IsFixed(this->T(t, 2))))
      {
        worst.push_back(t);
      }
    }
    std::stable_sort(
      worst.begin(), worst.end(), [&](Index s, Index t) { return quality[s] < quality[t]; });
    return worst;
  }

  /// Unit directions in which the vertex may move.
  std::vector<Vector3> DirectionsOf(Index vertex) const
  {
    const Vector3 axis = this->Constraints.axes.row(vertex);
    if (this->Constraints.freedom[vertex] == DisplacementConstraints::ALONG_LINE)
    {
      return { axis, -axis };
    }
    const Vector3 normal = VertexNormal(this->Guard.GetAccepted(), this->T, this->Topology, vertex);
    if (normal.isZero(0))
    {
      return {};
    }
    const Vector3 u = normal.unitOrthogonal();
    const Vector3 v = normal.cross(u);
    std::vector<Vector3> directions;
    for (int k = 0; k < Directions; ++k)
    {
      const double angle = 2 * Pi * k / Directions;
      directions.push_back(std::cos(angle) * u + std::sin(angle) * v);
    }
    return directions;
  }

  /// \param least t that no triangle may fall below
  /// \return whether the guard accepts the position
  bool TryMove(Index vertex, const Vector3& position, double least)
  {
    ProgressMonitor unwatched;
    double t0 = Now();
    this->Guard.Propose(vertex, position);
    const bool isValid =
      this->Guard.Judge({ vertex }, least, DeviationGuard::FIRST_FAILURE, unwatched).empty();
    double t1 = Now();
    isValid ? this->Guard.Accept() : this->Guard.RollBack();
    double t2 = Now();
    C.tries++; C.reasons[isValid ? 0 : g_reason]++; Reason = isValid ? 0 : g_reason; C.accepted += isValid; C.judge += t1 - t0; C.accept += t2 - t1;
    return isValid;
  }

  /// Moves the vertex to where the least t around it is greatest.
  /// \return whether it has moved
  bool Improve(Index vertex, double goal)
  {
    if (this->IsFixed(vertex) || this->IsExhausted[vertex])
    {
      return false;
    }
    this->IsExhausted[vertex] = !this->MoveToBest(vertex, goal);
    if (this->IsExhausted[vertex])
    {
      return false;
    }
    for (const Index j : this->Topology.oneRings[vertex])
    {
      this->IsExhausted[j] = false;
    }
    return true;
  }

  bool MoveToBest(Index vertex, double goal)
  {
    const Vector3 here = this->Guard.GetAccepted().row(vertex);
    double t0 = Now();
    this->Star.SetVertex(vertex);
    const StarSearch::Place start{ here, this->Star.Measure(here) };
    const auto place = [&](const Vector3& x) { return this->Place(vertex, x); };
    const StarSearch::Place best =
      this->Star.FindBest(start, this->DirectionsOf(vertex), goal, place,
        [&](const Vector3& x) { return this->Guard.IsValid(vertex, x); });
    C.solve += Now() - t0; C.solves++;
    int k = 0;
    for (const double share : Shares)
    {
      const Vector3 position = share == 1 ? best.position : place(here + share * (best.position - here));
      const StarShape shape = this->Star.Measure(position);
      if (shape.minimum > start.shape.minimum + SmallestGain &&
          start.shape.sum - shape.sum <= this->LossLeft)
      {
        if (share == 1) C.found++;
        if (this->TryMove(vertex, position, start.shape.minimum)) {
        this->LossLeft += shape.sum - start.shape.sum;
        C.acc[k]++;
        return true; }
      }
      k++;
    }
    return false;
  }

  DeviationGuard& Guard;
  const Triangles& T;
  const MeshTopology& Topology;
  const DisplacementConstraints& Constraints;
  const PlaceVertex& Place;
  StarSearch Star;
public:
  int Reason = 0;
  double LossLeft;  ///< of the sum of all t
  Mask IsExhausted; ///< no position helps the vertex, as long as its neighbours stay
};
}

void ImproveWorstTriangles(DeviationGuard& guard, const Triangles& triangles,
  const MeshTopology& topology, const DisplacementConstraints& constraints,
  const PlaceVertex& place, ProgressMonitor& monitor)
{
  C = {};
  Search search(guard, triangles, topology, constraints, place);
  double goal = 0;
  const auto report = [&] { if (getenv("LMO_TRACE")) fprintf(stderr, "goal %.3f solves %ld found %ld tries %ld acc %ld (%ld %ld %ld) solve %.3f judge %.3f accept %.3f loss %.5f min %.4f\n", goal, C.solves, C.found, C.tries, C.accepted, C.acc[0], C.acc[1], C.acc[2], C.solve, C.judge, C.accept, LargestLoss - search.LossLeft / triangles.rows(), guard.GetAcceptedQuality().minCoeff()); };
  for (const double g : Env("LMO_GOALS", { .3, .4, .45 }))
  {
    search.Raise(goal = g, monitor); report();
  }
  for (; goal < 1 && search.HaveReached(goal);)
  {
    search.Raise(goal += GoalStep, monitor); report();
  }
  if (getenv("LMO_TRACE")) search.Debug(.45);
}
}
