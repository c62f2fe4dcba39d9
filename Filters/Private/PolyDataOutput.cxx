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

#include <algorithm>
#include <sstream>
#include <utility>

namespace lmo
{
namespace
{
template <typename Rows>
vtkSmartPointer<vtkDoubleArray> MoveRows(const char* name, Rows rows)
{
  constexpr int columns = Rows::ColsAtCompileTime;
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(columns);
  array->SetNumberOfTuples(rows.rows());
  ParallelRanges(static_cast<Index>(rows.rows()),
    [from = rows.data(), to = array->GetPointer(0)](std::ptrdiff_t begin, std::ptrdiff_t end)
    { std::copy(from + columns * begin, from + columns * end, to + columns * begin); });
  return array;
}
}

vtkSmartPointer<vtkPoints> MakePoints(Points points, vtkPoints* input)
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

vtkSmartPointer<vtkDoubleArray> MakeArray(const char* name, Vector values)
{
  return MoveRows(name, std::move(values));
}

vtkSmartPointer<vtkDoubleArray> MakeArray(const char* name, Points values)
{
  return MoveRows(name, std::move(values));
}

vtkSmartPointer<vtkDoubleArray> MakeArray(const char* name, double value)
{
  return MakeArray(name, Vector(Vector::Constant(1, value)));
}

void AddRadiusRatios(const char* name, const MeshQuality& quality,
  const TriangleCells& triangleCells, ResultArrays& results, vtkPolyData* output)
{
  const vtkIdType count = output->GetNumberOfCells();
  if (triangleCells.cells.empty() && count == quality.triangles.size())
  {
    results.Add(output->GetCellData(), MakeArray(name, quality.triangles));
  }
  else
  {
    Vector cells = Vector::Constant(count, UndefinedQuality);
    for (Index t = 0; t < quality.triangles.size(); ++t)
    {
      double& cell = cells[triangleCells(t)];
      cell = cell == UndefinedQuality ? quality.triangles[t] : std::min(cell, quality.triangles[t]);
    }
    results.Add(output->GetCellData(), MakeArray(name, std::move(cells)));
  }
  results.Add(output->GetPointData(), MakeArray(name, quality.vertices));
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
      [&](Index i)
      {
        for (int c = 0; c < 3 && normals.row(i).squaredNorm() > 0; ++c)
        {
          tuples[i][c] = static_cast<vtk::GetAPIType<Array>>(normals(i, c));
        }
      });
  }
};
}

vtkSmartPointer<vtkDataArray> ReplaceNormals(
  vtkDataArray* input, const Points& normals, const char* kind)
{
  if (input->GetNumberOfTuples() != normals.rows() || input->GetNumberOfComponents() != 3)
  {
    std::ostringstream text;
    text << "The " << kind << " array '" << (input->GetName() ? input->GetName() : "")
         << "' of normals has " << input->GetNumberOfTuples() << " tuples of "
         << input->GetNumberOfComponents() << " components; " << normals.rows()
         << " tuples of 3 are needed. Repair or remove them.";
    throw InputError(text.str());
  }
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
