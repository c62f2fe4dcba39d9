// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Mesh/SurfaceNormals.h"

#include "Core/Base/Threading.h"
#include "Core/Mesh/TriangleGeometry.h"
#include "Core/Mesh/TriangleNeighbours.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lmo
{
namespace
{
constexpr double ThinQuality = 0.1;
constexpr double LongShare = 0.5;    ///< of the longest edge, from which an edge is long
constexpr double ErrorShare = 20;    ///< error of a normal over that of a point by the height
constexpr double LargestError = 0.5; ///< radians, from which a normal says nothing
constexpr int LongestChain = 100;    ///< of triangles without a normal

/// The edges of a triangle: edge k leaves corner k.
struct Edges
{
  double lengths[3];
  int longest = 0;

  Edges(const Points& V, const Triangles& triangles, Index t)
  {
    for (int k = 0; k < 3; ++k)
    {
      this->lengths[k] = (V.row(triangles(t, (k + 1) % 3)) - V.row(triangles(t, k))).norm();
      this->longest = this->lengths[k] > this->lengths[this->longest] ? k : this->longest;
    }
  }
};

/// Normal of the cell of triangle t, which does not depend on how the cell is cut, with twice the
/// cell's area as its length.
Vector3 ScaledCellNormal(
  const Points& V, const Triangles& triangles, const Polygons& polygons, Index t)
{
  if (polygons.IsEmpty())
  {
    return ScaledNormal(V, triangles, t);
  }
  const Index p = polygons.ofTriangle[t];
  Vector3 sum = Vector3::Zero();
  for (Index part = polygons.FirstTriangle(p); part < polygons.FirstTriangle(p + 1); ++part)
  {
    sum += ScaledNormal(V, triangles, part);
  }
  return sum;
}

double AngleBetween(const Vector3& a, const Vector3& b)
{
  const bool areDefined = !a.isZero(0) && !b.isZero(0);
  return areDefined ? std::acos(std::clamp(a.dot(b), -1.0, 1.0)) : 0;
}

/// Finds the neighbours with which thin triangles count.
class FlushNeighbours
{
public:
  FlushNeighbours(const Points& points, const Triangles& triangles, const MeshTopology& topology,
    const Points& normals, double angle)
    : V(points)
    , T(triangles)
    , Topology(topology)
    , Normals(normals)
    , Angle(angle)
  {
  }

  /// The unit normal of triangle t together with the neighbour across a long edge whose normal
  /// differs least, if by at most the angle; else that of the neighbour across the longest edge.
  Vector3 JoinedNormal(Index t) const
  {
    const Index flush = this->Flush(t);
    const Index neighbour = flush == NoNeighbour ? this->AlongChain(t) : flush;
    if (neighbour == NoNeighbour)
    {
      return this->Normals.row(t);
    }
    Vector3 sum = ScaledNormal(this->V, this->T, neighbour);
    if (flush != NoNeighbour)
    {
      sum += ScaledNormal(this->V, this->T, t);
    }
    return sum.stableNormalized();
  }

private:
  bool HasNormal(Index t) const { return !this->Normals.row(t).isZero(0); }

  Index Neighbour(Index t, int k) const
  {
    return NeighbourAcross(this->T, this->Topology, this->T(t, k), this->T(t, (k + 1) % 3));
  }

  Index Flush(Index t) const
  {
    Index flush = NoNeighbour;
    double least = this->Angle;
    const Edges edges(this->V, this->T, t);
    for (int k = 0; k < 3 && this->HasNormal(t); ++k)
    {
      const bool isLong = edges.lengths[k] >= LongShare * edges.lengths[edges.longest];
      const Index neighbour = isLong ? this->Neighbour(t, k) : NoNeighbour;
      if (neighbour != NoNeighbour && this->HasNormal(neighbour))
      {
        const double angle = AngleBetween(this->Normals.row(t), this->Normals.row(neighbour));
        flush = angle <= least ? neighbour : flush;
        least = std::min(angle, least);
      }
    }
    return flush;
  }

  /// The first triangle with a normal across the longest edge of t, or on from there. Edges get
  /// longer along the chain, which therefore ends.
  Index AlongChain(Index t) const
  {
    double length = 0;
    for (int step = 0; step < LongestChain; ++step)
    {
      const Edges edges(this->V, this->T, t);
      t = edges.lengths[edges.longest] > length ? this->Neighbour(t, edges.longest) : NoNeighbour;
      if (t == NoNeighbour || this->HasNormal(t))
      {
        return t;
      }
      length = edges.lengths[edges.longest];
    }
    return NoNeighbour;
  }

  const Points& V;
  const Triangles& T;
  const MeshTopology& Topology;
  const Points& Normals;
  const double Angle;
};
}

double RoundOffOf(const Points& V, const MeshTopology& topology, const Subdomain& subdomain)
{
  constexpr double single = std::numeric_limits<float>::epsilon() / 2;
  constexpr double precise = std::numeric_limits<double>::epsilon() / 2;
  const double largest = subdomain.Maximum(V.size() > 0 ? V.cwiseAbs().maxCoeff() : 0);
  const bool areSingle =
    V.size() == 0 || (V.array() == V.cast<float>().cast<double>().array()).all();
  const Eigen::AlignedBox3d box = subdomain.Unite(BoundingBox(V, topology));
  const double diagonal = box.isEmpty() ? 0 : box.diagonal().norm();
  return subdomain.Maximum(!areSingle) == 0 ? single * largest
                                            : std::max(single * diagonal, precise * largest);
}

SurfaceNormals::SurfaceNormals(const Points& V, const Triangles& triangles,
  const MeshTopology& topology, const Vector& quality, double angle, const Subdomain& subdomain)
  : Own(triangles.rows(), 3)
  , Errors(triangles.rows())
  , Thin(triangles.rows())
{
  const double roundOff = RoundOffOf(V, topology, subdomain);
  const auto count = static_cast<Index>(triangles.rows());
  ParallelFor(count,
    [&](Index t)
    {
      const Vector3 normal = ScaledCellNormal(V, triangles, topology.polygons, t);
      const Edges edges(V, triangles, t);
      const double error = ErrorShare * roundOff * edges.lengths[edges.longest];
      const bool isKnown = error < LargestError * normal.stableNorm();
      this->Own.row(t) = isKnown ? normal.stableNormalized() : Vector3::Zero();
      this->Errors[t] = isKnown ? error / normal.stableNorm() : 0;
      this->Thin[t] = quality[t] < ThinQuality && !IsDegenerate(triangles, t);
    });
  this->Joined = this->Own;
  const FlushNeighbours neighbours(V, triangles, topology, this->Own, angle);
  ParallelFor(count,
    [&](Index t)
    {
      if (this->Thin[t])
      {
        this->Joined.row(t) = neighbours.JoinedNormal(t);
      }
    });
}

double SurfaceNormals::Angle(Index s, Index t) const
{
  const double joined = AngleBetween(this->Joined.row(s), this->Joined.row(t));
  const bool haveNormals = !this->Own.row(s).isZero(0) && !this->Own.row(t).isZero(0);
  const bool isThin = this->Thin[s] || this->Thin[t];
  return isThin && haveNormals ? std::min(joined, AngleBetween(this->Own.row(s), this->Own.row(t)))
                               : joined;
}
}
