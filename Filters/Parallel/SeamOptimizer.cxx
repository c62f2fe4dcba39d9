// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SeamOptimizer.h"

#include "Core/Mesh/TriangleSeparation.h"
#include "Core/Optimizer/DeviationOptimizer.h"
#include "Core/Optimizer/DeviationProblem.h"

#include <algorithm>

namespace lmo
{
namespace
{
/// Each vertex once, as its owner sent it if it did.
std::vector<SeamVertex> Unite(std::vector<SeamVertex> vertices)
{
  std::sort(vertices.begin(), vertices.end(),
    [](const SeamVertex& a, const SeamVertex& b)
    { return a.row != b.row ? a.row < b.row : a.isOwned > b.isOwned; });
  const auto isSame = [](const SeamVertex& a, const SeamVertex& b) { return a.row == b.row; };
  vertices.erase(std::unique(vertices.begin(), vertices.end(), isSame), vertices.end());
  return vertices;
}

class Seam
{
public:
  explicit Seam(SeamPart part)
    : Vertices(Unite(std::move(part.vertices)))
    , Sent(std::move(part.triangles))
    , Size(static_cast<Index>(this->Vertices.size()))
  {
    this->Reference = std::make_shared<MeshQuantities>(
      this->PositionsOf(&SeamVertex::original), this->TrianglesOf(part.reference));
    std::vector<RowTriple> triples;
    for (const SeamTriangle& triangle : this->Sent)
    {
      triples.push_back(triangle.rows);
    }
    this->Mesh = std::make_unique<MeshQuantities>(
      this->PositionsOf(&SeamVertex::position), this->TrianglesOf(triples));
  }

  ModeResult Optimize(const RunPlan& plan, double maximum, ProgressMonitor& monitor) const
  {
    RunPlan seam = this->MakePlan(plan, maximum);
    return OptimizeWithinDeviation(*this->Mesh, seam, monitor);
  }

  PerProcess<MovedVertex> MovedBy(const ModeResult& result, int processes) const
  {
    PerProcess<MovedVertex> moved(processes);
    for (Index i = 0; i < this->Size; ++i)
    {
      const SeamVertex& vertex = this->Vertices[i];
      if (vertex.isFree)
      {
        MovedVertex back{ vertex.row, {}, result.positionWeights[i], result.laplacianWeights[i] };
        Eigen::Map<Vector3>(back.position) = result.positions.row(i);
        moved[vertex.sender].push_back(back);
      }
    }
    return moved;
  }

  /// Counts the pairs of triangles of different processes.
  void CountPairs(const Points& after, SeamResult& result) const
  {
    for (const auto& [s, t] : result.report.intersections.pairsBefore)
    {
      if (this->Sent[s].home == this->Sent[t].home)
      {
        continue;
      }
      ++result.pairsBefore;
      result.areSeparate = result.areSeparate && !this->HasMoved(s) && !this->HasMoved(t);
      if (!AreSeparate(after, this->Mesh->GetTriangles(), s, t))
      {
        ++result.pairsAfter;
        result.meeting.push_back(this->Sent[s].rows);
        result.meeting.push_back(this->Sent[t].rows);
      }
    }
  }

private:
  Index Find(std::int64_t row) const
  {
    const auto found = std::lower_bound(this->Vertices.begin(), this->Vertices.end(), row,
      [](const SeamVertex& vertex, std::int64_t value) { return vertex.row < value; });
    const bool isThere = found != this->Vertices.end() && found->row == row;
    return isThere ? static_cast<Index>(found - this->Vertices.begin()) : -1;
  }

  Points PositionsOf(double (SeamVertex::*position)[3]) const
  {
    Points positions(this->Size, 3);
    for (Index i = 0; i < this->Size; ++i)
    {
      positions.row(i) = Eigen::Map<const Vector3>(this->Vertices[i].*position);
    }
    return positions;
  }

  Triangles TrianglesOf(const std::vector<RowTriple>& triples) const
  {
    Triangles triangles(triples.size(), 3);
    for (std::size_t t = 0; t < triples.size(); ++t)
    {
      for (int k = 0; k < 3; ++k)
      {
        triangles(t, k) = this->Find(triples[t][k]);
      }
    }
    return triangles;
  }

