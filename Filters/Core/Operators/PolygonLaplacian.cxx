// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Operators/PolygonLaplacian.h"

#include "Core/Base/Threading.h"
#include "Core/Operators/VirtualRefinement.h"

#include <algorithm>
#include <numeric>

namespace lmo
{
namespace
{
/// The matrix of a polygon is dense.
constexpr Index MostCorners = 32;

/// Polygons, those with too many corners replaced by their triangles.
struct Cells
{
  AdjacencyLists corners;
  std::vector<Index> firstTriangle;
  AdjacencyLists at; ///< cells at each vertex, ascending

  Cells(Index vertices, const Triangles& triangles, const Polygons& polygons);

  Index Size() const { return static_cast<Index>(this->firstTriangle.size()); }

  RefinedPolygon Refine(const Points& V, const Triangles& triangles, Index cell) const
  {
    return { V, this->corners.Begin(cell), this->corners.Size(cell), triangles,
      this->firstTriangle[cell] };
  }

private:
  void Add(const Index* begin, const Index* end, Index triangle)
  {
    this->corners.ids.insert(this->corners.ids.end(), begin, end);
    this->corners.offsets.push_back(static_cast<Index>(this->corners.ids.size()));
    this->firstTriangle.push_back(triangle);
  }

  void FindCellsAtVertices(Index vertices);
};

Cells::Cells(Index vertices, const Triangles& triangles, const Polygons& polygons)
{
  this->corners.offsets.push_back(0);
  for (Index p = 0; p < polygons.Size(); ++p)
  {
    const Index first = polygons.FirstTriangle(p);
    if (polygons.corners.Size(p) <= MostCorners)
    {
      this->Add(polygons.corners.Begin(p), polygons.corners.End(p), first);
      continue;
    }
    for (Index t = first; t < polygons.FirstTriangle(p + 1); ++t)
    {
      const Index* corners = triangles.row(t).data();
      this->Add(corners, corners + 3, t);
    }
  }
  this->FindCellsAtVertices(vertices);
}

void Cells::FindCellsAtVertices(Index vertices)
{
  std::vector<Index> last(vertices, -1);
  const auto forEachCorner = [&](const auto& visit)
  {
    std::fill(last.begin(), last.end(), -1);
    for (Index cell = 0; cell < this->Size(); ++cell)
    {
      for (const Index i : this->corners[cell])
      {
        if (last[i] != cell)
        {
          visit(i, cell);
          last[i] = cell;
        }
      }
    }
  };
  this->at.offsets.assign(vertices + 1, 0);
  forEachCorner([&](Index i, Index) { ++this->at.offsets[i + 1]; });
  std::partial_sum(this->at.offsets.begin(), this->at.offsets.end(), this->at.offsets.begin());
  this->at.ids.resize(this->at.offsets.back());
  std::vector<Index> next(this->at.offsets.begin(), this->at.offsets.end() - 1);
  forEachCorner([&](Index i, Index cell) { this->at.ids[next[i]++] = cell; });
}

/// Weights between the corners of a polygon, and the shares of the corners in its area.
Eigen::MatrixXd PairWeights(const RefinedPolygon& polygon, std::vector<double>& areas)
{
  const Index size = polygon.GetSize();
  Eigen::MatrixXd weights = Eigen::MatrixXd::Zero(size + 1, size + 1);
  areas.assign(size + 1, 0);
  polygon.ForEachTriangle(
    [&](const RefinedPolygon::Corners& corners, const TriangleCorners& positions)
    {
      const Vector3 cotangents = TriangleCotangents(positions);
      const Vector3 shares = MixedVoronoiShares(positions, cotangents);
      for (int k = 0; k < 3; ++k)
      {
        const Index next = corners[(k + 1) % 3];
        const Index previous = corners[(k + 2) % 3];
        weights(next, previous) += cotangents[k];
        weights(previous, next) += cotangents[k];
        areas[corners[k]] += shares[k];
      }
    });
  if (polygon.GetWeights().size() > 0)
  {
    const Vector& w = polygon.GetWeights();
    const Vector toVirtual = weights.col(size).head(size);
    weights.topLeftCorner(size, size) +=
      toVirtual * w.transpose() + w * toVirtual.transpose() - toVirtual.sum() * w * w.transpose();
    polygon.Distribute(areas);
  }
  return weights;
}

/// Of all cells.
struct CellMatrices
{
  std::vector<std::size_t> offsets; ///< of the weights of each cell
  std::vector<double> weights;      ///< for each pair of places in a cell, the smaller first
  Vector areas;                     ///< for each corner of each cell

  CellMatrices(const Points& V, const Triangles& triangles, const Cells& cells);

