// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "PolyDataOutput.h"

#include "Core/Base/Exceptions.h"
#include "Core/Base/Threading.h"

#include "vtkArrayDispatch.h"
#include "vtkCellData.h"
#include "vtkDataArrayRange.h"
#include "vtkDoubleArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <sstream>
#include <utility>

namespace lmo
{
namespace
{
vtkSmartPointer<vtkDoubleArray> NewArray(const char* name, int components, vtkIdType tuples)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  return array;
}

/// Writes the rows of vertices to the points.
template <typename Rows, typename Scalar>
void WriteRows(const Rows& rows, const MeshNumbering& numbering, Scalar* values)
{
  constexpr int columns = Rows::ColsAtCompileTime;
  ParallelFor(static_cast<Index>(numbering.GetNumberOfPoints()),
    [&](Index point)
    {
      const Index vertex = numbering.VertexOf(point);
      for (int c = 0; c < columns; ++c)
      {
        values[columns * std::ptrdiff_t(point) + c] = static_cast<Scalar>(rows(vertex, c));
      }
    });
}

template <typename Rows>
vtkSmartPointer<vtkDoubleArray> MoveRows(
  const char* name, Rows rows, const MeshNumbering& numbering)
{
  auto array = NewArray(name, Rows::ColsAtCompileTime, numbering.GetNumberOfPoints());
  WriteRows(rows, numbering, array->GetPointer(0));
  return array;
}
}

vtkSmartPointer<vtkPoints> MakePoints(
  const Points& positions, const MeshNumbering& numbering, vtkPoints* input)
{
  auto result = vtkSmartPointer<vtkPoints>::New();
  result->SetDataType(input->GetDataType() == VTK_FLOAT ? VTK_FLOAT : VTK_DOUBLE);
  result->SetNumberOfPoints(numbering.GetNumberOfPoints());
  vtkDataArray* data = result->GetData();
  if (result->GetDataType() == VTK_FLOAT)
  {
    WriteRows(positions, numbering, static_cast<float*>(data->GetVoidPointer(0)));
  }
  else
  {
    WriteRows(positions, numbering, static_cast<double*>(data->GetVoidPointer(0)));
  }
  return result;
}

vtkSmartPointer<vtkDoubleArray> MakeArray(
  const char* name, Vector values, const MeshNumbering& numbering)
{
  return MoveRows(name, std::move(values), numbering);
}

vtkSmartPointer<vtkDoubleArray> MakeArray(
  const char* name, Points values, const MeshNumbering& numbering)
{
  return MoveRows(name, std::move(values), numbering);
}

vtkSmartPointer<vtkDoubleArray> MakeArray(const char* name, double value)
{
  auto array = NewArray(name, 1, 1);
  array->SetValue(0, value);
  return array;
}

void AddCellFlags(const char* name, const Mask& isMarked, const MeshNumbering& numbering,
  ResultArrays& results, vtkPolyData* output)
{
  const Mask ofCells = numbering.AnyOfCells(isMarked);
  auto cells = vtkSmartPointer<vtkUnsignedCharArray>::New();
  cells->SetName(name);
  cells->SetNumberOfTuples(static_cast<vtkIdType>(ofCells.size()));
  std::copy(ofCells.begin(), ofCells.end(), cells->GetPointer(0));
  results.Add(output->GetCellData(), cells);
}

std::string AddRadiusRatios(const char* name, const MeshQuality& quality,
  const MeshNumbering& numbering, ResultArrays& results, vtkPolyData* output)
{
  const Vector ofCells = numbering.LeastOfCells(quality.triangles, UndefinedQuality);
  auto cells = NewArray(name, 1, ofCells.size());
  std::copy(ofCells.begin(), ofCells.end(), cells->GetPointer(0));
  results.Add(output->GetCellData(), cells);
  results.Add(output->GetPointData(), MakeArray(name, quality.vertices, numbering));
  return cells->GetName();
}

namespace
{
struct ReplaceTuples
{
  template <typename Array>
  void operator()(Array* array, const Points& normals) const
  {
    auto tuples = vtk::DataArrayTupleRange<3>(array);
    ParallelFor(static_cast<Index>(normals.rows()),
      [&](Index point)
      {
        const Vector3 normal = normals.row(point);
        for (int c = 0; c < 3 && normal.squaredNorm() > 0; ++c)
        {
          tuples[point][c] = static_cast<vtk::GetAPIType<Array>>(normal[c]);
        }
      });
  }
};
}

void CheckNormals(vtkDataArray* normals, vtkIdType count, const char* kind)
{
  if (normals->GetNumberOfTuples() != count || normals->GetNumberOfComponents() != 3)
  {
    std::ostringstream text;
    text << "The " << kind << " array '" << (normals->GetName() ? normals->GetName() : "")
         << "' of normals has " << normals->GetNumberOfTuples() << " tuples of "
         << normals->GetNumberOfComponents() << " components; " << count
         << " tuples of 3 are needed. Repair or remove them.";
    throw InputError(text.str());
  }
}

vtkSmartPointer<vtkDataArray> ReplaceNormals(vtkDataArray* input, const Points& normals)
{
  auto result = vtk::TakeSmartPointer(input->NewInstance());
  result->DeepCopy(input);
  if (!vtkArrayDispatch::DispatchByValueType<vtkArrayDispatch::Reals>::Execute(
        result.Get(), ReplaceTuples{}, normals))
  {
    ReplaceTuples{}(result.Get(), normals);
  }
  return result;
}
}
