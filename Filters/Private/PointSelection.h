// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef PointSelection_h
#define PointSelection_h

#include "Core/Base/Types.h"

class vtkPolyData;
class vtkSelection;

namespace lmo
{
/// 1 for each point that is selected itself or by one of its cells, 0 for all others.
/// \throw InputError if the selection is a query, names blocks of a composite data set, or mixes
/// points and cells.
Vector SelectedPoints(vtkPolyData* mesh, vtkSelection* selection);
}

#endif
