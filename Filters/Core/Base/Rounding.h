// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_Rounding_h
#define lmo_Rounding_h

#include "Core/Base/Types.h"

namespace lmo
{
/// Each coordinate rounded to single precision.
inline Vector3 RoundToFloat(const Vector3& x)
{
  Vector3 rounded;
  for (int k = 0; k < 3; ++k)
  {
    // volatile, as GCC 12 at -O3 drops two conversions to float and back side by side.
    volatile const float single = static_cast<float>(x[k]);
    rounded[k] = single;
  }
  return rounded;
}
}

#endif
