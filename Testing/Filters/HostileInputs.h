// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef HostileInputs_h
#define HostileInputs_h

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkPolyData;

/// An input that breaks filters, and what this module has to make of it.
struct HostileInput
{
  std::string name;
  vtkSmartPointer<vtkPolyData> data; ///< with the point arrays "Weights" and "Vectors"
  /// What the error says: what, how many, the first id and the remedy. Empty: a finite result.
  std::vector<std::string> errors;
  bool isLarge = false; ///< too slow for every combination of options
};

/// One of each kind, made in code.
std::vector<HostileInput> HostileInputs();

#endif
