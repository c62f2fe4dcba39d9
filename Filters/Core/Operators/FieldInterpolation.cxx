// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Operators/FieldInterpolation.h"

#include "Core/Base/Threading.h"
#include "Core/Mesh/TriangleGeometry.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <limits>
#include <memory>

namespace lmo
{
namespace
{
/// So many fields are treated at once.
constexpr Index BlockSize = 4;
using Block = Eigen::Array<double, BlockSize, 1>;

/// What a block of fields does around a vertex.
struct Neighbourhood
{
  std::array<Block, 3> gradient; ///< a component each
  Block lowest;
  Block highest;
};

/// A value for each vertex, without any at first: several threads touch the memory first.
template <typename Value>
using PerVertex = std::unique_ptr<Value[]>;

/// A block of fields at the vertices, with zeros for those that are not there.
PerVertex<Block> BlockOf(const Fields& fields, Index first)
{
  const Index count = std::min<Index>(BlockSize, static_cast<Index>(fields.cols()) - first);
  PerVertex<Block> values(new Block[fields.rows()]);
  ParallelFor(static_cast<Index>(fields.rows()),
    [&](Index i)
    {
      values[i].setZero();
      values[i].head(count) = fields.row(i).segment(first, count).transpose().array();
    });
  return values;
}

/// The way from a vertex to a neighbour.
struct Spoke
{
  Index end = -1;
  Vector3 edge = Vector3::Zero();
  double squaredLength = 0;
  Block difference = Block::Zero(); ///< of the fields
  Vector3 factor = Vector3::Zero(); ///< times the difference, it is a term of the gradient
};

/// Goes around a vertex from triangle to triangle.
class Surroundings
{
public:
  Surroundings(const WalkableSurface& surface, const PerVertex<Block>& values, Index i)
    : Surface(surface)
    , Values(values)
    , Here(surface.V.row(i))
    , AtVertex(values[i])
    , Result{ { Block::Zero(), Block::Zero(), Block::Zero() }, values[i], values[i] }
  {
  }

  /// Adds the triangle of a corner at the vertex. In a fan it begins where the last one ended.
  void Add(Index corner)
  {
    const Index* corners = this->Surface.triangles.data();
    Spoke next = this->Last;
    if (next.end != corners[NextCorner(corner)])
    {
      this->AddTerm(this->Last);
      next = this->SpokeTo(corners[NextCorner(corner)]);
    }
    Spoke previous = this->SpokeTo(corners[PreviousCorner(corner)]);
    const Vector3 normal = next.edge.cross(previous.edge);
    const double squares = next.squaredLength * previous.squaredLength;
    if (squares * squares > std::numeric_limits<double>::min())
    {
      // The gradient of the linear interpolation times (sin(angle) / (product of the edges))^2.
      const double inverse = 1 / (squares * squares);
      const Vector3 scaled = inverse * normal;
      this->Weights += inverse * normal.squaredNorm();
      next.factor += previous.edge.cross(scaled);
      previous.factor = scaled.cross(next.edge);
    }
    this->AddTerm(next);
    this->Last = previous;
  }

  Neighbourhood Finish()
  {
    this->AddTerm(this->Last);
    for (Block& component : this->Result.gradient)
    {
      component *= this->Weights > 0 ? 1 / this->Weights : 0;
    }
    return this->Result;
  }

private:
  Spoke SpokeTo(Index j)
  {
    const Block& values = this->Values[j];
    this->Result.lowest = this->Result.lowest.min(values);
    this->Result.highest = this->Result.highest.max(values);
    Spoke spoke;
    spoke.end = j;
    spoke.edge = this->Surface.V.row(j) - this->Here;
    spoke.squaredLength = spoke.edge.squaredNorm();
    spoke.difference = values - this->AtVertex;
    return spoke;
  }

  void AddTerm(const Spoke& spoke)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Result.gradient[axis] += spoke.factor[axis] * spoke.difference;
    }
  }

  const WalkableSurface& Surface;
  const PerVertex<Block>& Values;
  const Vector3 Here;
  const Block AtVertex;
  Spoke Last;
  double Weights = 0;
  Neighbourhood Result;
};

