// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CadFixtures.h"

#include "Core/Mesh/TriangleGeometry.h"

#include <array>
#include <cmath>

using namespace lmo;

namespace
{
class Builder
{
public:
  Index Point(double x, double y, double z)
  {
    this->Vertices.emplace_back(x, y, z);
    return static_cast<Index>(this->Vertices.size()) - 1;
  }

  void Triangle(Index a, Index b, Index c) { this->Triangles_.push_back({ a, b, c }); }

  void Quad(Index a, Index b, Index c, Index d)
  {
    this->Triangle(a, b, c);
    this->Triangle(a, c, d);
  }

  /// A polygon as a fan around its first point.
  void Fan(const std::vector<Index>& polygon)
  {
    for (std::size_t k = 1; k + 1 < polygon.size(); ++k)
    {
      this->Triangle(polygon[0], polygon[k], polygon[k + 1]);
    }
  }

  /// A polygon as a strip that zigzags between its two sides.
  void Strip(const std::vector<Index>& polygon)
  {
    std::size_t low = 0, high = polygon.size() - 1;
    for (bool isLow = true; high - low > 1; isLow = !isLow)
    {
      const std::size_t next = isLow ? low + 1 : high - 1;
      this->Triangle(polygon[low], polygon[next], polygon[high]);
      (isLow ? low : high) = next;
    }
  }

  TestMesh Build() const
  {
    TestMesh mesh{ Points(this->Vertices.size(), 3), Triangles(this->Triangles_.size(), 3) };
    for (std::size_t i = 0; i < this->Vertices.size(); ++i)
    {
      mesh.V.row(i) = this->Vertices[i];
    }
    for (std::size_t t = 0; t < this->Triangles_.size(); ++t)
    {
      mesh.T.row(t) << this->Triangles_[t][0], this->Triangles_[t][1], this->Triangles_[t][2];
    }
    return mesh;
  }

private:
  std::vector<Vector3> Vertices;
  std::vector<std::array<Index, 3>> Triangles_;
};

using Profile = std::vector<std::pair<double, double>>;

TestMesh Extrude(const Profile& profile, double length, Cap cap)
{
  Builder builder;
  std::vector<Index> rims[2];
  for (int end = 0; end < 2; ++end)
  {
    for (const auto& [x, y] : profile)
    {
      rims[end].push_back(builder.Point(x, y, end * length));
    }
  }
  const std::size_t sides = profile.size();
  for (std::size_t k = 0; k < sides; ++k)
  {
    const std::size_t next = (k + 1) % sides;
    builder.Quad(rims[0][k], rims[0][next], rims[1][next], rims[1][k]);
  }
  const std::vector<Index> reversed(rims[0].rbegin(), rims[0].rend());
  int end = 0;
  for (std::vector<Index> rim : { reversed, rims[1] })
  {
    if (cap == Cap::CENTRE)
    {
      rim.push_back(rim[0]);
      rim.insert(rim.begin(), builder.Point(0, 0, end++ * length));
    }
    cap == Cap::STRIP ? builder.Strip(rim) : builder.Fan(rim);
  }
  return builder.Build();
}

/// The ring between a hole and the square around it, of needles. Points follow each other by angle.
void CutRing(Builder& builder, const std::vector<Index>& outer, const std::vector<Index>& inner,
  const std::vector<double>& outerAngles, const std::vector<double>& innerAngles, bool isTop)
{
  const auto add = [&](Index a, Index b, Index c)
  { isTop ? builder.Triangle(a, b, c) : builder.Triangle(a, c, b); };
  std::size_t o = 0, i = 0;
  while (o < outer.size() || i < inner.size())
  {
    const bool isOuter =
      i == inner.size() || (o < outer.size() && outerAngles[o] <= innerAngles[i]);
    const Index outerNow = outer[(o + outer.size() - 1) % outer.size()];
    const Index innerNow = inner[(i + inner.size() - 1) % inner.size()];
    if (isOuter)
    {
      add(innerNow, outerNow, outer[o++]);
    }
    else
    {
      add(innerNow, outerNow, inner[i++]);
    }
  }
}
}

