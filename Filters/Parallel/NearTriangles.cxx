// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "NearTriangles.h"

#include "Core/Mesh/TriangleGeometry.h"

#include <numeric>

namespace lmo
{
namespace
{
using Corners = Eigen::Map<const TriangleCorners>;

Points JoinCorners(const std::vector<TravellingCorners>& list)
{
  Points corners(3 * list.size(), 3);
  for (std::size_t t = 0; t < list.size(); ++t)
  {
    corners.middleRows<3>(3 * static_cast<Eigen::Index>(t)) = Corners(list[t].data());
  }
  return corners;
}

Triangles Successive(std::size_t count)
{
  Triangles triangles(count, 3);
  std::iota(triangles.data(), triangles.data() + triangles.size(), Index(0));
  return triangles;
}

Box3 BoxOf(const TriangleCorners& corners)
{
  return { corners.colwise().minCoeff().transpose(), corners.colwise().maxCoeff().transpose() };
}

TriangleBvh MakeTree(const Points& V, const Triangles& triangles)
{
  ProgressMonitor unwatched;
  return { V, triangles, unwatched };
}
}

TravellingCorners CornersOfTriangle(const Points& V, const Triangles& triangles, Index t)
{
  TravellingCorners corners;
  Eigen::Map<TriangleCorners>(corners.data()) = CornersOf(V, triangles, t);
  return corners;
}

Box3 WideBoxOf(const Points& V, const Triangles& triangles, Index t, double distance)
{
  Box3 box = BoxOf(CornersOf(V, triangles, t));
  box.min().array() -= distance;
  box.max().array() += distance;
  return box;
}

NearTriangles::NearTriangles(const std::vector<TravellingCorners>& list)
  : V(JoinCorners(list))
  , T(Successive(list.size()))
  , Tree(MakeTree(this->V, this->T))
{
}

bool NearTriangles::IsNear(const Box3& box) const
{
  bool isNear = false;
  if (!this->Tree.IsEmpty())
  {
    this->Tree.ForEachNear(
      box, [&](Index t) { isNear = isNear || WideBoxOf(this->V, this->T, t, 0).intersects(box); });
  }
  return isNear;
}

std::vector<TravellingCorners> ExchangeNear(const Communicator& comm,
  const std::vector<TravellingCorners>& triangles, const Box3& reach, bool keepsOwn)
{
  using Corner = std::array<double, 3>;
  std::vector<Corner> corners(2);
  Eigen::Map<Eigen::Vector3d>(corners[0].data()) = reach.min();
  Eigen::Map<Eigen::Vector3d>(corners[1].data()) = reach.max();
  corners = comm.Join(corners);
  std::vector<Box3> reaches(comm.Size());
  auto corner = corners.begin();
  for (Box3& box : reaches)
  {
    box.min() = Eigen::Map<const Eigen::Vector3d>((corner++)->data());
    box.max() = Eigen::Map<const Eigen::Vector3d>((corner++)->data());
  }
  PerProcess<TravellingCorners> leaving(comm.Size());
  for (const TravellingCorners& triangle : triangles)
  {
    const Box3 box = BoxOf(Corners(triangle.data()));
    for (int rank = 0; rank < comm.Size(); ++rank)
    {
      const bool isOwn = rank == comm.Rank();
      if (isOwn ? keepsOwn : !reaches[rank].isEmpty() && reaches[rank].intersects(box))
      {
        leaving[rank].push_back(triangle);
      }
    }
  }
  std::vector<TravellingCorners> near;
  for (const std::vector<TravellingCorners>& arrived : comm.Exchange(leaving))
  {
    near.insert(near.end(), arrived.begin(), arrived.end());
  }
  return near;
}
}
