// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_PositionTerm_h
#define lmo_PositionTerm_h

#include "Core/Base/Types.h"

namespace lmo
{
/// |W_p d|^2
struct PositionTerm
{
  Vector weights; ///< diagonal of W_p
};
}

#endif