Neighbourhood Around(const WalkableSurface& surface, const PerVertex<Block>& values, Index i)
{
  Surroundings surroundings(surface, values, i);
  for (const Index corner : surface.cornersAt[i])
  {
    surroundings.Add(corner);
  }
  return surroundings.Finish();
}

/// InterpolateSmoothly() of a block of fields.
Block SmoothAt(const WalkableSurface& surface, const PerVertex<Block>& values,
  const PerVertex<Neighbourhood>& around, const SurfaceLocation& location)
{
  const TriangleCorners x = CornersOf(surface.V, surface.triangles, location.triangle);
  const Vector3 position = location.weights * x;
  const auto corners = surface.triangles.row(location.triangle);
  // What is added to the value at a corner vanishes exactly where the field is constant.
  Block value = values[corners[0]];
  value += location.weights[1] * (values[corners[1]] - values[corners[0]]) +
           location.weights[2] * (values[corners[2]] - values[corners[0]]);
  Block correction = Block::Zero();
  Block fall = Block::Zero(); // to the weighted range
  Block rise = Block::Zero();
  Block lowest = around[corners[0]].lowest; // of all corners
  Block highest = around[corners[0]].highest;
  for (int k = 0; k < 3; ++k)
  {
    const Neighbourhood& corner = around[corners[k]];
    const double weight = location.weights[k];
    const Vector3 offset = 0.5 * weight * (position - x.row(k));
    correction += offset[0] * corner.gradient[0] + offset[1] * corner.gradient[1] +
                  offset[2] * corner.gradient[2];
    fall += weight * (corner.lowest - value);
    rise += weight * (corner.highest - value);
    lowest = lowest.min(corner.lowest);
    highest = highest.max(corner.highest);
  }
  value += correction.min(rise).max(fall);
  return value.max(lowest).min(highest); // round-off must not lead out of the range
}
}

Fields InterpolateLinearly(
  const Triangles& triangles, const Fields& fields, const std::vector<SurfaceLocation>& locations)
{
  Fields result = Fields::Zero(static_cast<Eigen::Index>(locations.size()), fields.cols());
  ParallelFor(static_cast<Index>(locations.size()),
    [&](Index i)
    {
      if (locations[i].triangle >= 0 && fields.cols() > 0)
      {
        const auto corners = triangles.row(locations[i].triangle);
        const auto first = fields.row(corners[0]);
        result.row(i) = first + locations[i].weights[1] * (fields.row(corners[1]) - first) +
                        locations[i].weights[2] * (fields.row(corners[2]) - first);
      }
    });
  return result;
}

Fields InterpolateSmoothly(const WalkableSurface& surface, const Fields& fields,
  const std::vector<SurfaceLocation>& locations)
{
  Fields result(static_cast<Eigen::Index>(locations.size()), fields.cols());
  for (Index first = 0; first < static_cast<Index>(fields.cols()); first += BlockSize)
  {
    const Index count = std::min<Index>(BlockSize, static_cast<Index>(fields.cols()) - first);
    const PerVertex<Block> values = BlockOf(fields, first);
    const PerVertex<Neighbourhood> around(new Neighbourhood[fields.rows()]);
    ParallelFor(
      static_cast<Index>(fields.rows()), [&](Index i) { around[i] = Around(surface, values, i); });
    ParallelFor(static_cast<Index>(locations.size()),
      [&](Index i)
      {
        Block value = Block::Zero();
        if (locations[i].triangle >= 0)
        {
          value = SmoothAt(surface, values, around, locations[i]);
        }
        result.row(i).segment(first, count) = value.head(count).transpose();
      });
  }
  return result;
}

Points MoveWithSurface(const WalkableSurface& before, const Points& after, const Points& positions)
{
  std::vector<SurfaceLocation> places(positions.rows());
  ParallelFor(static_cast<Index>(positions.rows()),
    [&](Index i) { places[i] = WalkToClosestPoint(before, i, positions.row(i)); });
  return positions + InterpolateLinearly(before.triangles, after - before.V, places);
}
}