TestMesh Bar(int sides, double length, Cap cap)
{
  Profile circle;
  for (int k = 0; k < sides; ++k)
  {
    circle.emplace_back(std::cos(2 * Pi * k / sides), std::sin(2 * Pi * k / sides));
  }
  return Extrude(circle, length, cap);
}

TestMesh ExtrudedProfile(const Profile& profile, double length)
{
  return Extrude(profile, length, Cap::CENTRE);
}

TestMesh PlateWithHoles(int columns, int rows, int sides, double radius, double thickness)
{
  Builder builder;
  std::vector<Index> grid[2], holes[2];
  for (int level = 0; level < 2; ++level)
  {
    const double z = level * thickness;
    for (int k = 0; k < (columns + 1) * (rows + 1); ++k)
    {
      grid[level].push_back(builder.Point(3 * (k % (columns + 1)), 3 * (k / (columns + 1)), z));
    }
    for (int k = 0; k < columns * rows * sides; ++k)
    {
      const double angle = 2 * Pi * (k % sides + 0.3) / sides;
      const int hole = k / sides;
      holes[level].push_back(builder.Point(3 * (hole % columns) + 1.5 + radius * std::cos(angle),
        3 * (hole / columns) + 1.5 + radius * std::sin(angle), z));
    }
  }
  const auto at = [&](int level, int i, int j) { return grid[level][j * (columns + 1) + i]; };
  std::vector<double> innerAngles;
  for (int k = 0; k < sides; ++k)
  {
    innerAngles.push_back(2 * Pi * (k + 0.3) / sides);
  }
  const std::vector<double> outerAngles = { 0, Pi / 2, Pi, 3 * Pi / 2 }; // of the sides' middles
  for (int hole = 0; hole < columns * rows; ++hole)
  {
    const int i = hole % columns, j = hole / columns;
    const auto rim = [&](int level)
    {
      const auto begin = holes[level].begin() + hole * sides;
      return std::vector<Index>(begin, begin + sides);
    };
    for (int level = 0; level < 2; ++level)
    {
      CutRing(builder,
        { at(level, i + 1, j + 1), at(level, i, j + 1), at(level, i, j), at(level, i + 1, j) },
        rim(level), outerAngles, innerAngles, level == 1);
    }
    const std::vector<Index> low = rim(0), high = rim(1);
    for (int k = 0; k < sides; ++k)
    {
      const int next = (k + 1) % sides;
      builder.Quad(low[next], low[k], high[k], high[next]);
    }
  }
  for (int i = 0; i < columns; ++i)
  {
    builder.Quad(at(0, i, 0), at(0, i + 1, 0), at(1, i + 1, 0), at(1, i, 0));
    builder.Quad(at(0, i + 1, rows), at(0, i, rows), at(1, i, rows), at(1, i + 1, rows));
  }
  for (int j = 0; j < rows; ++j)
  {
    builder.Quad(at(0, 0, j + 1), at(0, 0, j), at(1, 0, j), at(1, 0, j + 1));
    builder.Quad(
      at(0, columns, j), at(0, columns, j + 1), at(1, columns, j + 1), at(1, columns, j));
  }
  return builder.Build();
}

TestMesh WithZeroAreaTriangle(const TestMesh& mesh, Index t)
{
  TestMesh cut{ Points(mesh.V.rows() + 1, 3), Triangles(mesh.T.rows() + 2, 3) };
  const Index a = mesh.T(t, 0), b = mesh.T(t, 1), c = mesh.T(t, 2);
  const auto middle = static_cast<Index>(mesh.V.rows());
  cut.V << mesh.V, (mesh.V.row(a) + mesh.V.row(b)) / 2;
  cut.T << mesh.T, Triangles::Zero(2, 3);
  cut.T.row(t) << a, middle, c;
  cut.T.bottomRows(2) << middle, b, c, a, b, middle;
  return cut;
}

TestMesh TurnedInSinglePrecision(TestMesh mesh)
{
  const Matrix3 turn =
    Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, -0.5).normalized()).toRotationMatrix();
  mesh.V = (mesh.V * turn).cast<float>().cast<double>().eval();
  return mesh;
}
