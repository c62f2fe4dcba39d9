// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "MeshFixtures.h"
#include "MeshMeasures.h"

#include "Core/Operators/FieldInterpolation.h"

#include <cmath>

using namespace lmo;

namespace
{
/// Locations in all triangles, at corners, on edges and inside.
std::vector<SurfaceLocation> LocationsOn(const TestMesh& mesh)
{
  std::vector<SurfaceLocation> locations;
  for (Index t = 0; t < mesh.T.rows(); ++t)
  {
    for (const Vector3& weights :
      { Vector3(1, 0, 0), Vector3(0, 0.5, 0.5), Vector3(0.2, 0.3, 0.5), Vector3(0.6, 0.3, 0.1) })
    {
      locations.push_back({ t, weights });
    }
  }
  return locations;
}

Points PositionsOf(const TestMesh& mesh, const std::vector<SurfaceLocation>& locations)
{
  Points positions(locations.size(), 3);
  for (std::size_t i = 0; i < locations.size(); ++i)
  {
    positions.row(Eigen::Index(i)).setZero();
    for (int k = 0; k < 3; ++k)
    {
      positions.row(Eigen::Index(i)) +=
        locations[i].weights[k] * mesh.V.row(mesh.T(locations[i].triangle, k));
    }
  }
  return positions;
}

Fields Smooth(
  const TestMesh& mesh, const Fields& fields, const std::vector<SurfaceLocation>& locations)
{
  const AdjacencyLists cornersAt = CornersAtVertices(Index(mesh.V.rows()), mesh.T);
  return InterpolateSmoothly({ mesh.V, mesh.T, cornersAt }, fields, locations);
}

/// Columns x + 2 y, constant, x^2 - y^2, and a step.
Fields FieldsAt(const Points& V)
{
  Fields fields(V.rows(), 4);
  const auto x = V.col(0).array();
  const auto y = V.col(1).array();
  fields << x + 2 * y, Fields::Constant(V.rows(), 4, 0.1).col(0), x.square() - y.square(),
    (x > 3.3).cast<double>();
  return fields;
}

void CheckFields(Checks& c)
{
  const TestMesh grid = Grid(8, 0.3);
  const auto locations = LocationsOn(grid);
  const Fields fields = FieldsAt(grid.V);
  const Fields expected = FieldsAt(PositionsOf(grid, locations));
  const Fields smooth = Smooth(grid, fields, locations);
  const Fields linear = InterpolateLinearly(grid.T, fields, locations);
  const auto error = [&](const Fields& result, int column)
  { return LargestMagnitude((result.col(column) - expected.col(column)).matrix()); };
  c.Error("a linear field on a plane is interpolated exactly", error(smooth, 0), 1e-13);
  c.Error("so it is without gradients", error(linear, 0), 1e-13);
  c.Error("a constant field stays as it is, to the last bit", error(smooth, 1), 0);
  const auto meanError = [&](const Fields& result)
  { return (result.col(2) - expected.col(2)).abs().mean(); };
  c.Less("gradients make the error of a quadratic field less than half", meanError(smooth),
    0.5 * meanError(linear));
  c.Error("no value leaves the field's range",
    Larger(smooth.col(3).maxCoeff() - 1, -smooth.col(3).minCoeff()), 0);
  const Fields nowhere = Smooth(grid, fields, { SurfaceLocation() });
  c.Error("without a triangle the value is 0", LargestMagnitude(nowhere.matrix()), 0);
}

/// On a regular grid the errors of opposite triangles in the gradient of a quadratic field cancel.
void CheckQuadraticField(Checks& c)
{
  const TestMesh grid = Grid(8, 0);
  const auto locations = LocationsOn(grid);
  const Points positions = PositionsOf(grid, locations);
  const Fields smooth = Smooth(grid, FieldsAt(grid.V), locations);
  const Fields expected = FieldsAt(positions);
  double error = 0;
  for (Eigen::Index i = 0; i < positions.rows(); ++i)
  {
    const bool isInner =
      positions.row(i).head(2).minCoeff() > 1.5 && positions.row(i).head(2).maxCoeff() < 6.5;
    error = Larger(error, isInner ? std::abs(smooth(i, 2) - expected(i, 2)) : 0);
  }
  c.Error("a quadratic field on a regular grid is interpolated exactly", error, 1e-13);
}

/// The values on an edge, from both sides.
void CheckContinuity(Checks& c)
{
  const TestMesh sphere = Irregular(Icosphere(2), 0.1);
  const Fields fields = (10 * sphere.V.col(0)).array().sin().replicate<1, 4>();
  double jump = 0;
  for (Index t = 0; t < sphere.T.rows(); ++t)
  {
    for (Index s = 0; s < t; ++s)
    {
      Vector3 ofS = Vector3::Zero();
      Vector3 ofT = Vector3::Zero();
      double weight = 0.3;
      int common = 0;
      for (int k = 0; k < 3; ++k)
      {
        for (int l = 0; l < 3; ++l)
        {
          if (sphere.T(s, k) == sphere.T(t, l))
          {
            ofS[k] = ofT[l] = weight;
            weight = 1 - weight;
            ++common;
          }
        }
      }
      if (common == 2)
      {
        const Fields values = Smooth(sphere, fields, { { s, ofS }, { t, ofT } });
        jump = Larger(jump, std::abs(values(0, 0) - values(1, 0)));
      }
    }
  }
  c.Error("the field is continuous across edges", jump, 1e-14);
}
}

int TestFieldInterpolation(int argc, char* argv[])
{
  Groups groups(argc, argv);
  groups.Run("Fields", CheckFields);
  groups.Run("QuadraticField", CheckQuadraticField);
  groups.Run("Continuity", CheckContinuity);
  return groups.Result();
}
