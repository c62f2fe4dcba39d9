// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "PolyDataConversion.h"

#include "../Core/Exceptions.h"
#include "../Core/Parallel.h"
#include "../Core/Quality.h"

#include "vtkArrayDispatch.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArrayRange.h"
#include "vtkDoubleArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <cmath>
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

template <typename Rows>
Faults FindNotFinite(const Rows& rows)
{
  Faults faults;
  if (!rows.allFinite())
  {
    for (Eigen::Index i = 0; i < rows.rows(); ++i)
    {
      if (!rows.row(i).allFinite())
      {
        faults.Add(i);
      }
    }
  }
  return faults;
}

template <typename Rows>
Rows ReadArray(vtkDataArray* array, vtkIdType points)
{
  const std::string name =
    "The point array '" + std::string(array->GetName() ? array->GetName() : "") + "'";
  if (array->GetNumberOfTuples() != points ||
      array->GetNumberOfComponents() != Rows::ColsAtCompileTime)
  {
    std::ostringstream text;
    text << name << " has " << array->GetNumberOfTuples() << " tuples of "
         << array->GetNumberOfComponents() << " components; " << points << " tuples of "
         << Rows::ColsAtCompileTime << " are needed. Choose another array.";
    throw InputError(text.str());
  }
  const Rows rows = ReadTuples<Rows>(array);
  FindNotFinite(rows).ThrowIfAny(("values of " + name + " are NaN or infinite").c_str(), "point",
    "Replace them, for example with vtkArrayCalculator.");
  return rows;
}

/// Appends triangles, after a check of each cell's size and ids.
class TriangleReader
{
public:
  TriangleReader(SurfaceMesh& mesh, vtkIdType triangles)
    : Mesh(mesh)
  {
    mesh.triangles.resize(triangles, 3);
    mesh.cellOfTriangle.resize(triangles);
  }

  void ReadPolygons(vtkCellArray* polygons, vtkIdType firstCell)
  {
    this->ForEachCell(polygons,
      [&](vtkIdType cell, vtkIdType size, const vtkIdType* ids)
      {
        if (size != 3)
        {
          this->NotTriangles.Add(firstCell + cell);
          return;
        }
        this->Append(firstCell + cell, ids[0], ids[1], ids[2]);
      });
  }

  void ReadStrips(vtkCellArray* strips, vtkIdType firstCell)
  {
    this->ForEachCell(strips,
      [&](vtkIdType cell, vtkIdType size, const vtkIdType* ids)
      {
        for (vtkIdType k = 0; k + 2 < size; ++k)
        {
          // Every second triangle of a strip is stored clockwise.
          const vtkIdType odd = k % 2;
          this->Append(firstCell + cell, ids[k], ids[k + 1 + odd], ids[k + 2 - odd]);
        }
      });
  }

  void Finish()
  {
    this->NotTriangles.ThrowIfAny("polygons have other than three corners", "cell",
      "Apply vtkTriangleFilter (Triangulate in ParaView) first.");
    this->OutOfRange.ThrowIfAny(
      "triangles name a point that does not exist", "cell", "Repair the cells of the input.");
  }

private:
  template <typename Visit>
  void ForEachCell(vtkCellArray* cells, const Visit& visit)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
    {
      cells->GetCellAtId(cell, size, ids);
      visit(cell, size, ids);
    }
  }

  void Append(vtkIdType cell, vtkIdType a, vtkIdType b, vtkIdType c)
  {
    const vtkIdType points = this->Mesh.points.rows();
    if (std::min({ a, b, c }) < 0 || std::max({ a, b, c }) >= points)
    {
      this->OutOfRange.Add(cell);
      return;
    }
    this->Mesh.triangles.row(this->Count) << static_cast<Index>(a), static_cast<Index>(b),
      static_cast<Index>(c);
    this->Mesh.cellOfTriangle[this->Count++] = cell;
  }

  SurfaceMesh& Mesh;
  Eigen::Index Count = 0;
  Faults NotTriangles;
  Faults OutOfRange;
};

/// For each cell the least value of its triangles.
Vector MinimumOverCells(const SurfaceMesh& mesh, const Vector& triangleValues, vtkIdType cells)
{
  constexpr double unseen = std::numeric_limits<double>::infinity();
  Vector minimum = Vector::Constant(cells, unseen);
  for (Eigen::Index t = 0; t < triangleValues.size(); ++t)
  {
    double& value = minimum[mesh.cellOfTriangle[t]];
    value = std::min(value, triangleValues[t]);
  }
  return (minimum.array() == unseen).select(UndefinedQuality, minimum);
}

