// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ExactIntersections.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <vector>

using namespace lmo;

namespace
{
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangle = Kernel::Triangle_3;

Kernel::Point_3 PointAt(const TestMesh& mesh, Index i)
{
  return { mesh.V(i, 0), mesh.V(i, 1), mesh.V(i, 2) };
}

/// The corners that another triangle has as well, and the others.
struct Corners
{
  std::vector<Index> common;
  std::vector<Index> others;

  Corners(const TestMesh& mesh, Index t, Index other)
  {
    for (const Index i : { mesh.T(t, 0), mesh.T(t, 1), mesh.T(t, 2) })
    {
      (mesh.T.row(other).array() == i).any() ? common.push_back(i) : others.push_back(i);
    }
  }
};

bool Meet(const TestMesh& mesh, const std::vector<Triangle>& triangles, Index s, Index t)
{
  const Corners ofS(mesh, s, t);
  const Corners ofT(mesh, t, s);
  const auto at = [&](Index i) { return PointAt(mesh, i); };
  switch (ofS.common.size())
  {
    case 0:
      return CGAL::do_intersect(triangles[s], triangles[t]);
    case 1:
      return CGAL::do_intersect(
               Kernel::Segment_3(at(ofS.others[0]), at(ofS.others[1])), triangles[t]) ||
             CGAL::do_intersect(
               Kernel::Segment_3(at(ofT.others[0]), at(ofT.others[1])), triangles[s]);
    case 2:
    {
      const auto a = at(ofS.common[0]);
      const auto b = at(ofS.common[1]);
      const auto p = at(ofS.others[0]);
      const auto q = at(ofT.others[0]);
      return CGAL::coplanar(a, b, p, q) && CGAL::coplanar_orientation(a, b, p, q) == CGAL::POSITIVE;
    }
    default:
      return true;
  }
}
}

ExactPairs FindExactIntersections(const TestMesh& mesh)
{
  std::vector<Triangle> triangles;
  for (Index t = 0; t < mesh.T.rows(); ++t)
  {
    triangles.emplace_back(
      PointAt(mesh, mesh.T(t, 0)), PointAt(mesh, mesh.T(t, 1)), PointAt(mesh, mesh.T(t, 2)));
  }
  ExactPairs pairs;
  for (Index t = 0; t < mesh.T.rows(); ++t)
  {
    for (Index s = 0; s < t; ++s)
    {
      if (CGAL::do_overlap(triangles[s].bbox(), triangles[t].bbox()) &&
          !triangles[s].is_degenerate() && !triangles[t].is_degenerate() &&
          Meet(mesh, triangles, s, t))
      {
        pairs.emplace(s, t);
      }
    }
  }
  return pairs;
}
