// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Optimizer/ChosenWeights.h"

#include "Core/Base/Threading.h"
#include "Core/Operators/Curvature.h"
#include "Core/Operators/SharpVertices.h"

namespace lmo
{
namespace
{
/// W_linear of section 5, without s. Together with its complement, which is to keep sharp features
/// (section 5.3), sharp vertices have 1: the range of curvature of the mesh alone says little where
/// all vertices lie on edges, as those of a tessellated CAD part do.
Vector LinearScheme(const CotangentQuantities& quantities, const OptimizerOptions& options)
{
  const MeshQuantities& mesh = quantities.GetMesh();
  Vector linear = LinearWeights(quantities.GetMeanCurvatures(), quantities.GetStatistics());
  if (options.positionWeighting != PositionWeighting::LINEAR ||
      options.laplacianWeighting != LaplacianWeighting::LINEAR_COMPLEMENT)
  {
    return linear;
  }
  Vector sharp = SharpVertices(mesh.GetPoints(), mesh.GetTriangles(), mesh.GetTopology());
  mesh.GetSubdomain().UpdateGhosts(sharp);
  return linear.cwiseMax(sharp);
}

/// Sections 5 and 6: the diagonal of W_p before W_t.
Vector SchemePositionWeights(const CotangentQuantities& quantities, const OptimizerOptions& options,
  const VertexArrays& arrays)
{
  const MeshQuantities& mesh = quantities.GetMesh();
  const char* const needed = "The position weighting needs a point array";
  const double s = options.scaleFactor;
  switch (options.positionWeighting)
  {
    case PositionWeighting::LINEAR:
      return s * LinearScheme(quantities, options);
    case PositionWeighting::CDF:
      return s * quantities.GetCumulativeWeights();
    case PositionWeighting::ANCHORS:
      return s * AnchorWeights(Require(mesh, arrays.positionWeights, needed));
    case PositionWeighting::ARRAY:
      return Require(mesh, arrays.positionWeights, needed);
    default:
      return Vector::Constant(mesh.GetTopology().vertices, s);
  }
}
}

Mask FixedVertices(
  const MeshTopology& topology, BoundaryCondition condition, const VertexArrays& arrays)
{
  Mask isFixed(topology.vertices);
  ParallelFor(topology.vertices,
    [&](Index i)
    {
      isFixed[i] = !topology.isUsed[i] ||
                   (topology.isBoundary[i] && condition == BoundaryCondition::FIXED) ||
                   (arrays.fixedPoints && (*arrays.fixedPoints)[i] != 0);
    });
  return isFixed;
}

Vector PositionWeights(const CotangentQuantities& quantities, const OptimizerOptions& options,
  const VertexArrays& arrays)
{
  const MeshQuantities& mesh = quantities.GetMesh();
  const MeshTopology& topology = mesh.GetTopology();
  Vector weights = SchemePositionWeights(quantities, options, arrays);
  if (options.modulateByTriangleQuality)
  {
    weights.array() *= mesh.GetQuality()->vertices.array().cwiseMax(0);
  }
  const Index unconstrained = ParallelSum(topology.vertices, Index(0),
    [&](Index& count, Index i) { count += topology.isUsed[i] && weights[i] <= 0; });
  if (mesh.GetSubdomain().Maximum(unconstrained) > 0)
  {
    WeightUnconstrainedComponents(mesh.GetComponents(),
      FixedVertices(topology, options.boundaryCondition, arrays), options.scaleFactor, weights,
      mesh.GetSubdomain());
  }
  return weights;
}

Vector LaplacianWeights(const CotangentQuantities& quantities, const OptimizerOptions& options,
  const VertexArrays& arrays)
{
  const MeshQuantities& mesh = quantities.GetMesh();
  switch (options.laplacianWeighting)
  {
    case LaplacianWeighting::LINEAR_COMPLEMENT:
      return ComplementWeights(LinearScheme(quantities, options));
    case LaplacianWeighting::CDF_COMPLEMENT:
      return ComplementWeights(quantities.GetCumulativeWeights());
    case LaplacianWeighting::GAUSSIAN:
      return GaussianWeights(quantities.GetMeanCurvatures(),
        options.gaussianWidth * quantities.GetStatistics().threshold);
    case LaplacianWeighting::ARRAY:
      return Require(mesh, arrays.laplacianWeights, "The Laplacian weighting needs a point array");
    default:
      return Vector::Ones(mesh.GetTopology().vertices);
  }
}
}
