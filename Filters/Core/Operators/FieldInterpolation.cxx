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
/// A value of each field.
using FieldValues = Eigen::Array<double, 1, Fields::ColsAtCompileTime>;

/// What the fields do around a vertex.
struct Neighbourhood
{
  std::array<FieldValues, 3> gradient; ///< a component each
  FieldValues lowest;
  FieldValues highest;
};

/// A value for each vertex, without any at first: several threads touch the memory first.
template <typename Value>
using PerVertex = std::unique_ptr<Value[]>;

/// The way from a vertex to a neighbour.
struct Spoke
{
  Index end = -1;
  Vector3 edge = Vector3::Zero();
  double squaredLength = 0;
  FieldValues difference = FieldValues::Zero();
  FieldValues factor = FieldValues::Zero(); ///< times the edge, it is a term of the gradient
};

/// Goes around a vertex from triangle to triangle.
class Surroundings
{
public:
  Surroundings(const WalkableSurface& surface, const Fields& fields, Index i)
    : Surface(surface)
    , Values(fields)
    , Here(surface.V.row(i))
    , AtVertex(fields.row(i))
    , Result{ { FieldValues::Zero(), FieldValues::Zero(), FieldValues::Zero() }, fields.row(i),
      fields.row(i) }
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
    const double squares = next.squaredLength * previous.squaredLength;
    const double product = next.edge.dot(previous.edge);
    const double area = squares - product * product; // its square, times 4
    constexpr double thin = 1e-12;                   // below, little but round-off is left
    if (area > thin * squares && squares * squares > std::numeric_limits<double>::min())
    {
      // The gradient of the linear interpolation times (sin(angle) / (product of the edges))^2.
      const double inverse = 1 / (squares * squares);
      this->Weights += inverse * area;
      next.factor += (inverse * previous.squaredLength) * next.difference -
                     (inverse * product) * previous.difference;
      previous.factor = (inverse * next.squaredLength) * previous.difference -
                        (inverse * product) * next.difference;
    }
    this->AddTerm(next);
    this->Last = previous;
  }

  Neighbourhood Finish()
  {
    this->AddTerm(this->Last);
    for (FieldValues& component : this->Result.gradient)
    {
      component *= this->Weights > 0 ? 1 / this->Weights : 0;
    }
    return this->Result;
  }

private:
  Spoke SpokeTo(Index j)
  {
    const FieldValues values = this->Values.row(j);
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
      this->Result.gradient[axis] += spoke.edge[axis] * spoke.factor;
    }
  }

  const WalkableSurface& Surface;
  const Fields& Values;
  const Vector3 Here;
  const FieldValues AtVertex;
  Spoke Last;
  double Weights = 0;
  Neighbourhood Result;
};

Neighbourhood Around(const WalkableSurface& surface, const Fields& fields, Index i)
{
  Surroundings surroundings(surface, fields, i);
  for (const Index corner : surface.cornersAt[i])
  {
    surroundings.Add(corner);
  }
  return surroundings.Finish();
}

/// InterpolateSmoothly() at one location.
FieldValues SmoothAt(const WalkableSurface& surface, const Fields& fields,
  const PerVertex<Neighbourhood>& around, const SurfaceLocation& location)
{
  const TriangleCorners x = CornersOf(surface.V, surface.triangles, location.triangle);
  const Vector3 position = location.weights * x;
  const auto corners = surface.triangles.row(location.triangle);
  // What is added to the value at a corner vanishes exactly where the field is constant.
  const FieldValues first = fields.row(corners[0]);
  FieldValues value = first + location.weights[1] * (fields.row(corners[1]) - first) +
                      location.weights[2] * (fields.row(corners[2]) - first);
  FieldValues correction = FieldValues::Zero();
  FieldValues fall = FieldValues::Zero(); // to the weighted range
  FieldValues rise = FieldValues::Zero();
  FieldValues lowest = around[corners[0]].lowest; // of all corners
  FieldValues highest = around[corners[0]].highest;
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

std::vector<SurfaceLocation> AtNearestCorners(std::vector<SurfaceLocation> locations)
{
  for (SurfaceLocation& location : locations)
  {
    location.weights = Vector3::Unit(location.NearestCorner());
  }
  return locations;
}
}

Fields InterpolateLinearly(
  const Triangles& triangles, const Fields& fields, const std::vector<SurfaceLocation>& locations)
{
  Fields result(static_cast<Eigen::Index>(locations.size()), fields.cols());
  ParallelFor(static_cast<Index>(locations.size()),
    [&](Index i)
    {
      result.row(i).setZero();
      if (locations[i].triangle >= 0)
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
  const PerVertex<Neighbourhood> around(new Neighbourhood[fields.rows()]);
  ParallelFor(
    static_cast<Index>(fields.rows()), [&](Index i) { around[i] = Around(surface, fields, i); });
  Fields result(static_cast<Eigen::Index>(locations.size()), fields.cols());
  ParallelFor(static_cast<Index>(locations.size()),
    [&](Index i)
    {
      result.row(i) = locations[i].triangle >= 0 ? SmoothAt(surface, fields, around, locations[i])
                                                 : FieldValues(FieldValues::Zero());
    });
  return result;
}

Fields InterpolateFields(const WalkableSurface& surface, const Fields& fields,
  const std::vector<SurfaceLocation>& locations, Interpolation how)
{
  switch (how)
  {
    case Interpolation::SMOOTH:
      return InterpolateSmoothly(surface, fields, locations);
    case Interpolation::LINEAR:
      return InterpolateLinearly(surface.triangles, fields, locations);
    default:
      return InterpolateLinearly(surface.triangles, fields, AtNearestCorners(locations));
  }
}

Points MoveWithSurface(const WalkableSurface& before, const Points& after, const Points& positions)
{
  std::vector<SurfaceLocation> places(positions.rows());
  ParallelFor(static_cast<Index>(positions.rows()),
    [&](Index i) { places[i] = WalkToClosestPoint(before, i, positions.row(i)); });
  Fields displacements = Fields::Zero(after.rows(), int(Fields::ColsAtCompileTime));
  displacements.leftCols<3>() = (after - before.V).array();
  return positions +
         InterpolateLinearly(before.triangles, displacements, places).leftCols<3>().matrix();
}
}
