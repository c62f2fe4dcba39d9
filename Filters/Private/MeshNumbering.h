// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef MeshNumbering_h
#define MeshNumbering_h

#include "Core/Mesh/VertexOrder.h"

#include "vtkType.h"

namespace lmo
{
/// Which cell each triangle belongs to.
struct TriangleCells
{
  vtkIdType firstPolygon = 0;
  std::vector<vtkIdType> cells; ///< of each triangle; empty if they are firstPolygon + triangle

  vtkIdType operator()(Index triangle) const
  {
    return this->cells.empty() ? this->firstPolygon + triangle : this->cells[triangle];
  }
};

/// How the numerics number the vertices and triangles of a mesh that was read from points and
/// cells. Every array passes through here when it is read and when it is written. Several points
/// may be one vertex, and several triangles one cell.
class MeshNumbering
{
public:
  MeshNumbering() = default;

  /// Every point is the vertex of the same number.
  MeshNumbering(vtkIdType points, Index triangles, vtkIdType cells, TriangleCells triangleCells);

  /// Makes vertices one.
  /// \param lowest for each vertex the lowest one that is the same
  /// \return the new number of each vertex
  std::vector<Index> Merge(const std::vector<Index>& lowest);

  /// Gives vertices and triangles new numbers.
  void Renumber(const MeshOrder& order);

  vtkIdType GetNumberOfPoints() const { return this->NumberOfPoints; }
  vtkIdType GetNumberOfCells() const { return this->NumberOfCells; }

  /// True if every point is the vertex of the same number.
  bool IsIdentity() const { return this->Vertices.empty(); }

  /// True if several points are one vertex.
  bool HasMergedPoints() const { return this->FirstPoints.size() < this->Vertices.size(); }

  Index VertexOf(Index point) const { return this->IsIdentity() ? point : this->Vertices[point]; }
  Index FirstPointOf(Index vertex) const
  {
    return this->IsIdentity() ? vertex : this->FirstPoints[vertex];
  }
  vtkIdType CellOf(Index triangle) const { return this->Cells(triangle); }

  /// Rows at vertices from rows at points; a vertex has that of the first of its points.
  template <typename Values>
  Values ToVertices(Values pointValues) const
  {
    return ToNewOrder(this->FirstPoints, std::move(pointValues));
  }

  /// Flags of vertices from flags of points: 1 if one of the vertex's points has a value other than
  /// 0, else 0.
  Vector AnyOfPoints(const Vector& pointFlags) const;

  /// Rows at points from rows at vertices.
  template <typename Values>
  Values ToPoints(Values vertexValues) const
  {
    return ToNewOrder(this->Vertices, std::move(vertexValues));
  }

  /// Rows of triangles from rows of their cells.
  TriangleLabels ToTriangles(const TriangleLabels& cellLabels) const;

  /// For each cell whether one of its triangles is marked.
  Mask AnyOfCells(const Mask& isMarked) const;

  /// The least value of the triangles of each cell, \a none for cells without triangles.
  Vector LeastOfCells(const Vector& triangleValues, double none) const;

private:
  vtkIdType NumberOfPoints = 0;
  Index NumberOfTriangles = 0;
  vtkIdType NumberOfCells = 0;
  std::vector<Index> Vertices;    ///< of each point; empty if it has the same number
  std::vector<Index> FirstPoints; ///< of each vertex; empty if it has the same number
  TriangleCells Cells;
};
}

#endif
