// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "PolyDataConversion.h"

#include "CellTriangulation.h"
#include "Core/Base/Exceptions.h"
#include "Core/Base/Threading.h"
#include "Core/Operators/Weights.h"

#include "vtkArrayDispatch.h"
#include "vtkCellArray.h"
#include "vtkDataArrayRange.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <limits>
#include <sstream>

namespace lmo
{
namespace
{
/// Counts what is wrong and remembers where it was seen first.
struct Faults
{
  std::int64_t count = 0;
  std::int64_t first = -1;

  void Add(std::int64_t id) { this->first = this->count++ ? this->first : id; }

  /// \throw InputError "<count> <what>; the first is <kind> <id>. <remedy>" if there are any.
  void ThrowIfAny(const char* what, const char* kind, const char* remedy) const
  {
    if (this->count > 0)
    {
      std::ostringstream text;
      text << this->count << ' ' << what << "; the first is " << kind << ' ' << this->first << ". "
           << remedy;
      throw InputError(text.str());
    }
  }
};

/// Copies the tuples of an array into rows of doubles.
struct CopyTuples
{
  template <typename Array, typename Rows>
  void operator()(Array* array, Rows& rows) const
  {
    const auto tuples = vtk::DataArrayTupleRange<Rows::ColsAtCompileTime>(array);
    ParallelFor(static_cast<Index>(rows.rows()),
      [&](Index i)
      {
        for (int c = 0; c < Rows::ColsAtCompileTime; ++c)
        {
          rows(i, c) = static_cast<double>(tuples[i][c]);
        }
      });
  }
};

template <typename Rows>
Rows ReadTuples(vtkDataArray* array)
{
  Rows rows(array->GetNumberOfTuples(), int(Rows::ColsAtCompileTime));
  if (!vtkArrayDispatch::DispatchByValueType<vtkArrayDispatch::Reals>::Execute(
        array, CopyTuples{}, rows))
  {
    CopyTuples{}(array, rows);
  }
  return rows;
}

/// Rows with a value that is not in order, which includes NaN.
template <typename Rows, typename IsInOrder>
Faults FindFaults(const Rows& rows, const IsInOrder& isInOrder)
{
  const auto count = static_cast<Index>(rows.rows());
  const auto isFaulty = [&](Index i) { return !isInOrder(rows.row(i)); };
  const bool isClean =
    ParallelSum(count, Index(0), [&](Index& sum, Index i) { sum += isFaulty(i); }) == 0;
  Faults faults;
  for (Index i = 0; i < count && !isClean; ++i)
  {
    if (isFaulty(i))
    {
      faults.Add(i);
    }
  }
  return faults;
}

template <typename Rows>
Faults FindNotFinite(const Rows& rows)
{
  return FindFaults(rows, [](const auto& row) { return row.allFinite(); });
}

/// Coordinates beyond this make areas and volumes overflow.
constexpr double LargestCoordinate = 1e70;

Faults FindHuge(const Points& points)
{
  return FindFaults(
    points, [](const auto& row) { return row.cwiseAbs().maxCoeff() <= LargestCoordinate; });
}

/// \throw InputError if the points are apart, but so little that areas underflow.
void CheckExtent(const Points& points)
{
  constexpr double smallest = 1e-70;
  if (points.rows() > 0)
  {
    const double extent = (points.colwise().maxCoeff() - points.colwise().minCoeff()).maxCoeff();
    if (extent > 0 && extent < smallest)
    {
      std::ostringstream text;
      text << "The " << points.rows() << " points span no more than " << extent
           << ", less than 1e-70, and areas are too small to be computed. Scale them.";
      throw InputError(text.str());
    }
  }
}

/// \throw InputError if the offsets do not fit the connectivity, which only hand-made cells have.
void CheckOffsets(vtkCellArray* cells, const char* what)
{
  if (cells->GetNumberOfCells() > 0 && !cells->IsValid())
  {
    throw InputError("The offsets of the " + std::to_string(cells->GetNumberOfCells()) + " " +
                     what + " do not fit their connectivity. Repair the cells of the input.");
  }
}

std::string NameOf(vtkDataArray* array, const char* kind = "point")
{
  return "the " + std::string(kind) + " array '" +
         std::string(array->GetName() ? array->GetName() : "") + "'";
}

template <typename Rows>
Rows ReadArray(vtkDataArray* array, vtkIdType count, const char* kind = "point")
{
  const std::string name = NameOf(array, kind);
  if (array->GetNumberOfTuples() != count ||
      array->GetNumberOfComponents() != Rows::ColsAtCompileTime)
  {
    std::ostringstream text;
    text << "The size of " << name << " is wrong: it has " << array->GetNumberOfTuples()
         << " tuples of " << array->GetNumberOfComponents() << " components; " << count
         << " tuples of " << Rows::ColsAtCompileTime << " are needed. Choose another array.";
    throw InputError(text.str());
  }
  Rows rows = ReadTuples<Rows>(array);
  FindNotFinite(rows).ThrowIfAny(("values of " + name + " are NaN or infinite").c_str(), kind,
    "Replace them, for example with vtkArrayCalculator.");
  return rows;
}

constexpr const char* NoSuchPoint = "cells name a point that does not exist";
constexpr const char* RepairCells = "Repair the cells of the input.";

/// Copies the connectivity of a vtkCellArray that holds nothing but triangles.
struct CopyTriangles
{
  template <typename Array>
  void operator()(
    Array* connectivity, vtkIdType points, Triangles& triangles, Faults& outOfRange) const
  {
    const auto ids = vtk::DataArrayValueRange<1>(connectivity);
    const auto count = static_cast<Index>(triangles.rows());
    const auto isOutOfRange = [&](Index t)
    {
      const vtkIdType first = 3 * vtkIdType(t);
      const auto [least, most] = std::minmax(
        { vtkIdType(ids[first]), vtkIdType(ids[first + 1]), vtkIdType(ids[first + 2]) });
      return least < 0 || most >= points;
    };
    const Index faults = ParallelSum(count, Index(0),
      [&](Index& sum, Index t)
      {
        for (int corner = 0; corner < 3; ++corner)
        {
          triangles(t, corner) = static_cast<Index>(ids[3 * vtkIdType(t) + corner]);
        }
        sum += isOutOfRange(t);
      });
    for (Index t = 0; faults > 0 && t < count; ++t)
    {
      if (isOutOfRange(t))
      {
        outOfRange.Add(t);
      }
    }
  }
};

/// \throw InputError for cells with fewer points than \a leastSize and for ids of no point.
void CheckCells(vtkCellArray* cells, vtkIdType firstCell, vtkIdType leastSize, vtkIdType points)
{
  Faults tooSmall;
  Faults outOfRange;
  vtkIdType size = 0;
  const vtkIdType* ids = nullptr;
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
  {
    cells->GetCellAtId(cell, size, ids);
    if (size < leastSize)
    {
      tooSmall.Add(firstCell + cell);
    }
    if (std::any_of(ids, ids + size, [&](vtkIdType id) { return id < 0 || id >= points; }))
    {
      outOfRange.Add(firstCell + cell);
    }
  }
  tooSmall.ThrowIfAny("polygons have fewer than three corners", "cell",
    "Remove them, for example with vtkCleanPolyData.");
  outOfRange.ThrowIfAny(NoSuchPoint, "cell", RepairCells);
}

/// The polygons if they are triangles.
/// \throw InputError for ids of no point.
Triangles ReadTriangles(vtkCellArray* polygons, vtkIdType firstCell, vtkIdType points)
{
  Triangles triangles(polygons->GetNumberOfCells(), 3);
  Faults outOfRange;
  vtkDataArray* connectivity = polygons->GetConnectivityArray();
  if (!vtkArrayDispatch::DispatchByValueType<vtkArrayDispatch::Integrals>::Execute(
        connectivity, CopyTriangles{}, points, triangles, outOfRange))
  {
    CopyTriangles{}(connectivity, points, triangles, outOfRange);
  }
  outOfRange.first += outOfRange.count > 0 ? firstCell : 0;
  outOfRange.ThrowIfAny(NoSuchPoint, "cell", RepairCells);
  return triangles;
}

/// Appends triangles and their cells; the cells of those that are there become explicit.
void Append(const CellTriangles& more, vtkIdType firstCell, SurfaceMesh& mesh)
{
  std::vector<vtkIdType>& cells = mesh.triangleCells.cells;
  const Eigen::Index count = mesh.triangles.rows();
  for (auto t = static_cast<Eigen::Index>(cells.size()); t < count; ++t)
  {
    cells.push_back(mesh.triangleCells.firstPolygon + t);
  }
  for (const vtkIdType cell : more.cells)
  {
    cells.push_back(firstCell + cell);
  }
  mesh.triangles.conservativeResize(count + more.triangles.rows(), 3);
  mesh.triangles.bottomRows(more.triangles.rows()) = more.triangles;
}

void ReadCells(vtkPolyData* input, SurfaceMesh& mesh)
{
  const vtkIdType points = input->GetNumberOfPoints();
  const vtkIdType firstPolygon = input->GetNumberOfVerts() + input->GetNumberOfLines();
  const vtkIdType firstStrip = firstPolygon + input->GetNumberOfPolys();
  vtkCellArray* polygons = input->GetPolys();
  mesh.triangleCells.firstPolygon = firstPolygon;
  if (polygons->IsHomogeneous() == 3)
  {
    mesh.triangles = ReadTriangles(polygons, firstPolygon, points);
  }
  else if (polygons->GetNumberOfCells() > 0)
  {
    CheckCells(polygons, firstPolygon, 3, points);
    Append(TriangulatePolygons(polygons, input->GetPoints()), firstPolygon, mesh);
  }
  if (input->GetNumberOfStrips() > 0)
  {
    CheckCells(input->GetStrips(), firstStrip, 0, points);
    Append(TriangulateStrips(input->GetStrips()), firstStrip, mesh);
  }
}
}

SurfaceMesh ReadMesh(vtkPolyData* input)
{
  if (input->GetNumberOfPoints() > std::numeric_limits<Index>::max())
  {
    throw InputError(
      "The input has " + std::to_string(input->GetNumberOfPoints()) +
      " points, more than this filter can count. Split it, or use the parallel filter.");
  }
  SurfaceMesh mesh;
  if (input->GetPoints())
  {
    mesh.points = ReadTuples<Points>(input->GetPoints()->GetData());
  }
  FindNotFinite(mesh.points)
    .ThrowIfAny("points have NaN or infinite coordinates", "point", "Remove or repair them.");
  FindHuge(mesh.points)
    .ThrowIfAny("points have coordinates above 1e70", "point", "Remove or scale them.");
  CheckExtent(mesh.points);
  CheckOffsets(input->GetPolys(), "polygons");
  CheckOffsets(input->GetStrips(), "strips");

  ReadCells(input, mesh);
  return mesh;
}

void CheckRange(const Points& positions)
{
  FindNotFinite(positions).ThrowIfAny("points would leave the range of their coordinates", "point",
    "Scale the mesh and the prescribed Laplacians, or convert the points to double.");
}

Vector ReadScalars(vtkDataArray* array, vtkIdType count, const char* kind)
{
  return ReadArray<Vector>(array, count, kind);
}

Vector ReadWeights(vtkDataArray* array, vtkIdType points)
{
  Vector weights = ReadScalars(array, points);
  const Faults negative = FindFaults(weights, [](const auto& row) { return row[0] >= 0; });
  negative.ThrowIfAny(("weights in " + NameOf(array) + " are negative").c_str(), "point",
    "Weights must be 0 or more.");
  FindFaults(weights, [](const auto& row) { return row[0] <= LargestWeight; })
    .ThrowIfAny(
      ("weights in " + NameOf(array) + " are above 1e40").c_str(), "point", "Scale the weights.");
  return weights;
}

Points ReadVectors(vtkDataArray* array, vtkIdType points)
{
  Points vectors = ReadArray<Points>(array, points);
  FindHuge(vectors).ThrowIfAny(
    ("vectors of " + NameOf(array) + " are longer than 1e70").c_str(), "point", "Scale them.");
  return vectors;
}
}
