// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshNumbering.h"

#include <algorithm>
#include <utility>

namespace lmo
{
MeshNumbering::MeshNumbering(
  vtkIdType points, Index triangles, vtkIdType cells, TriangleCells triangleCells)
  : NumberOfPoints(points)
  , NumberOfTriangles(triangles)
  , NumberOfCells(cells)
  , Cells(std::move(triangleCells))
{
}

std::vector<Index> MeshNumbering::Merge(const std::vector<Index>& lowest)
{
  std::vector<Index> newNumbers(lowest.size());
  std::vector<Index> firstPoints;
  for (Index vertex = 0; vertex < static_cast<Index>(lowest.size()); ++vertex)
  {
    if (lowest[vertex] == vertex)
    {
      newNumbers[vertex] = static_cast<Index>(firstPoints.size());
      firstPoints.push_back(this->FirstPointOf(vertex));
    }
    else
    {
      newNumbers[vertex] = newNumbers[lowest[vertex]];
    }
  }
  std::vector<Index> vertices(this->NumberOfPoints);
  for (Index point = 0; point < this->NumberOfPoints; ++point)
  {
    vertices[point] = newNumbers[this->VertexOf(point)];
  }
  this->Vertices = std::move(vertices);
  this->FirstPoints = std::move(firstPoints);
  return newNumbers;
}

void MeshNumbering::Renumber(const MeshOrder& order)
{
  std::vector<Index> newNumbers(order.vertices.size());
  std::vector<Index> firstPoints(order.vertices.size());
  for (std::size_t i = 0; i < order.vertices.size(); ++i)
  {
    const Index old = order.vertices[i];
    newNumbers[old] = static_cast<Index>(i);
    firstPoints[i] = this->FirstPoints.empty() ? old : this->FirstPoints[old];
  }
  std::vector<Index> vertices(this->NumberOfPoints);
  for (Index point = 0; point < this->NumberOfPoints; ++point)
  {
    vertices[point] = newNumbers[this->VertexOf(point)];
  }
  std::vector<vtkIdType> cells(order.triangles.size());
  for (std::size_t t = 0; t < order.triangles.size(); ++t)
  {
    cells[t] = this->CellOf(order.triangles[t]);
  }
  this->Vertices = std::move(vertices);
  this->FirstPoints = std::move(firstPoints);
  this->Cells.cells = std::move(cells);
}

Vector MeshNumbering::AnyOfPoints(const Vector& pointFlags) const
{
  Vector flags = Vector::Zero(
    this->IsIdentity() ? this->NumberOfPoints : static_cast<vtkIdType>(this->FirstPoints.size()));
  for (Index point = 0; point < this->NumberOfPoints; ++point)
  {
    if (pointFlags[point] != 0)
    {
      flags[this->VertexOf(point)] = 1;
    }
  }
  return flags;
}

TriangleLabels MeshNumbering::ToTriangles(const TriangleLabels& cellLabels) const
{
  TriangleLabels labels(this->NumberOfTriangles, cellLabels.cols());
  for (Index t = 0; t < this->NumberOfTriangles; ++t)
  {
    labels.row(t) = cellLabels.row(this->CellOf(t));
  }
  return labels;
}

Mask MeshNumbering::AnyOfCells(const Mask& isMarked) const
{
  Mask isMarkedCell(this->NumberOfCells, false);
  for (Index t = 0; t < this->NumberOfTriangles; ++t)
  {
    isMarkedCell[this->CellOf(t)] |= isMarked[t];
  }
  return isMarkedCell;
}

Vector MeshNumbering::LeastOfCells(const Vector& triangleValues, double none) const
{
  if (this->Cells.cells.empty() && this->NumberOfTriangles == this->NumberOfCells)
  {
    return triangleValues;
  }
  Vector values = Vector::Constant(this->NumberOfCells, none);
  for (Index t = 0; t < this->NumberOfTriangles; ++t)
  {
    double& value = values[this->CellOf(t)];
    value = value == none ? triangleValues[t] : std::min(value, triangleValues[t]);
  }
  return values;
}
}
