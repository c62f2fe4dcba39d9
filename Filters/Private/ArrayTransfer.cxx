// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ArrayTransfer.h"

#include "Core/Base/Threading.h"

#include "vtkArrayDispatch.h"
#include "vtkDataArrayRange.h"
#include "vtkIdList.h"

#include <algorithm>
#include <cmath>

namespace lmo
{
namespace
{
/// The corner with the largest weight, the point itself where there is no triangle.
vtkSmartPointer<vtkIdList> NearestPoints(const Triangles& triangles, const MeshNumbering& numbering,
  const std::vector<SurfaceLocation>& locations)
{
  auto nearest = vtkSmartPointer<vtkIdList>::New();
  nearest->SetNumberOfIds(static_cast<vtkIdType>(locations.size()));
  for (std::size_t i = 0; i < locations.size(); ++i)
  {
    const auto here = static_cast<Index>(i);
    Index vertex = here;
    if (locations[i].triangle >= 0)
    {
      vertex = triangles(locations[i].triangle, locations[i].NearestCorner());
    }
    nearest->SetId(numbering.FirstPointOf(here), numbering.FirstPointOf(vertex));
  }
  return nearest;
}

/// Calls body(tuples, a value) with the values of an array as a range of tuples.
template <typename Body>
struct CallWithTuples
{
  const Body& body;