  bool HasMoved(Index t) const
  {
    const auto corners = this->Mesh->GetTriangles().row(t);
    return std::any_of(corners.begin(), corners.end(),
      [&](Index i)
      { return this->Mesh->GetPoints().row(i) != this->Reference->GetPoints().row(i); });
  }

  RunPlan MakePlan(const RunPlan& plan, double maximum) const
  {
    RunPlan seam;
    seam.options = plan.options;
    seam.options.deviation.maximum = maximum;
    seam.options.deviation.isAbsolute = true;
    seam.lines = this->Lines();
    DisplacementConstraints constraints;
    constraints.freeAxes = plan.problem.constraints.freeAxes;
    constraints.axes = seam.lines->tangents;
    for (Index i = 0; i < this->Size; ++i)
    {
      const auto pointClass = seam.lines->pointClass[i];
      const bool isFixed = !this->Vertices[i].isFree || pointClass == FeatureLines::CORNER;
      const bool slides = pointClass == FeatureLines::EDGE;
      constraints.freedom.push_back(isFixed  ? DisplacementConstraints::FIXED
                                    : slides ? DisplacementConstraints::ALONG_LINE
                                             : DisplacementConstraints::FREE);
    }
    seam.problem = SetUpTangentialProblem(*this->Mesh, constraints);
    seam.problem.position.weights.resize(this->Size);
    for (Index i = 0; i < this->Size; ++i)
    {
      seam.problem.position.weights[i] = this->Vertices[i].positionWeight;
    }
    seam.reference = this->Reference;
    seam.part.original = this->Reference->GetPoints();
    const Triangles& T = this->Mesh->GetTriangles();
    for (Index t = 0; t < static_cast<Index>(T.rows()); ++t)
    {
      seam.part.isSettled.push_back(std::none_of(
        T.row(t).begin(), T.row(t).end(), [&](Index i) { return this->Vertices[i].isFree; }));
    }
    return seam;
  }

  /// The lines; where one leaves the seam, it ends.
  FeatureLines Lines() const
  {
    FeatureLines lines;
    lines.tangents.resize(this->Size, 3);
    auto neighbours = std::make_shared<AdjacencyLists>();
    neighbours->offsets.push_back(0);
    for (Index i = 0; i < this->Size; ++i)
    {
      const SeamVertex& vertex = this->Vertices[i];
      const Index ends[] = { this->Find(vertex.neighbours[0]), this->Find(vertex.neighbours[1]) };
      const bool isEdge = vertex.pointClass == FeatureLines::EDGE && ends[0] >= 0 && ends[1] >= 0;
      const bool isSmooth = vertex.pointClass == FeatureLines::SMOOTH;
      lines.pointClass.push_back(isEdge     ? FeatureLines::EDGE
                                 : isSmooth ? FeatureLines::SMOOTH
                                            : FeatureLines::CORNER);
      if (isEdge)
      {
        neighbours->ids.insert(neighbours->ids.end(), ends, ends + 2);
      }
      neighbours->offsets.push_back(static_cast<Index>(neighbours->ids.size()));
      lines.tangents.row(i) = Eigen::Map<const Vector3>(vertex.tangent);
    }
    lines.lines = std::move(neighbours);
    return lines;
  }

  const std::vector<SeamVertex> Vertices; ///< ascending rows
  const std::vector<SeamTriangle> Sent;   ///< the triangles of Mesh
  const Index Size;
  std::shared_ptr<const MeshQuantities> Reference; ///< the vertices where they were at first
  std::unique_ptr<const MeshQuantities> Mesh;      ///< where they are now
};
}

SeamResult OptimizeSeam(
  SeamPart part, const RunPlan& plan, double maximum, int processes, ProgressMonitor& monitor)
{
  const Seam seam(std::move(part));
  SeamResult result;
  result.report = seam.Optimize(plan, maximum, monitor);
  result.moved = seam.MovedBy(result.report, processes);
  seam.CountPairs(result.report.positions, result);
  result.report.positions.resize(0, 3);
  return result;
}
}
