// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef PieceMessage_h
#define PieceMessage_h

#include "vtkSmartPointer.h"

class vtkCharArray;
class vtkPolyData;

namespace lmo
{
/// A surface as it is sent to another process: in VTK's legacy format, and so that nothing is lost
/// which that format leaves out: marks of results, and ids of more than 32 bits. Arrays without
/// names stay behind.
using PieceMessage = vtkSmartPointer<vtkCharArray>;

/// \throw InputError if the piece cannot be written.
PieceMessage PackPiece(vtkPolyData* piece);

vtkSmartPointer<vtkPolyData> UnpackPiece(vtkCharArray* message);
}

#endif