vtkIdType CountStripTriangles(vtkCellArray* strips)
{
  vtkIdType triangles = 0;
  for (vtkIdType cell = 0; cell < strips->GetNumberOfCells(); ++cell)
  {
    triangles += std::max<vtkIdType>(strips->GetCellSize(cell) - 2, 0);
  }
  return triangles;
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
    mesh.points = ReadPoints(input->GetPoints());
  }
  FindNotFinite(mesh.points)
    .ThrowIfAny("points have NaN or infinite coordinates", "point",
      "Remove them, for example with vtkExtractPoints or a threshold.");

  const vtkIdType firstPolygon = input->GetNumberOfVerts() + input->GetNumberOfLines();
  const vtkIdType firstStrip = firstPolygon + input->GetNumberOfPolys();
  TriangleReader reader(mesh, input->GetNumberOfPolys() + CountStripTriangles(input->GetStrips()));
  reader.ReadPolygons(input->GetPolys(), firstPolygon);
  reader.ReadStrips(input->GetStrips(), firstStrip);
  reader.Finish();
  return mesh;
}

Vector ReadScalars(vtkDataArray* array, vtkIdType points)
{
  return ReadArray<Vector>(array, points);
}

Vector ReadWeights(vtkDataArray* array, vtkIdType points)
{
  Vector weights = ReadScalars(array, points);
  Faults negative;
  for (Eigen::Index i = 0; i < weights.size(); ++i)
  {
    if (weights[i] < 0)
    {
      negative.Add(i);
    }
  }
  negative.ThrowIfAny(
    ("weights in the point array '" + std::string(array->GetName()) + "' are negative").c_str(),
    "point", "Weights must be 0 or more.");
  return weights;
}

Points ReadVectors(vtkDataArray* array, vtkIdType points)
{
  return ReadArray<Points>(array, points);
}

vtkSmartPointer<vtkPoints> MakePoints(const Points& points, vtkPoints* input)
{
  auto result = vtkSmartPointer<vtkPoints>::New();
  result->SetDataType(input->GetDataType() == VTK_FLOAT ? VTK_FLOAT : VTK_DOUBLE);
  result->SetNumberOfPoints(points.rows());
  vtkDataArray* data = result->GetData();
  const auto copy = [&](auto* values)
  {
    ParallelFor(static_cast<Index>(points.rows()),
      [&](Index i)
      {
        for (int c = 0; c < 3; ++c)
        {
          values[3 * std::size_t(i) + c] =
            static_cast<std::decay_t<decltype(*values)>>(points(i, c));
        }
      });
  };
  if (result->GetDataType() == VTK_FLOAT)
  {
    copy(static_cast<float*>(data->GetVoidPointer(0)));
  }
  else
  {
    copy(static_cast<double*>(data->GetVoidPointer(0)));
  }
  return result;
}

Points ReadPoints(vtkPoints* points)
{
  return ReadTuples<Points>(points->GetData());
}

vtkSmartPointer<vtkDoubleArray> MakeArray(const char* name, const Vector& values)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  array->SetNumberOfTuples(values.size());
  Eigen::Map<Vector>(array->GetPointer(0), values.size()) = values;
  return array;
}

vtkSmartPointer<vtkDoubleArray> MakeArray(const char* name, const Points& values)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(values.rows());
  Eigen::Map<Points>(array->GetPointer(0), values.rows(), 3) = values;
  return array;
}

vtkSmartPointer<vtkDoubleArray> MakeArray(const char* name, double value)
{
  return MakeArray(name, Vector(Vector::Constant(1, value)));
}

void AddRadiusRatios(
  const char* name, const SurfaceMesh& mesh, const Vector& radiusRatios, vtkPolyData* output)
{
  output->GetCellData()->AddArray(
    MakeArray(name, MinimumOverCells(mesh, radiusRatios, output->GetNumberOfCells())));
  output->GetPointData()->AddArray(MakeArray(
    name, MinimumAtVertices(radiusRatios, mesh.triangles, static_cast<Index>(mesh.points.rows()))));
}

vtkSmartPointer<vtkDataArray> ReplaceNormals(vtkDataArray* input, const Points& normals)
{
  auto result = vtk::TakeSmartPointer(input->NewInstance());
  result->DeepCopy(input);
  for (Eigen::Index i = 0; i < normals.rows(); ++i)
  {
    if (normals.row(i).squaredNorm() > 0)
    {
      result->SetTuple(i, normals.row(i).data());
    }
  }
  return result;
}
}
