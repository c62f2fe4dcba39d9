// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ResultChecks_h
#define ResultChecks_h

#include "FilterTesting.h"

/// The two outcomes that the module promises. Each function returns what is wrong, or nothing.

/// The result is finite, complete and consistent; a warning says if it is not solved.
std::string FaultOfResult(vtkLaplacianMeshOptimizer* filter, const Messages& messages);

/// The result is complete, and so are the arrays that the filter adds to the points, and finite.
std::string FaultOfResult(vtkPolyDataAlgorithm* filter, const Messages& messages,
  std::initializer_list<const char*> arrays);

/// The output is empty and the error holds all of \a texts.
std::string FaultOfRefusal(
  vtkPolyDataAlgorithm* filter, const Messages& messages, const std::vector<std::string>& texts);

vtkSmartPointer<vtkPolyData> CopyOf(vtkPolyData* data);

#endif