  template <typename Array>
  void operator()(Array* array) const
  {
    auto tuples = vtk::DataArrayTupleRange(array);
    this->body(tuples, vtk::GetAPIType<Array>());
  }
};

template <typename Body>
void VisitTuples(vtkDataArray* array, const Body& body)
{
  const CallWithTuples<Body> visitor{ body };
  if (!vtkArrayDispatch::DispatchByValueType<vtkArrayDispatch::Reals>::Execute(array, visitor))
  {
    visitor(array);
  }
}

/// A component of an array, and of the one that it is transferred to.
struct Column
{
  vtkDataArray* from;
  vtkDataArray* to;
  int component;
};

/// The values of up to four columns at the vertices, 0 in place of those that are missing.
Fields FieldsOf(const std::vector<Column>& columns, const MeshNumbering& numbering)
{
  Fields fields(columns[0].from->GetNumberOfTuples(), int(Fields::ColsAtCompileTime));
  const auto size = static_cast<Index>(fields.rows());
  ParallelFor(size, [&](Index i) { fields.row(i).setZero(); });
  for (std::size_t k = 0; k < columns.size(); ++k)
  {
    const int component = columns[k].component;
    VisitTuples(columns[k].from,
      [&](const auto& tuples, auto)
      {
        ParallelFor(size, [&](Index i)
          { fields(i, k) = static_cast<double>(tuples[numbering.FirstPointOf(i)][component]); });
      });
  }
  return fields;
}

/// Sets the values of points that moved.
/// \param hasMoved hasMoved(i) for each of them
/// \param isRounded to whole numbers
template <typename HasMoved>
void SetValues(const Fields& fields, const MeshNumbering& numbering, const HasMoved& hasMoved,
  const std::vector<Column>& columns, bool isRounded)
{
  for (std::size_t k = 0; k < columns.size(); ++k)
  {
    const int component = columns[k].component;
    VisitTuples(columns[k].to,
      [&](auto& tuples, auto zero)
      {
        using Value = decltype(zero);
        ParallelFor(static_cast<Index>(fields.rows()),
          [&](Index i)
          {
            if (hasMoved(i))
            {
              const double value = fields(i, k);
              tuples[numbering.FirstPointOf(i)][component] =
                static_cast<Value>(isRounded ? std::round(value) : value);
            }
          });
      });
  }
}

/// Calls transfer(columns) for all components of numeric arrays, as many as Fields holds at once.
template <typename Arrays, typename Copies, typename Transfer>
void ForEachGroupOfColumns(const Arrays& from, const Copies& to, const Transfer& transfer)
{
  std::vector<Column> columns;
  for (std::size_t k = 0; k < from.size(); ++k)
  {
    vtkDataArray* array = vtkDataArray::FastDownCast(from[k]);
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
    {
      columns.push_back({ array, vtkDataArray::FastDownCast(to[k]), c });
      if (columns.size() == Fields::ColsAtCompileTime)
      {
        transfer(columns);
        columns.clear();
      }
    }
  }
  if (!columns.empty())
  {
    transfer(columns);
  }
}

/// A copy of an array with so many values.
vtkSmartPointer<vtkAbstractArray> CopyFor(vtkAbstractArray* array, vtkIdType size)
{
  auto copy = vtk::TakeSmartPointer(array->NewInstance());
  copy->DeepCopy(array);
  if (copy->GetNumberOfTuples() != size)
  {
    copy->SetNumberOfTuples(size);
  }
  return copy;
}

}

bool IsInterpolated(vtkAbstractArray* array)
{
  const int type = array->GetDataType();
  const int components = array->GetNumberOfComponents();
  const bool isColour = type == VTK_UNSIGNED_CHAR && (components == 3 || components == 4);
  return vtkDataArray::FastDownCast(array) && (type == VTK_FLOAT || type == VTK_DOUBLE || isColour);
}

Interpolation HowToInterpolate(vtkAbstractArray* array)
{
  return !IsInterpolated(array)                      ? Interpolation::NEAREST
         : array->GetDataType() == VTK_UNSIGNED_CHAR ? Interpolation::LINEAR
                                                     : Interpolation::SMOOTH;
}

vtkSmartPointer<vtkAbstractArray> ArrayTransfer::Add(vtkAbstractArray* array, std::size_t size)
{
  const Interpolation how = HowToInterpolate(array);
  Group& group = how == Interpolation::NEAREST  ? this->Nearest
                 : how == Interpolation::LINEAR ? this->Linear
                                                : this->Smooth;
  group.from.push_back(array);
  group.to.push_back(CopyFor(array, static_cast<vtkIdType>(size)));
  return group.to.back();
}

void ArrayTransfer::Run(const WalkableSurface& surface, const MeshNumbering& numbering,
  const std::vector<SurfaceLocation>& locations) const
{
  if (!this->Nearest.from.empty())
  {
    const vtkSmartPointer<vtkIdList> nearest =
      NearestPoints(surface.triangles, numbering, locations);
    for (std::size_t k = 0; k < this->Nearest.from.size(); ++k)
    {
      this->Nearest.from[k]->GetTuples(nearest, this->Nearest.to[k]);
    }
  }
  const auto hasMoved = [&](Index i) { return locations[i].triangle >= 0; };
  const auto transfer = [&](const Group& group, Interpolation how)
  {
    ForEachGroupOfColumns(group.from, group.to,
      [&](const std::vector<Column>& columns)
      {
        const Fields fields = FieldsOf(columns, numbering);
        SetValues(InterpolateFields(surface, fields, locations, how), numbering, hasMoved, columns,
          how == Interpolation::LINEAR);
      });
  };
  transfer(this->Linear, Interpolation::LINEAR);
  transfer(this->Smooth, Interpolation::SMOOTH);
}

vtkSmartPointer<vtkDataArray> ArrayAtPlaces(
  vtkDataArray* array, int components, const MeshNumbering& numbering, const MoveFields& move)
{
  const auto everywhere = [](Index) { return true; };
  vtkSmartPointer<vtkDataArray> moved;
  if (array)
  {
    moved = vtkDataArray::FastDownCast(CopyFor(array, array->GetNumberOfTuples()));
  }
  constexpr int group = Fields::ColsAtCompileTime;
  for (int first = 0; first < components; first += group)
  {
    std::vector<Column> columns;
    for (int c = first; array && c < std::min(first + group, components); ++c)
    {
      columns.push_back({ array, moved, c });
    }
    const Fields fields = move(array ? FieldsOf(columns, numbering) : Fields(0, group));
    if (array)
    {
      SetValues(fields, numbering, everywhere, columns, array->GetDataType() == VTK_UNSIGNED_CHAR);
    }
  }
  return moved;
}
}
