// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "GatheredPieces.h"

#include "PieceMessage.h"

#include "vtkCellData.h"
#include "vtkCharArray.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <memory>

namespace lmo
{
namespace
{
constexpr int PieceTag = 190719;

std::vector<PieceMessage> PackAll(const Communicator& comm, const SurfacePieces& pieces)
{
  std::vector<PieceMessage> messages;
  comm.Try(
    [&] { std::transform(pieces.begin(), pieces.end(), std::back_inserter(messages), PackPiece); });
  return messages;
}

vtkSmartPointer<vtkPolyData> Receive(vtkMultiProcessController* controller, int rank)
{
  vtkNew<vtkCharArray> message;
  controller->Receive(message, rank, PieceTag);
  return UnpackPiece(message);
}

/// A piece with the points and arrays of what it became. What cannot be sent is that of the piece.
vtkSmartPointer<vtkPolyData> Renewed(vtkPolyData* piece, vtkPolyData* changed)
{
  auto renewed = vtkSmartPointer<vtkPolyData>::New();
  renewed->ShallowCopy(piece);
  renewed->SetPoints(changed->GetPoints());
  const auto replace = [](vtkFieldData* data, vtkFieldData* by)
  {
    for (int k = 0; k < by->GetNumberOfArrays(); ++k)
    {
      data->AddArray(by->GetAbstractArray(k));
    }
  };
  replace(renewed->GetPointData(), changed->GetPointData());
  replace(renewed->GetCellData(), changed->GetCellData());
  renewed->GetFieldData()->ShallowCopy(changed->GetFieldData());
  return renewed;
}
}

bool GatheredPieces::Source::operator==(vtkPolyData* piece) const
{
  return this->data == piece && this->time == piece->GetMTime();
}

const SurfacePieces& GatheredPieces::Gather(
  vtkMultiProcessController* controller, const Communicator& comm, const SurfacePieces& pieces)
{
  const bool isOld = this->HasGathered && std::equal(this->Sources.begin(), this->Sources.end(),
                                            pieces.begin(), pieces.end());
  if (comm.Maximum(!isOld) == 0)
  {
    return this->Pieces;
  }
  this->HasGathered = false;
  this->Pieces.clear();
  this->Counts = comm.Join(std::vector<int>{ static_cast<int>(pieces.size()) });
  const std::vector<PieceMessage> messages =
    PackAll(comm, comm.Rank() > 0 ? pieces : SurfacePieces());
  for (const PieceMessage& message : messages)
  {
    controller->Send(message, 0, PieceTag);
  }
  if (comm.Rank() == 0)
  {
    this->Pieces = pieces;
    for (int rank = 1; rank < comm.Size(); ++rank)
    {
      for (int k = 0; k < this->Counts[rank]; ++k)
      {
        this->Pieces.push_back(Receive(controller, rank));
      }
    }
  }
  this->Sources.clear();
  for (vtkPolyData* piece : pieces)
  {
    this->Sources.push_back({ piece, piece->GetMTime() });
  }
  this->HasGathered = true;
  return this->Pieces;
}

SurfacePieces GatheredPieces::Return(vtkMultiProcessController* controller,
  const Communicator& comm, const SurfacePieces& changed, const SurfacePieces& pieces) const
{
  if (comm.Rank() > 0)
  {
    comm.Try([] {});
    SurfacePieces mine;
    for (vtkPolyData* piece : pieces)
    {
      mine.push_back(Renewed(piece, Receive(controller, 0)));
    }
    return mine;
  }
  const auto own = changed.begin() + static_cast<std::ptrdiff_t>(pieces.size());
  const std::vector<PieceMessage> messages = PackAll(comm, { own, changed.end() });
  auto message = messages.begin();
  for (int rank = 1; rank < comm.Size(); ++rank)
  {
    for (int k = 0; k < this->Counts[rank]; ++k)
    {
      controller->Send(*message++, rank, PieceTag);
    }
  }
  return { changed.begin(), own };
}
}
