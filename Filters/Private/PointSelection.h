// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef PointSelection_h
#define PointSelection_h

#include "Core/Base/Types.h"

#include <optional>

class vtkDataSet;
class vtkSelection;

namespace lmo
{
/// 1 for each point that is selected itself or by one of its cells, 0 for all others.
/// \param block flat index if the data set is a block of a composite data set, whose other blocks
/// the selection may name
/// \throw InputError if the selection is a query, names blocks where there are none or in another
/// way than by their flat index, or mixes points and cells.
Vector SelectedPoints(vtkDataSet* data, vtkSelection* whole, std::optional<unsigned int> block);
}

#endif
