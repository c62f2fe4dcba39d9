// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TriangleColors_h
#define TriangleColors_h

namespace lmo
{
/// Makes TriangleQuality.json, from 0 to 1, the colours of the arrays of triangle quality, unless
/// the user's settings say otherwise. ParaView calls it when it loads the plugin.
void SetTriangleColors();
}

#endif
