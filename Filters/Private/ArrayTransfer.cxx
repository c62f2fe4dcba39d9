// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ArrayTransfer.h"

#include "Core/Base/Threading.h"

#include "vtkArrayDispatch.h"
#include "vtkDataArrayRange.h"
#include "vtkIdList.h"

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
      Index corner = 0;
      locations[i].weights.maxCoeff(&corner);
      vertex = triangles(locations[i].triangle, corner);
    }
    nearest->SetId(numbering.FirstPointOf(here), numbering.FirstPointOf(vertex));
  }
  return nearest;
}

/// Calls body(values, component) for each component of an array, with its values as a range.
template <typename Body>
struct ForEachComponent
{
  const Body& body;

  template <typename Array>
  void operator()(Array* array) const
  {
    auto values = vtk::DataArrayTupleRange(array);
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
    {
      this->body(values, c, vtk::GetAPIType<Array>());
    }
  }
};

template <typename Body>
void VisitComponents(vtkDataArray* array, const Body& body)
{
  const ForEachComponent<Body> visitor{ body };
  if (!vtkArrayDispatch::DispatchByValueType<vtkArrayDispatch::Reals>::Execute(array, visitor))
  {
    visitor(array);
  }
}

/// The components of the arrays as columns, a row for each vertex.
Fields FieldsOf(const std::vector<vtkDataArray*>& arrays, const MeshNumbering& numbering)
{
  int columns = 0;
  for (vtkDataArray* array : arrays)
  {
    columns += array->GetNumberOfComponents();
  }
  Fields fields(arrays.empty() ? 0 : arrays[0]->GetNumberOfTuples(), columns);
  int column = 0;
  for (vtkDataArray* array : arrays)
  {
    VisitComponents(array,
      [&](const auto& values, int c, auto)
      {
        ParallelFor(static_cast<Index>(fields.rows()), [&](Index i)
          { fields(i, column) = static_cast<double>(values[numbering.FirstPointOf(i)][c]); });
        ++column;
      });
  }
  return fields;
}

/// Sets the values of points that moved.
/// \param isRounded to whole numbers
void SetValues(const Fields& fields, const MeshNumbering& numbering,
  const std::vector<SurfaceLocation>& locations, const std::vector<vtkDataArray*>& arrays,
  bool isRounded)
{
  int column = 0;
  for (vtkDataArray* array : arrays)
  {
    VisitComponents(array,
      [&](auto& values, int c, auto zero)
      {
        using Value = decltype(zero);
        ParallelFor(static_cast<Index>(fields.rows()),
          [&](Index i)
          {
            if (locations[i].triangle >= 0)
            {
              const double value = fields(i, column);
              values[numbering.FirstPointOf(i)][c] =
                static_cast<Value>(isRounded ? std::round(value) : value);
            }
          });
        ++column;
      });
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

/// The arrays, all of which are numeric.
template <typename Arrays>
std::vector<vtkDataArray*> Numeric(const Arrays& arrays)
{
  std::vector<vtkDataArray*> numeric;
  numeric.reserve(arrays.size());
  for (vtkAbstractArray* array : arrays)
  {
    numeric.push_back(vtkDataArray::FastDownCast(array));
  }
  return numeric;
}
}

bool IsInterpolated(vtkAbstractArray* array)
{
  const int type = array->GetDataType();
  const int components = array->GetNumberOfComponents();
  const bool isColour = type == VTK_UNSIGNED_CHAR && (components == 3 || components == 4);
  return vtkDataArray::FastDownCast(array) && (type == VTK_FLOAT || type == VTK_DOUBLE || isColour);
}

vtkSmartPointer<vtkAbstractArray> ArrayTransfer::Add(vtkAbstractArray* array, std::size_t size)
{
  Group& group = !IsInterpolated(array)                      ? this->Nearest
                 : array->GetDataType() == VTK_UNSIGNED_CHAR ? this->Linear
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
  const Fields linear = FieldsOf(Numeric(this->Linear.from), numbering);
  SetValues(InterpolateLinearly(surface.triangles, linear, locations), numbering, locations,
    Numeric(this->Linear.to), true);
  const Fields smooth = FieldsOf(Numeric(this->Smooth.from), numbering);
  SetValues(InterpolateSmoothly(surface, smooth, locations), numbering, locations,
    Numeric(this->Smooth.to), false);
}
}
