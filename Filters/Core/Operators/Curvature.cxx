// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Operators/Curvature.h"

#include "Core/Base/Threading.h"

namespace lmo
{
namespace
{
/// Replaces the value of each boundary vertex by the mean over its inner neighbours.
template <typename Values>
void FillBoundary(const MeshTopology& topology, Values& values)
{
  ParallelFor(topology.vertices,
    [&](Index i)
    {
      if (!topology.isBoundary[i])
      {
        return;
      }
      values.row(i).setZero();
      Index inner = 0;
      for (const Index j : topology.oneRings[i])
      {
        if (!topology.isBoundary[j])
        {
          values.row(i) += values.row(j);
          ++inner;
        }
      }
      values.row(i) /= std::max<Index>(inner, 1);
    });
}
}

Points MeanCurvatureNormals(
  const Laplacian& meanCurvatureLaplacian, const Points& V, const MeshTopology& topology)
{
  Points normals = Apply(meanCurvatureLaplacian, V);
  FillBoundary(topology, normals);
  return normals;
}

Vector MeanCurvatures(
  const Points& meanCurvatureNormals, double diagonal, const MeshTopology& topology)
{
  Vector curvatures(meanCurvatureNormals.rows());
  ParallelFor(topology.vertices,
    [&](Index i)
    {
      const double curvature = meanCurvatureNormals.row(i).norm();
      curvatures[i] = curvature * diagonal < 1e-6 ? 0 : curvature;
    });
  FillBoundary(topology, curvatures);
  return curvatures;
}

Vector SignedMeanCurvatures(const Points& meanCurvatureNormals, const Vector& meanCurvatures,
  const Points& vertexNormals, const MeshTopology& topology)
{
  Vector curvatures(meanCurvatures.size());
  ParallelFor(topology.vertices,
    [&](Index i)
    {
      const bool isConcave = meanCurvatureNormals.row(i).dot(vertexNormals.row(i)) > 0;
      curvatures[i] = isConcave ? 0 - meanCurvatures[i] : meanCurvatures[i];
    });
  FillBoundary(topology, curvatures);
  return curvatures;
}

Vector GaussianCurvatures(
  const Vector& angleDefects, const Vector& voronoiAreas, const MeshTopology& topology)
{
  Vector curvatures =
    (voronoiAreas.array() > 0).select(angleDefects.array() / voronoiAreas.array(), 0.0);
  FillBoundary(topology, curvatures);
  return curvatures;
}

Points TangentPlaneNormals(const Points& meanCurvatureNormals, const Vector& meanCurvatures,
  const Points& vertexNormals, const MeshTopology& topology)
{
  Points normals(vertexNormals.rows(), 3);
  ParallelFor(topology.vertices,
    [&](Index i)
    {
      const bool isDefined = meanCurvatures[i] > 0 && !topology.isBoundary[i];
      normals.row(i) = isDefined ? meanCurvatureNormals.row(i).normalized() : vertexNormals.row(i);
    });
  return normals;
}
}
