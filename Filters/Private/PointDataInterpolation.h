// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef PointDataInterpolation_h
#define PointDataInterpolation_h

#include "Core/Operators/FieldInterpolation.h"
#include "MeshNumbering.h"

#include "vtkSmartPointer.h"

#include <functional>
#include <string>
#include <vector>

class vtkPointData;
class vtkPolyData;

namespace lmo
{
class MeshQuantities;

/// The point data of a surface whose points moved along it: each point takes the values at the
/// point of the input that is closest to it, as WalkToClosestPoint() finds that. Points that did
/// not move keep theirs.
///
/// Floating-point arrays and colours (three or four unsigned chars) are interpolated by barycentric
/// coordinates, floating-point arrays with their gradients as well, and stay within the range of
/// the values around their triangle; the active normals are given
/// unit length again. Other arrays take the values of the nearest corner. Global, pedigree and
/// original ids and the ghost flags stay with the point. Points that are one vertex belong to
/// different sides of a seam if their interpolated arrays, without normals, differ: then each takes
/// the values of its own side.
/// \param mesh that was read from the input
/// \param positions of the mesh's vertices in the output
vtkSmartPointer<vtkPointData> InterpolatePointData(vtkPolyData* input, const MeshQuantities& mesh,
  const MeshNumbering& numbering, const Points& positions);

/// A point array that does not stay with its points.
struct MovingArray
{
  std::string name;
  int components;
  Interpolation how;
};

/// The numeric arrays with names that do not stay with their points.
std::vector<MovingArray> FindMovingArrays(vtkPolyData* input);

/// Values of the vertices at their new places, from their values.
using MoveFieldsAs = std::function<Fields(const Fields&, Interpolation)>;

/// InterpolatePointData() by a function, for a surface of which there is only a piece; strings stay
/// with their points.
/// \param arrays of all pieces, in the same order; those that the input lacks count nevertheless
/// \param move values of the vertices at their new places
vtkSmartPointer<vtkPointData> MoveArrays(vtkPolyData* input, const MeshNumbering& numbering,
  const std::vector<MovingArray>& arrays, const MoveFieldsAs& move);

/// The point data of a surface with triangles at those of its points that are closest to the
/// positions, interpolated likewise; without ids and ghost flags.
/// \param positions a row per point of the output
vtkSmartPointer<vtkPointData> PointDataAt(
  vtkPolyData* surface, const MeshNumbering& numbering, const Points& positions);
}

#endif
