// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef CellNormals_h
#define CellNormals_h

#include "Core/Base/Types.h"

class vtkPolyData;

namespace lmo
{
/// Unit normals of polygons and strips in the direction in which they are counter-clockwise:
/// vertices and lines, and cells without area, have 0.
/// \param mesh has points and cells that ReadMesh() accepts
Points CellNormals(vtkPolyData* mesh);
}

#endif
