// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ArrayTransfer_h
#define ArrayTransfer_h

#include "Core/Operators/FieldInterpolation.h"
#include "MeshNumbering.h"

#include "vtkSmartPointer.h"

#include <functional>
#include <vector>

class vtkAbstractArray;
class vtkDataArray;

namespace lmo
{
/// True for floating-point arrays and colours (three or four unsigned chars), whose values are
/// interpolated.
bool IsInterpolated(vtkAbstractArray* array);

/// How an array's values come to new places.
Interpolation HowToInterpolate(vtkAbstractArray* array);

/// Values of the vertices at their new places, from their values.
using MoveFields = std::function<Fields(const Fields&)>;

/// An array with its values at new places, by calls of move() with up to four components each.
/// \param array may be null, for a piece without points: then \a move is called nevertheless
/// \return null if \a array is
vtkSmartPointer<vtkDataArray> ArrayAtPlaces(
  vtkDataArray* array, int components, const MeshNumbering& numbering, const MoveFields& move);

/// Takes point arrays of a surface to locations on it: floating-point arrays are interpolated
/// smoothly, colours linearly, others take the values of the nearest corner. Values without a
/// location stay as they are.
class ArrayTransfer
{
public:
  /// \param size number of locations
  /// \return a copy of the array, which Run() sets
  vtkSmartPointer<vtkAbstractArray> Add(vtkAbstractArray* array, std::size_t size);

  /// \param numbering of the surface's vertices and of the locations
  void Run(const WalkableSurface& surface, const MeshNumbering& numbering,
    const std::vector<SurfaceLocation>& locations) const;

private:
  struct Group
  {
    std::vector<vtkAbstractArray*> from;
    std::vector<vtkSmartPointer<vtkAbstractArray>> to;
  };

  Group Nearest;
  Group Linear;
  Group Smooth;
};
}

#endif
