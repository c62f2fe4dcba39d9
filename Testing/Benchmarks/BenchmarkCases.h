// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef BenchmarkCases_h
#define BenchmarkCases_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <functional>
#include <limits>
#include <string>
#include <vector>

class vtkPolyData;
class vtkPolyDataAlgorithm;

/// Where the Markdown shows a case.
enum class CaseTable
{
  Triangles, ///< OPTIMIZE_TRIANGLES, and the filters of others
  Smoothing
};

/// A filter with its settings: this module's, or one of others to compare with.
struct Case
{
  std::string name;
  std::string title; ///< for a column of a table
  CaseTable table = CaseTable::Triangles;
  /// A new filter, so that it reuses nothing, ready for the Update() that is measured. Null if it
  /// cannot take the mesh.
  std::function<vtkSmartPointer<vtkPolyDataAlgorithm>(vtkPolyData* mesh)> prepare;
  vtkIdType maximumVertices = std::numeric_limits<vtkIdType>::max(); ///< beyond, it takes too long
  bool hasOutput = true; ///< false: its memory is not comparable
};

/// The case to which the times of all others are compared.
extern const char* const ReferenceCase;

std::vector<Case> AllCases();

#endif
