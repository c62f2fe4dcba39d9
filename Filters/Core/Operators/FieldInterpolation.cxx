// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Operators/FieldInterpolation.h"

#include "Core/Base/Threading.h"
#include "Core/Mesh/TriangleGeometry.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
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

  Neighbourhood() = default;
  explicit Neighbourhood(const Block& values)
    : gradient{ { Block::Zero(), Block::Zero(), Block::Zero() } }
    , lowest(values)
    , highest(values)
  {
  }

  /// Adds a neighbour: a term of the gradient is its difference times a vector.
  void Add(const Block& values, const Block& atVertex, const Vector3& factor)
  {
    const Block difference = values - atVertex;
    for (int axis = 0; axis < 3; ++axis)
    {
      this->gradient[axis] += factor[axis] * difference;
    }
    this->lowest = this->lowest.min(values);
    this->highest = this->highest.max(values);
  }
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

Neighbourhood Around(const Points& V, const Triangles& T, const AdjacencyLists& cornersAt,
  const PerVertex<Block>& values, Index i)
{
  Neighbourhood result(values[i]);
  const Vector3 here = V.row(i);
  double weights = 0;
  for (const Index corner : cornersAt[i])
  {
    const Index next = T.data()[NextCorner(corner)];
    const Index previous = T.data()[PreviousCorner(corner)];
    const Vector3 toNext = V.row(next) - here;
    const Vector3 toPrevious = V.row(previous) - here;
    const Vector3 normal = toNext.cross(toPrevious);
    const double length = normal.norm();
    const double squares = toNext.squaredNorm() * toPrevious.squaredNorm();
    if (length > 0 && squares > 0)
    {
      // The gradient of the linear interpolation times sin(angle) / (product of the edges).
      const Vector3 scaled = normal / (length * squares);
      weights += length / squares;
      result.Add(values[previous], values[i], scaled.cross(toNext));
      result.Add(values[next], values[i], toPrevious.cross(scaled));
    }
  }
  for (Block& component : result.gradient)
  {
    component *= weights > 0 ? 1 / weights : 0;
  }
  return result;
}

/// InterpolateSmoothly() of a block of fields.
Block SmoothAt(const Points& V, const Triangles& T, const PerVertex<Block>& values,
  const PerVertex<Neighbourhood>& around, const SurfaceLocation& location)
{
  const TriangleCorners x = CornersOf(V, T, location.triangle);
  const Vector3 position = location.weights * x;
  const auto corners = T.row(location.triangle);
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

Fields InterpolateSmoothly(const Points& V, const Triangles& triangles,
  const AdjacencyLists& cornersAt, const Fields& fields,
  const std::vector<SurfaceLocation>& locations)
{
  Fields result(static_cast<Eigen::Index>(locations.size()), fields.cols());
  for (Index first = 0; first < static_cast<Index>(fields.cols()); first += BlockSize)
  {
    const Index count = std::min<Index>(BlockSize, static_cast<Index>(fields.cols()) - first);
    const PerVertex<Block> values = BlockOf(fields, first);
    const PerVertex<Neighbourhood> around(new Neighbourhood[fields.rows()]);
    ParallelFor(static_cast<Index>(fields.rows()),
      [&](Index i) { around[i] = Around(V, triangles, cornersAt, values, i); });
    ParallelFor(static_cast<Index>(locations.size()),
      [&](Index i)
      {
        Block value = Block::Zero();
        if (locations[i].triangle >= 0)
        {
          value = SmoothAt(V, triangles, values, around, locations[i]);
        }
        result.row(i).segment(first, count) = value.head(count).transpose();
      });
  }
  return result;
}

Points MoveWithSurface(const Points& before, const Points& after, const Triangles& triangles,
  const AdjacencyLists& cornersAt, const Points& positions)
{
  std::vector<SurfaceLocation> places(positions.rows());
  ParallelFor(static_cast<Index>(positions.rows()), [&](Index i)
    { places[i] = WalkToClosestPoint(before, triangles, cornersAt, i, positions.row(i)); });
  return positions + InterpolateLinearly(triangles, after - before, places);
}
}
