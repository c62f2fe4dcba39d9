// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Deviation/VertexPatternSearch.h"

#include "Core/Mesh/TriangleGeometry.h"
#include "Core/Mesh/TriangleQuality.h"

#include <algorithm>
#include <cmath>

namespace lmo
{
namespace
{
constexpr double Goals[] = { 0.3, 0.4, 0.45 }; ///< of t, one after the other
constexpr int Directions = 12;
constexpr double Lengths[] = { 0.4, 0.2, 0.1, 0.05, 0.02 }; ///< in mean edge lengths at the vertex
constexpr int MostSweeps = 10;
constexpr int MostMoves = 10; ///< of a vertex at once
constexpr double SmallestGain = 1e-3;
constexpr double LargestLoss = 2e-3; ///< of t_mean, at which triangles are raised

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
    , LossLeft(LargestLoss * static_cast<double>(topology.polygons.IsEmpty()
                                                   ? triangles.rows()
                                                   : Eigen::Index(topology.polygons.Size())))
    , IsExhausted(topology.vertices, false)
  {
  }

  /// Improves the triangles with t below the goal once.
  /// \return whether a vertex has moved
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

private:
  /// t of the cells at a vertex.
  struct Shape
  {
    double minimum = 1;
    double sum = 0;

    void Add(double t)
    {
      this->minimum = std::min(this->minimum, t);
      this->sum += t;
    }

    /// First the minimum up to the goal, then the sum.
    bool IsBetter(const Shape& other, double goal) const
    {
      const double here = std::min(this->minimum, goal);
      const double there = std::min(other.minimum, goal);
      return here > there || (here == there && this->sum > other.sum);
    }
  };

  struct Proposal
  {
    Shape shape;
    Vector3 position;
  };

  std::vector<Index> WorstFirst(double goal) const
  {
    const Vector& quality = this->Guard.GetAcceptedQuality();
    std::vector<Index> worst;
    for (Index t = 0; t < static_cast<Index>(quality.size()); ++t)
    {
      if (quality[t] < goal && !IsDegenerate(this->T, t))
      {
        worst.push_back(t);
      }
    }
    std::stable_sort(
      worst.begin(), worst.end(), [&](Index s, Index t) { return quality[s] < quality[t]; });
    return worst;
  }

  /// With the vertex at a position.
  Shape ShapeAt(Index vertex, const Vector3& position) const
  {
    const Points& V = this->Guard.GetAccepted();
    const AdjacencyLists& cornersAt = this->Topology.cornersAt;
    const Polygons& polygons = this->Topology.polygons;
    Shape shape;
    for (const Index* c = cornersAt.Begin(vertex); c != cornersAt.End(vertex); ++c)
    {
      if (polygons.IsEmpty())
      {
        shape.Add(RadiusRatio(position, V.row(this->T.data()[NextCorner(*c)]),
          V.row(this->T.data()[PreviousCorner(*c)])));
      }
      else if (c == cornersAt.Begin(vertex) ||
               polygons.ofTriangle[*c / 3] != polygons.ofTriangle[c[-1] / 3])
      {
        const Index p = polygons.ofTriangle[*c / 3];
        const Index* ids = polygons.corners.Begin(p);
        shape.Add(CellQuality(polygons.corners.Size(p),
          [&](Index k) -> Vector3 { return ids[k] == vertex ? position : V.row(ids[k]); }));
      }
    }
    return shape;
  }

  double MeanEdgeLength(Index vertex) const
  {
    const Points& V = this->Guard.GetAccepted();
    const AdjacencyLists& rings = this->Topology.oneRings;
    double sum = 0;
    for (const Index j : rings[vertex])
    {
      sum += (V.row(j) - V.row(vertex)).norm();
    }
    return sum / rings.Size(vertex);
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

  /// The positions around the vertex that raise its minimum, best first.
  std::vector<Proposal> Propose(Index vertex, const Shape& before, double goal) const
  {
    const Vector3 here = this->Guard.GetAccepted().row(vertex);
    const double unit = this->MeanEdgeLength(vertex);
    std::vector<Proposal> proposals;
    for (const Vector3& direction : this->DirectionsOf(vertex))
    {
      for (const double length : Lengths)
      {
        const Vector3 position = this->Place(vertex, here + length * unit * direction);
        const Shape shape = this->ShapeAt(vertex, position);
        if (shape.minimum > before.minimum + SmallestGain &&
            before.sum - shape.sum <= this->LossLeft)
        {
          proposals.push_back({ shape, position });
        }
      }
    }
    std::stable_sort(proposals.begin(), proposals.end(),
      [goal](const Proposal& a, const Proposal& b) { return a.shape.IsBetter(b.shape, goal); });
    return proposals;
  }

  /// \return whether the guard accepts the position
  bool TryMove(Index vertex, const Vector3& position)
  {
    ProgressMonitor unwatched;
    this->Guard.Propose(vertex, position);
    const bool isValid =
      this->Guard.Judge({ vertex }, 0, DeviationGuard::FIRST_FAILURE, unwatched).empty();
    isValid ? this->Guard.Accept() : this->Guard.RollBack();
    return isValid;
  }

  /// Moves the vertex as long as that raises its minimum.
  bool Improve(Index vertex, double goal)
  {
    if (this->Constraints.freedom[vertex] == DisplacementConstraints::FIXED ||
        this->IsExhausted[vertex])
    {
      return false;
    }
    for (int move = 0; move < MostMoves; ++move)
    {
      const Shape before = this->ShapeAt(vertex, this->Guard.GetAccepted().row(vertex));
      if (move > 0 && before.minimum >= goal)
      {
        return true;
      }
      const std::vector<Proposal> proposals = this->Propose(vertex, before, goal);
      const auto accepted = std::find_if(proposals.begin(), proposals.end(),
        [&](const Proposal& proposal) { return this->TryMove(vertex, proposal.position); });
      if (accepted == proposals.end())
      {
        this->IsExhausted[vertex] = true;
        return move > 0;
      }
      this->LossLeft += accepted->shape.sum - before.sum;
      const AdjacencyLists& rings = this->Topology.oneRings;
      std::for_each(
        rings.Begin(vertex), rings.End(vertex), [this](Index j) { this->IsExhausted[j] = false; });
    }
    return true;
  }

  DeviationGuard& Guard;
  const Triangles& T;
  const MeshTopology& Topology;
  const DisplacementConstraints& Constraints;
  const PlaceVertex& Place;
  double LossLeft;  ///< of the sum of all t
  Mask IsExhausted; ///< no position helps the vertex, as long as its neighbours stay
};
}

void ImproveWorstTriangles(DeviationGuard& guard, const Triangles& triangles,
  const MeshTopology& topology, const DisplacementConstraints& constraints,
  const PlaceVertex& place, ProgressMonitor& monitor)
{
  Search search(guard, triangles, topology, constraints, place);
  for (const double goal : Goals)
  {
    for (int sweep = 0; sweep < MostSweeps && search.Sweep(goal, monitor); ++sweep)
    {
    }
  }
}
}
