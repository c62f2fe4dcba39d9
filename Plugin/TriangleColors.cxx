// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "TriangleColors.h"

#include "TriangleColorSettings.h" // made by CMake

#include "vtkSMSettings.h"

namespace lmo
{
void SetTriangleColors()
{
  // ParaView's own settings have 0, those of a site 1.
  constexpr double priority = 0.5;
  vtkSMSettings::GetInstance()->AddCollectionFromString(TriangleColorSettings, priority);
}
}