  /// Between two places in a cell of a size.
  double Weight(Index cell, Index size, Index a, Index b) const
  {
    const auto corners = static_cast<std::size_t>(size);
    const std::size_t low = std::min(a, b);
    const std::size_t high = std::max(a, b);
    return this->weights[this->offsets[cell] + low * (2 * corners - low - 1) / 2 + high - low - 1];
  }
};

CellMatrices::CellMatrices(const Points& V, const Triangles& triangles, const Cells& cells)
  : offsets(1, 0)
  , areas(cells.corners.ids.size())
{
  for (Index cell = 0; cell < cells.Size(); ++cell)
  {
    const std::size_t size = cells.corners.Size(cell);
    this->offsets.push_back(this->offsets.back() + size * (size - 1) / 2);
  }
  this->weights.resize(this->offsets.back());
  ParallelFor(cells.Size(),
    [&](Index cell)
    {
      const Index size = cells.corners.Size(cell);
      std::vector<double> cellAreas;
      const Eigen::MatrixXd pairs = PairWeights(cells.Refine(V, triangles, cell), cellAreas);
      double* weight = this->weights.data() + this->offsets[cell];
      for (Index a = 0; a < size; ++a)
      {
        this->areas[cells.corners.offsets[cell] + a] = cellAreas[a];
        for (Index b = a + 1; b < size; ++b)
        {
          *weight++ = pairs(a, b);
        }
      }
    });
}

/// The other vertices of the cells at each vertex, ascending.
AdjacencyLists CellRings(Index vertices, const Cells& cells)
{
  AdjacencyLists rings;
  rings.offsets.push_back(0);
  std::vector<Index> ring;
  for (Index i = 0; i < vertices; ++i)
  {
    ring.clear();
    for (const Index cell : cells.at[i])
    {
      std::copy_if(cells.corners.Begin(cell), cells.corners.End(cell), std::back_inserter(ring),
        [i](Index j) { return j != i; });
    }
    std::sort(ring.begin(), ring.end());
    rings.ids.insert(rings.ids.end(), ring.begin(), std::unique(ring.begin(), ring.end()));
    rings.offsets.push_back(static_cast<Index>(rings.ids.size()));
  }
  return rings;
}

/// Calls visit(cell, place) for the corners at vertex i.
template <typename Visit>
void ForEachCellCorner(const Cells& cells, Index i, const Visit& visit)
{
  for (const Index cell : cells.at[i])
  {
    for (Index place = 0; place < cells.corners.Size(cell); ++place)
    {
      if (cells.corners.Begin(cell)[place] == i)
      {
        visit(cell, place);
      }
    }
  }
}
}

CotangentParts ComputePolygonWeights(
  const Points& V, const Triangles& triangles, const Polygons& polygons)
{
  const auto vertices = static_cast<Index>(V.rows());
  const Cells cells(vertices, triangles, polygons);
  const CellMatrices matrices(V, triangles, cells);
  const auto rings = std::make_shared<const AdjacencyLists>(CellRings(vertices, cells));
  const auto weights = std::make_shared<Vector>(Vector::Zero(rings->ids.size()));
  Vector areas = Vector::Zero(vertices);
  ParallelFor(vertices,
    [&](Index i)
    {
      const auto weightTo = [&](Index j) -> double&
      {
        const Index* place = std::lower_bound(rings->Begin(i), rings->End(i), j);
        return (*weights)[place - rings->ids.data()];
      };
      ForEachCellCorner(cells, i,
        [&](Index cell, Index place)
        {
          areas[i] += matrices.areas[cells.corners.offsets[cell] + place];
          const Index size = cells.corners.Size(cell);
          for (Index other = 0; other < size; ++other)
          {
            const Index j = cells.corners.Begin(cell)[other];
            if (j != i)
            {
              weightTo(j) += matrices.Weight(cell, size, place, other);
            }
          }
        });
    });
  return { rings, weights, std::move(areas) };
}

Vector PolygonAngleDefects(const Points& V, const Triangles& triangles, const Polygons& polygons)
{
  const auto vertices = static_cast<Index>(V.rows());
  const Cells cells(vertices, triangles, polygons);
  Vector angles(cells.corners.ids.size());
  ParallelFor(cells.Size(),
    [&](Index cell)
    {
      const RefinedPolygon refined = cells.Refine(V, triangles, cell);
      std::vector<double> sums(refined.GetSize() + 1, 0);
      sums.back() = -2 * Pi;
      refined.ForEachTriangle(
        [&](const RefinedPolygon::Corners& corners, const TriangleCorners& positions)
        {
          const Vector3 cornerAngles = TriangleAngles(positions);
          for (int k = 0; k < 3; ++k)
          {
            sums[corners[k]] += cornerAngles[k];
          }
        });
      refined.Distribute(sums);
      std::copy(sums.begin(), sums.end() - 1, angles.data() + cells.corners.offsets[cell]);
    });
  Vector defects = Vector::Zero(vertices);
  ParallelFor(vertices,
    [&](Index i)
    {
      double sum = 0;
      ForEachCellCorner(cells, i,
        [&](Index cell, Index place) { sum += angles[cells.corners.offsets[cell] + place]; });
      defects[i] = cells.at.Size(i) > 0 ? 2 * Pi - sum : 0;
    });
  return defects;
}
}
