// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "PolyDataConversion.h"

#include "CellReading.h"
#include "CoincidentPoints.h"
#include "Core/Base/Threading.h"
#include "Core/Operators/Weights.h"
#include "InputFaults.h"

#include "vtkArrayDispatch.h"
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
  return FindFaults(points, [](const auto& row)
    { return row.allFinite() && row.cwiseAbs().maxCoeff() <= LargestCoordinate; });
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
  FindNotFinite(rows).ThrowIfAny("value of " + name + " is NaN or infinite",
    "values of " + name + " are NaN or infinite", kind,
    "Replace them, for example with vtkArrayCalculator.");
  return rows;
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
    .ThrowIfAny("point has NaN or infinite coordinates", "points have NaN or infinite coordinates",
      "point", "Remove or repair them.");
  FindHuge(mesh.points)
    .ThrowIfAny("point has coordinates above 1e70", "points have coordinates above 1e70", "point",
      "Remove or scale them.");
  CheckExtent(mesh.points);

  SurfaceTriangles cells = ReadTriangles(input);
  mesh.triangles = std::move(cells.triangles);
  mesh.polygons = std::move(cells.polygons);
  mesh.numbering =
    MeshNumbering(input->GetNumberOfPoints(), static_cast<Index>(mesh.triangles.rows()),
      input->GetNumberOfCells(), std::move(cells.triangleCells));
  return mesh;
}

void MergeVertices(SurfaceMesh& mesh, const std::vector<Index>& lowest)
{
  if (lowest.empty())
  {
    return;
  }
  std::vector<Index> kept;
  for (Index i = 0; i < static_cast<Index>(lowest.size()); ++i)
  {
    if (lowest[i] == i)
    {
      kept.push_back(i);
    }
  }
  const std::vector<Index> numbers = mesh.numbering.Merge(lowest);
  mesh.points = ToNewOrder(kept, std::move(mesh.points));
  ParallelFor(static_cast<Index>(mesh.triangles.rows()),
    [&](Index t)
    {
      for (int k = 0; k < 3; ++k)
      {
        mesh.triangles(t, k) = numbers[mesh.triangles(t, k)];
      }
    });
  for (Index& corner : mesh.polygons.corners.ids)
  {
    corner = numbers[corner];
  }
}

void WeldCoincidentPoints(SurfaceMesh& mesh)
{
  MergeVertices(mesh, FindCoincidentBoundaryPoints(mesh.points, mesh.triangles));
}

void RenumberIfScattered(SurfaceMesh& mesh)
{
  if (IsScattered(mesh.triangles))
  {
    const auto vertices = static_cast<Index>(mesh.points.rows());
    const MeshOrder order = BreadthFirstOrder(vertices, mesh.triangles, mesh.polygons);
    mesh.points = ToNewOrder(order.vertices, std::move(mesh.points));
    mesh.triangles = Renumber(order, mesh.triangles);
    mesh.polygons = Renumber(order, mesh.polygons);
    mesh.numbering.Renumber(order);
  }
}

void CheckRange(const Points& positions, const MeshNumbering& numbering)
{
  if (FindHuge(positions).count > 0)
  {
    FindHuge(numbering.ToPoints(positions))
      .ThrowIfAny("point would leave the range of its coordinates",
        "points would leave the range of their coordinates", "point",
        "Scale the mesh and the prescribed Laplacians, or convert the points to double.");
  }
}

Vector ReadScalars(vtkDataArray* array, const MeshNumbering& numbering)
{
  return numbering.ToVertices(ReadArray<Vector>(array, numbering.GetNumberOfPoints()));
}

Vector ReadFlags(vtkDataArray* array, const MeshNumbering& numbering)
{
  return numbering.AnyOfPoints(ReadArray<Vector>(array, numbering.GetNumberOfPoints()));
}

TriangleLabels ReadLabels(vtkDataArray* array, const MeshNumbering& numbering)
{
  using Pairs = Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>;
  const vtkIdType cells = numbering.GetNumberOfCells();
  if (array->GetNumberOfComponents() != 2)
  {
    return numbering.ToTriangles(ReadArray<Vector>(array, cells, "cell"));
  }
  const Pairs pairs = ReadArray<Pairs>(array, cells, "cell");
  TriangleLabels labels(cells, 2);
  labels << pairs.rowwise().minCoeff(), pairs.rowwise().maxCoeff();
  return numbering.ToTriangles(labels);
}

Vector ReadWeights(vtkDataArray* array, const MeshNumbering& numbering)
{
  Vector weights = ReadArray<Vector>(array, numbering.GetNumberOfPoints());
  const Faults negative = FindFaults(weights, [](const auto& row) { return row[0] >= 0; });
  negative.ThrowIfAny("weight in " + NameOf(array) + " is negative",
    "weights in " + NameOf(array) + " are negative", "point", "Weights must be 0 or more.");
  FindFaults(weights, [](const auto& row) { return row[0] <= LargestWeight; })
    .ThrowIfAny("weight in " + NameOf(array) + " is above 1e40",
      "weights in " + NameOf(array) + " are above 1e40", "point", "Scale the weights.");
  return numbering.ToVertices(std::move(weights));
}

Points ReadVectors(vtkDataArray* array, const MeshNumbering& numbering)
{
  Points vectors = ReadArray<Points>(array, numbering.GetNumberOfPoints());
  FindHuge(vectors).ThrowIfAny("vector of " + NameOf(array) + " is longer than 1e70",
    "vectors of " + NameOf(array) + " are longer than 1e70", "point", "Scale them.");
  return numbering.ToVertices(std::move(vectors));
}
}
