// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "PieceMessage.h"

#include "../Private/ResultArrays.h"
#include "Core/Base/Exceptions.h"

#include "vtkCellData.h"
#include "vtkCharArray.h"
#include "vtkCommunicator.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTypeInt64Array.h"

#include <string>

namespace lmo
{
namespace
{
/// Begins the names of ids that travel as numbers of 64 bits, before the number of their attribute.
const std::string IdPrefix = "vtkLaplacianMeshOptimizerIds";

void RemoveUnnamedArrays(vtkFieldData* data)
{
  for (int k = data->GetNumberOfArrays() - 1; k >= 0; --k)
  {
    if (!data->GetArrayName(k))
    {
      data->RemoveArray(k);
    }
  }
}

/// The format has 32 bits for a vtkIdType.
void WidenIds(vtkDataSetAttributes* data)
{
  for (int k = data->GetNumberOfArrays() - 1; k >= 0; --k)
  {
    auto* ids = vtkIdTypeArray::SafeDownCast(data->GetAbstractArray(k));
    if (ids)
    {
      vtkNew<vtkTypeInt64Array> wide;
      wide->DeepCopy(ids);
      const int attribute = data->IsArrayAnAttribute(k);
      const std::string name =
        IdPrefix + static_cast<char>('a' + 1 + attribute) + std::string(ids->GetName());
      wide->SetName(name.c_str());
      data->RemoveArray(k);
      data->AddArray(wide);
    }
  }
}

void NarrowIds(vtkDataSetAttributes* data)
{
  for (int k = data->GetNumberOfArrays() - 1; k >= 0; --k)
  {
    const std::string name = data->GetArrayName(k) ? data->GetArrayName(k) : "";
    if (name.compare(0, IdPrefix.size(), IdPrefix) == 0)
    {
      vtkNew<vtkIdTypeArray> ids;
      ids->DeepCopy(data->GetAbstractArray(k));
      ids->SetName(name.c_str() + IdPrefix.size() + 1);
      data->RemoveArray(k);
      const int attribute = name[IdPrefix.size()] - 'a' - 1;
      const int index = data->AddArray(ids);
      if (attribute >= 0)
      {
        data->SetActiveAttribute(index, attribute);
      }
    }
  }
}
}

PieceMessage PackPiece(vtkPolyData* piece)
{
  vtkNew<vtkPolyData> copy;
  copy->ShallowCopy(piece);
  RemoveUnnamedArrays(copy->GetPointData()); // they would arrive with names
  RemoveUnnamedArrays(copy->GetCellData());
  RemoveUnnamedArrays(copy->GetFieldData());
  WidenIds(copy->GetPointData());
  WidenIds(copy->GetCellData());
  ResultArrays::ListResults(copy);
  auto message = PieceMessage::New();
  if (!vtkCommunicator::MarshalDataObject(copy, message))
  {
    throw InputError("A piece of the surface cannot be sent to process 0. Remove its arrays that "
                     "are not numbers, or choose a mode that works on pieces.");
  }
  return message;
}

vtkSmartPointer<vtkPolyData> UnpackPiece(vtkCharArray* message)
{
  auto piece = vtkSmartPointer<vtkPolyData>::New();
  vtkCommunicator::UnMarshalDataObject(message, piece);
  NarrowIds(piece->GetPointData());
  NarrowIds(piece->GetCellData());
  ResultArrays::MarkListed(piece);
  return piece;
}
}
