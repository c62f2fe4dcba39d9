// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Optimizer/DeviationProblem.h"

#include "Core/Base/Threading.h"
#include "Core/Deviation/SurfaceComparison.h"
#include "Core/Mesh/TriangleGeometry.h"
#include "Core/Operators/FieldInterpolation.h"
#include "Core/WorstTriangles/WorstTriangles.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace lmo
{
namespace
{
constexpr double PositionScale = 0.03; ///< s
constexpr double LeastPositionWeight = 1e-4;
constexpr double CentringShare = 0.6;  ///< of the distance, used up, from which on it is centred
constexpr double SmallestStart = 0.05; ///< of 1 - t_mean, for which a result is improved again
constexpr double GoodQuality = 0.5;    ///< t from which a vertex has its full weight

/// Vertices of high valence and their neighbours stay: thousands of triangles that meet in a point
/// are close to each other everywhere, and the guard would compare all of them.
void FixHighValenceVertices(const Triangles& triangles, const MeshTopology& topology, Mask& freedom)
{
  for (Index i = 0; i < topology.vertices; ++i)
  {
    if (topology.HasHighValence(i))
    {
      const AdjacencyLists& cornersAt = topology.cornersAt;
      for (const Index corner : cornersAt[i])
      {
        for (const Index j : triangles.row(corner / 3))
        {
          freedom[j] = DisplacementConstraints::FIXED;
        }
      }
    }
  }
}
}

ReferenceSurface ReferenceOf(const MeshQuantities& mesh, const RunPlan& plan)
{
  const MeshQuantities& surface = plan.reference ? *plan.reference : mesh;
  return { surface.GetPoints(), surface.GetTriangles(), surface.GetTopology() };
}

double DistanceRoundOff(const MeshQuantities& mesh, const RunPlan& plan)
{
  constexpr double factor = 8 * std::numeric_limits<double>::epsilon();
  const Eigen::AlignedBox3d box =
    plan.reference ? mesh.GetBox().merged(plan.reference->GetBox()) : mesh.GetBox();
  return box.isEmpty()
           ? 0
           : factor * std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
}

double LargestDistance(const MeshQuantities& mesh, const RunPlan& plan)
{
  const DeviationOptions& deviation = plan.options.deviation;
  const double distance = deviation.maximum * (deviation.isAbsolute ? 1 : mesh.GetDiagonal());
  return std::max(distance - DistanceRoundOff(mesh, plan), 0.0);
}

LeastSquaresProblem SetUpTangentialProblem(
  const MeshQuantities& mesh, const DisplacementConstraints& constraints)
{
  const MeshTopology& topology = mesh.GetTopology();
  LeastSquaresProblem problem;
  problem.laplacian.L = mesh.GetUniformLaplacian();
  problem.laplacian.weights = Vector::Zero(topology.vertices);
  problem.constraints = constraints;
  FixHighValenceVertices(mesh.GetTriangles(), topology, problem.constraints.freedom);
  for (Index i = 0; i < topology.vertices; ++i)
  {
    auto& freedom = problem.constraints.freedom[i];
    if (freedom == DisplacementConstraints::FREE)
    {
      problem.laplacian.weights[i] = 1;
      freedom = DisplacementConstraints::IN_PLANE;
    }
  }
  return problem;
}

void SetTargets(const MeshQuantities& mesh, const FeatureLines& features, const Points& V,
  LeastSquaresProblem& problem)
{
  DisplacementConstraints& constraints = problem.constraints;
  constraints.axes = VertexNormals(V, mesh.GetTriangles(), mesh.GetTopology());
  std::vector<PolylineRow> rows;
  ForEachLineVertex(features,
    [&](Index i, Index previous, Index next)
    {
      const Vector3 tangent = (V.row(next) - V.row(previous)).stableNormalized();
      constraints.axes.row(i) = tangent;
      if (constraints.freedom[i] == DisplacementConstraints::ALONG_LINE)
      {
        const Vector3 laplacian = 0.5 * (V.row(previous) + V.row(next)) - V.row(i);
        rows.push_back({ i, previous, next, 1, -laplacian.dot(tangent) * tangent });
      }
    });
  problem.polylines = PolylineTerm(std::move(rows), mesh.GetTopology().vertices);
  auto target = std::make_shared<Points>(mesh.GetTopology().vertices, 3);
  ParallelFor(mesh.GetTopology().vertices,
    [&](Index i)
    {
      // c = f - L_u V with f = n n^T L_u V
      const Vector3 laplacian = LaplacianRow(problem.laplacian.L, V, i);
      const Vector3 normal = constraints.axes.row(i);
      target->row(i) = laplacian.dot(normal) * normal - laplacian;
    });
  problem.laplacian.target = std::move(target);
  constraints.RestrictAxes();
}

double LeastQuality(int pass, const MeshQuality& input)
{
  return std::max(pass < 2 ? 0.1 : 0.3, input.minimum);
}

double LeastGain(const MeshQuantities& mesh, const RunPlan& plan)
{
  const bool isResult =
    plan.part.original.rows() == 0 && plan.reference && HaveSameTriangles(*plan.reference, mesh);
  return isResult ? SmallestStart * (1 - mesh.GetQuality()->mean) : 0;
}

Points DisplacementAfter(const EarlierStep& earlier, const MeshQuantities& mesh,
  const DisplacementConstraints& constraints)
{
  const Points& V = mesh.GetPoints();
  const WalkableSurface before{ earlier.before, mesh.GetTriangles(), mesh.GetTopology().cornersAt };
  Points displacement = MoveWithSurface(before, V, earlier.after) - V;
  for (Index i = 0; i < mesh.GetTopology().vertices; ++i)
  {
    // A line that leads out of the free axes cannot be followed.
    const bool isOnLine = constraints.freedom[i] == DisplacementConstraints::ALONG_LINE;
    const bool isFree = !isOnLine || constraints.freeAxes == Vector3::Ones();
    const Vector3 axes = isFree ? constraints.freeAxes : Vector3(Vector3::Zero());
    displacement.row(i) = displacement.row(i).cwiseProduct(axes).eval();
  }
  return displacement;
}

double CentreAt(const DeviationGuard& guard, const MeshTopology& topology, double distance, Index i)
{
  HeightRange heights;
  for (const Index corner : topology.cornersAt[i])
  {
    heights.Add(guard.GetHeights(corner / 3));
  }
  return heights.Largest() > CentringShare * distance ? heights.Centre() : 0;
}

double HausdorffBound(const DeviationGuard& guard, const MeshQuantities& mesh, const RunPlan& plan)
{
  const double certified = guard.GetBound();
  if (plan.reference)
  {
    return certified + DistanceRoundOff(mesh, plan);
  }
  const double displacement =
    LargestDisplacement(mesh.GetPoints(), guard.GetAccepted(), Subdomain());
  return displacement > 0 && certified > 0
           ? std::min(certified + DistanceRoundOff(mesh, plan), displacement)
           : 0;
}

Index CountReduced(const Vector& shares, const DisplacementConstraints& constraints)
{
  Index count = 0;
  for (Index i = 0; i < static_cast<Index>(shares.size()); ++i)
  {
    count += constraints.freedom[i] != DisplacementConstraints::FIXED && shares[i] < 1;
  }
  return count;
}

Index CountPinnedBad(const Triangles& triangles, const Vector& triangleQuality,
  const DisplacementConstraints& constraints)
{
  Index count = 0;
  for (Index t = 0; t < static_cast<Index>(triangles.rows()); ++t)
  {
    const auto corners = triangles.row(t);
    count += triangleQuality[t] < BadQuality &&
             std::all_of(corners.begin(), corners.end(),
               [&](Index i) { return constraints.freedom[i] == DisplacementConstraints::FIXED; });
  }
  return count;
}

void SetPositionWeights(const MeshQuantities& mesh, const Vector& cumulative,
  const Vector& triangleQuality, const Vector& adaptiveFactors, LeastSquaresProblem& problem)
{
  const Index size = mesh.GetTopology().vertices;
  const Vector quality = MinimumAtVertices(triangleQuality, mesh.GetTriangles(), size);
  problem.position.weights.resize(size);
  ParallelFor(size,
    [&](Index i)
    {
      const double shape = std::min(1.0, quality[i] / GoodQuality);
      problem.position.weights[i] =
        std::max(LeastPositionWeight, PositionScale * cumulative[i] * adaptiveFactors[i] * shape);
    });
}
}
