// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "PolygonFixtures.h"

#include "Core/Mesh/TriangleGeometry.h"

#include <algorithm>
#include <cmath>
#include <map>

using namespace lmo;

namespace
{
Polygon CornersOf(const PolygonMesh& mesh, Index p)
{
  return { mesh.polygons.corners.Begin(p), mesh.polygons.corners.End(p) };
}

bool IsInside(const Vector3& v, double width, double height)
{
  return v[0] > 0 && v[0] < width && v[1] > 0 && v[1] < height;
}

/// Lattice of (columns + 1) x (rows + 1) points, of which the inner ones are moved.
Points Lattice(int columns, int rows, double jitter)
{
  Random random;
  Points V((columns + 1) * (rows + 1), 3);
  for (int k = 0; k < V.rows(); ++k)
  {
    V.row(k) << k % (columns + 1), k / (columns + 1), 0;
    if (IsInside(V.row(k), columns, rows))
    {
      V(k, 0) += jitter * random();
      V(k, 1) += jitter * random();
    }
  }
  return V;
}

/// Gives equal points one number.
class PointNumbers
{
public:
  Index operator()(const Vector3& point)
  {
    const auto round = [](double x) { return std::llround(1e9 * x); };
    const auto [entry, isNew] = this->Numbers.emplace(
      std::array<long long, 3>{ round(point[0]), round(point[1]), round(point[2]) },
      static_cast<Index>(this->Points.size()));
    if (isNew)
    {
      this->Points.push_back(point);
    }
    return entry->second;
  }

  lmo::Points Get() const
  {
    lmo::Points result(this->Points.size(), 3);
    for (std::size_t i = 0; i < this->Points.size(); ++i)
    {
      result.row(i) = this->Points[i];
    }
    return result;
  }

private:
  std::map<std::array<long long, 3>, Index> Numbers;
  std::vector<Vector3> Points;
};
}

PolygonMesh MakePolygonMesh(const Points& V, const std::vector<Polygon>& polygons)
{
  AdjacencyLists corners;
  corners.offsets.push_back(0);
  std::vector<Index> triangles;
  for (const Polygon& polygon : polygons)
  {
    corners.ids.insert(corners.ids.end(), polygon.begin(), polygon.end());
    corners.offsets.push_back(static_cast<Index>(corners.ids.size()));
    for (std::size_t k = 1; k + 1 < polygon.size(); ++k)
    {
      triangles.insert(triangles.end(), { polygon[0], polygon[k], polygon[k + 1] });
    }
  }
  return { V, Polygons(std::move(corners)),
    Eigen::Map<const Triangles>(triangles.data(), Eigen::Index(triangles.size() / 3), 3) };
}

PolygonMesh AsPolygons(const TestMesh& mesh)
{
  std::vector<Polygon> polygons;
  for (const auto& T : mesh.T.rowwise())
  {
    polygons.push_back({ T[0], T[1], T[2] });
  }
  return MakePolygonMesh(mesh.V, polygons);
}

PolygonMesh CutElsewhere(const PolygonMesh& mesh, Index shift)
{
  std::vector<Polygon> polygons;
  for (Index p = 0; p < mesh.polygons.Size(); ++p)
  {
    polygons.push_back(CornersOf(mesh, p));
    std::rotate(polygons.back().begin(), polygons.back().begin() + shift, polygons.back().end());
  }
  PolygonMesh result = MakePolygonMesh(mesh.V, polygons);
  result.polygons = mesh.polygons;
  return result;
}

PolygonMesh QuadGrid(int cells, double jitter)
{
  std::vector<Polygon> polygons;
  for (Index j = 0; j < cells; ++j)
  {
    for (Index i = 0; i < cells; ++i)
    {
      const Index a = j * (cells + 1) + i;
      polygons.push_back({ a, a + 1, a + cells + 2, a + cells + 1 });
    }
  }
  return MakePolygonMesh(Lattice(cells, cells, jitter), polygons);
}

PolygonMesh Ls(int blocks, double jitter)
{
  const Index columns = 2 * blocks, rows = 3 * blocks;
  const auto at = [&](Index i, Index j) { return j * (columns + 1) + i; };
  std::vector<Polygon> polygons;
  for (Index j = 0; j < rows; j += 3)
  {
    for (Index i = 0; i < columns; i += 2)
    {
      // The first corners are the notches.
      polygons.push_back({ at(i + 1, j + 1), at(i + 1, j + 2), at(i, j + 2), at(i, j + 1), at(i, j),
        at(i + 1, j), at(i + 2, j), at(i + 2, j + 1) });
      polygons.push_back({ at(i + 1, j + 2), at(i + 1, j + 1), at(i + 2, j + 1), at(i + 2, j + 2),
        at(i + 2, j + 3), at(i + 1, j + 3), at(i, j + 3), at(i, j + 2) });
    }
  }
  return MakePolygonMesh(Lattice(columns, rows, jitter), polygons);
}

