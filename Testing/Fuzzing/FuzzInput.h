// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef FuzzInput_h
#define FuzzInput_h

#include "vtkSmartPointer.h"

#include <cstddef>
#include <cstdint>

class vtkLaplacianMeshOptimizer;
class vtkPolyData;

/// Choices made by bytes, one after the other; 0 when they are used up.
class FuzzBytes
{
public:
  FuzzBytes(const std::uint8_t* data, std::size_t size)
    : Next(data)
    , End(data + size)
  {
  }

  /// 0 to \a count - 1.
  int Take(int count) { return this->Byte() % count; }

  /// Mostly a multiple of 1/16 from -4 to 4; sometimes NaN, infinite, huge or tiny.
  double Number();

private:
  int Byte() { return this->Next < this->End ? *this->Next++ : 0; }

  const std::uint8_t* Next;
  const std::uint8_t* End;
};

/// A mesh with some points moved, some cells of any kind, right and wrong ids, and arrays.
vtkSmartPointer<vtkPolyData> MakeFuzzMesh(FuzzBytes& bytes);

/// Sets all properties, also to values that are out of range.
void SetUp(vtkLaplacianMeshOptimizer* filter, FuzzBytes& bytes);

#endif
