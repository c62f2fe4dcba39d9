// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef PieceOfMesh_h
#define PieceOfMesh_h

#include "../Private/PolyDataConversion.h"
#include "HaloTriangles.h"

class vtkMultiProcessController;
class vtkPolyData;

namespace lmo
{
/// What this process brings along to a distributed mesh: without triangles that are marked as
/// duplicates, and with ids by which points of all processes are the same one, those of the input
/// or, if a process has none, by coordinates. Collective.
/// \param mesh of the input; its points are moved out
Piece TakePiece(vtkPolyData* input, SurfaceMesh& mesh, const Communicator& comm,
  vtkMultiProcessController* controller);
}

#endif