PolygonMesh PolygonInRing(int corners)
{
  Points V(2 * corners, 3);
  std::vector<Polygon> polygons(1);
  for (Index k = 0; k < corners; ++k)
  {
    const double angle = 2 * Pi * k / corners;
    V.row(k) << std::cos(angle), std::sin(angle), 0;
    V.row(corners + k) = 1.2 * V.row(k);
    const Index next = (k + 1) % corners;
    polygons[0].push_back(k);
    polygons.push_back({ k, corners + k, corners + next, next });
  }
  return MakePolygonMesh(V, polygons);
}

PolygonMesh QuadSphere(int cells)
{
  PointNumbers number;
  std::vector<Polygon> polygons;
  for (int face = 0; face < 6; ++face)
  {
    const int axis = face % 3;
    const double side = face < 3 ? 1 : -1;
    const auto at = [&](int i, int j)
    {
      Vector3 point;
      point[axis] = side;
      point[(axis + 1) % 3] = std::tan(Pi / 4 * (2. * i / cells - 1));
      point[(axis + 2) % 3] = side * std::tan(Pi / 4 * (2. * j / cells - 1));
      return number(point.normalized());
    };
    for (int i = 0; i < cells; ++i)
    {
      for (int j = 0; j < cells; ++j)
      {
        polygons.push_back({ at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1) });
      }
    }
  }
  return MakePolygonMesh(number.Get(), polygons);
}

PolygonMesh HexagonSphere(int level)
{
  const TestMesh primal = Icosphere(level);
  const MeshTopology topology = BuildTopology(static_cast<Index>(primal.V.rows()), primal.T);
  Points V(primal.T.rows(), 3);
  for (Index t = 0; t < primal.T.rows(); ++t)
  {
    V.row(t) =
      (primal.V.row(primal.T(t, 0)) + primal.V.row(primal.T(t, 1)) + primal.V.row(primal.T(t, 2)))
        .normalized();
  }
  std::vector<Polygon> polygons(topology.vertices);
  for (Index i = 0; i < topology.vertices; ++i)
  {
    std::transform(topology.cornersAt.Begin(i), topology.cornersAt.End(i),
      std::back_inserter(polygons[i]), [](Index corner) { return corner / 3; });
  }
  return MakePolygonMesh(V, polygons);
}

PolygonMesh QuadTorus(int cells)
{
  const Index columns = 2 * cells;
  Points V(columns * cells, 3);
  std::vector<Polygon> polygons;
  const auto at = [&](Index i, Index j) { return (i % columns) * cells + j % cells; };
  for (Index i = 0; i < columns; ++i)
  {
    for (Index j = 0; j < cells; ++j)
    {
      const double u = 2 * Pi * i / columns, v = 2 * Pi * j / cells;
      const double radius = 2 + 0.8 * std::cos(v);
      V.row(at(i, j)) << radius * std::cos(u), radius * std::sin(u), 0.8 * std::sin(v);
      polygons.push_back({ at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1) });
    }
  }
  return MakePolygonMesh(V, polygons);
}

PolygonMesh Noisy(PolygonMesh mesh, double amplitude)
{
  mesh.V += amplitude * Random().Displacements(mesh.V.rows());
  return mesh;
}

PolygonMesh Tilted(PolygonMesh mesh)
{
  const Eigen::AngleAxisd turn(1, Eigen::Vector3d(1, 2, 3).normalized());
  mesh.V = (mesh.V * turn.toRotationMatrix()).eval();
  return mesh;
}

std::vector<bool> BoundaryVertices(const PolygonMesh& mesh)
{
  std::map<Edge, int> count;
  for (Index p = 0; p < mesh.polygons.Size(); ++p)
  {
    const Polygon corners = CornersOf(mesh, p);
    for (std::size_t k = 0; k < corners.size(); ++k)
    {
      ++count[EdgeBetween(corners[k], corners[(k + 1) % corners.size()])];
    }
  }
  std::vector<bool> isBoundary(mesh.V.rows(), false);
  for (const auto& [edge, polygons] : count)
  {
    if (polygons == 1)
    {
      isBoundary[edge.first] = isBoundary[edge.second] = true;
    }
  }
  return isBoundary;
}
