// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "DistributedSession.h"

#include "../Private/FilterSupport.h"
#include "../Private/OptimizerTables.h"
#include "DistributedOptimizer.h"
#include "GatheringRule.h"
#include "PieceOfMesh.h"

#include "vtkMPI.h"
#include "vtkMPICommunicator.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <map>
#include <thread>
#include <type_traits>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

namespace
{
/// A monitor that stops in all processes if one is asked to stop.
class CollectiveMonitor : public lmo::FilterMonitor
{
public:
  CollectiveMonitor(vtkAlgorithm* filter, const lmo::Communicator& comm)
    : FilterMonitor(filter)
    , Comm(comm)
    , Own(filter)
  {
  }

  ProgressMonitor& OfThisProcess() override { return this->Own; }

protected:
  bool IsCancelled() override { return this->Comm.Maximum(this->FilterMonitor::IsCancelled()) > 0; }

private:
  const lmo::Communicator Comm;
  FilterMonitor Own;
};

/// The places of the blocks and whether they are partitioned, as numbers that can be sent.
std::vector<unsigned int> Describe(const std::vector<lmo::SurfaceBlock>& blocks)
{
  std::vector<unsigned int> numbers;
  for (const lmo::SurfaceBlock& block : blocks)
  {
    numbers.push_back(block.isPartitioned);
    numbers.push_back(static_cast<unsigned int>(block.path.size()));
    numbers.insert(numbers.end(), block.path.begin(), block.path.end());
  }
  return numbers;
}

/// While it lives, process 0 works alone; at its end, all processes meet.
class TimeAlone
{
public:
  TimeAlone(const lmo::Communicator& comm, bool& isAlone)
    : End(comm)
    , IsAlone(isAlone)
  {
    isAlone = true;
  }
  ~TimeAlone() { this->IsAlone = false; }
  TimeAlone(const TimeAlone&) = delete;
  void operator=(const TimeAlone&) = delete;

private:
  const lmo::Meeting End;
  bool& IsAlone;
};
}

vtkPLaplacianMeshOptimizer::DistributedSession::DistributedSession(
  vtkPLaplacianMeshOptimizer* filter)
  : Session(filter)
  , ParallelFilter(filter)
{
}

MPI_Comm vtkPLaplacianMeshOptimizer::DistributedSession::CommunicatorOf(
  vtkMultiProcessController* controller)
{
  auto* communicator =
    controller ? vtkMPICommunicator::SafeDownCast(controller->GetCommunicator()) : nullptr;
  const bool isDistributed = communicator && controller->GetNumberOfProcesses() > 1;
  return isDistributed ? *communicator->GetMPIComm()->GetHandle() : MPI_COMM_NULL;
}

int vtkPLaplacianMeshOptimizer::DistributedSession::NumberOfThreads(
  vtkPLaplacianMeshOptimizer* filter)
{
  const lmo::Communicator comm(CommunicatorOf(filter->GetController()));
  const bool isGathered = lmo::NeedsOneProcess(filter, comm);
  const int processes = comm.SizeOnComputer();
  const int processors = static_cast<int>(std::thread::hardware_concurrency()); // 0 if unknown
  return isGathered && comm.Rank() == 0 ? std::max(1, std::min(processes, processors)) : 1;
}

bool vtkPLaplacianMeshOptimizer::DistributedSession::IsDistributed() const
{
  return !this->IsAlone && CommunicatorOf(this->ParallelFilter->GetController()) != MPI_COMM_NULL;
}

lmo::Communicator vtkPLaplacianMeshOptimizer::DistributedSession::GetCommunicator() const
{
  return lmo::Communicator(CommunicatorOf(this->ParallelFilter->GetController()));
}

void vtkPLaplacianMeshOptimizer::DistributedSession::CheckPieces(int pieces) const
{
  if (!this->IsDistributed())
  {
    this->Session::CheckPieces(pieces);
  }
}

void vtkPLaplacianMeshOptimizer::DistributedSession::Try(const std::function<void()>& body) const
{
  if (this->IsDistributed())
  {
    this->GetCommunicator().Try(body);
  }
  else
  {
    body();
  }
}

std::unique_ptr<lmo::ProgressMonitor> vtkPLaplacianMeshOptimizer::DistributedSession::MakeMonitor()
  const
{
  if (!this->IsDistributed())
  {
    return this->Session::MakeMonitor();
  }
  return std::make_unique<CollectiveMonitor>(this->Filter, this->GetCommunicator());
}

std::vector<lmo::SurfaceBlock> vtkPLaplacianMeshOptimizer::DistributedSession::FindBlocks(
  vtkDataObject* data) const
{
  std::vector<lmo::SurfaceBlock> own = this->Session::FindBlocks(data);
  if (!this->IsDistributed())
  {
    return own;
  }
  std::map<std::vector<unsigned int>, lmo::SurfaceBlock> blocks;
  const std::vector<unsigned int> numbers = this->GetCommunicator().Join(Describe(own));
  for (auto number = numbers.begin(); number != numbers.end();)
  {
    const bool isPartitioned = *number++ != 0;
    const unsigned int length = *number++;
    lmo::SurfaceBlock& block = blocks[{ number, number + length }];
    block.path.assign(number, number + length);
    block.isPartitioned = block.isPartitioned || isPartitioned;
    number += length;
  }
  for (lmo::SurfaceBlock& block : own)
  {
    blocks[block.path].parts = std::move(block.parts);
  }
  std::vector<lmo::SurfaceBlock> all;
  all.reserve(blocks.size());
  for (auto& [path, block] : blocks)
  {
    all.push_back(std::move(block));
  }
  return all;
}

lmo::SurfacePieces vtkPLaplacianMeshOptimizer::DistributedSession::Optimize(const Job& job)
{
  if (!this->IsDistributed())
  {
    return this->Session::Optimize(job);
  }
  this->Try([&] { this->ReadOptions(vtkNew<vtkPolyData>()); }); // which checks them
  if (lmo::NeedsOneProcess(this->ParallelFilter, this->GetCommunicator()))
  {
    return this->OptimizeGathered(job);
  }
  this->Input = lmo::GatheredPieces();
  this->ReferenceInput = lmo::GatheredPieces();
  return this->OptimizeJoined(job, lmo::Joining::SIDE_BY_SIDE);
}

vtkLaplacianMeshOptimizer::Session::Job vtkPLaplacianMeshOptimizer::DistributedSession::Gather(
  const Job& job)
{
  const lmo::Communicator comm = this->GetCommunicator();
  vtkMultiProcessController* controller = this->ParallelFilter->GetController();
  Job whole;
  whole.path = job.path;
  whole.isPartitioned = true;
  whole.pieces = this->Input.Gather(controller, comm, job.pieces);
  if (comm.Maximum(!job.reference.empty()) > 0)
  {
    whole.reference = this->ReferenceInput.Gather(controller, comm, job.reference);
  }
  if (comm.Maximum(job.isSelected.has_value()) > 0)
  {
    std::vector<double> isSelected;
    for (vtkPolyData* piece : job.pieces)
    {
      isSelected.resize(isSelected.size() + piece->GetNumberOfPoints(), 0);
    }
    if (job.isSelected)
    {
      isSelected.assign(job.isSelected->begin(), job.isSelected->end());
    }
    isSelected = comm.Gather(std::move(isSelected));
    whole.isSelected = Eigen::Map<const lmo::Vector>(
      isSelected.data(), static_cast<Eigen::Index>(isSelected.size()));
  }
  return whole;
}

lmo::SurfacePieces vtkPLaplacianMeshOptimizer::DistributedSession::OptimizeGathered(const Job& job)
{
  const lmo::Communicator comm = this->GetCommunicator();
  const Job whole = this->Gather(job);
  lmo::SurfacePieces optimized;
  bool isCancelled = false;
  comm.Try(
    [&]
    {
      const TimeAlone timeAlone(comm, this->IsAlone);
      if (comm.Rank() > 0)
      {
        return;
      }
      try
      {
        optimized = this->Session::Optimize(whole);
      }
      catch (const lmo::Cancelled&)
      {
        isCancelled = true;
      }
    });
  if (comm.Maximum(isCancelled) > 0)
  {
    throw lmo::Cancelled();
  }
  this->ShareMetrics();
  return this->Input.Return(this->ParallelFilter->GetController(), comm, optimized, job.pieces);
}

void vtkPLaplacianMeshOptimizer::DistributedSession::ShareMetrics()
{
  std::vector<double> values;
  Tables::VisitMetrics(*this->ParallelFilter, {},
    [&](const char*, auto& value, auto...) { values.push_back(static_cast<double>(value)); });
  this->ParallelFilter->GetController()->Broadcast(
    values.data(), static_cast<vtkIdType>(values.size()), 0);
  auto shared = values.begin();
  Tables::VisitMetrics(*this->ParallelFilter, {},
    [&](const char*, auto& value, auto...)
    { value = static_cast<std::decay_t<decltype(value)>>(*shared++); });
  // Process 0 may have been asked to stop and have a result nevertheless.
  if (this->GetCommunicator().Maximum(lmo::IsAborted(this->Filter)) > 0)
  {
    lmo::KeepOutput(this->Filter);
  }
}

void vtkPLaplacianMeshOptimizer::DistributedSession::SetInput(
  vtkPolyData* input, const std::vector<lmo::Index>& firstPoints)
{
  if (this->WasDistributed != this->IsDistributed())
  {
    this->Optimizer.reset();
    this->WasDistributed = this->IsDistributed();
  }
  if (!this->IsDistributed())
  {
    this->Session::SetInput(input, firstPoints);
  }
  else if (this->GetCommunicator().Maximum(this->IsNew(input)) > 0)
  {
    this->Optimizer.reset();
    this->Distribute(input);
  }
}

void vtkPLaplacianMeshOptimizer::DistributedSession::Distribute(vtkPolyData* input)
{
  const lmo::Communicator comm = this->GetCommunicator();
  lmo::SurfaceMesh mesh;
  comm.Try([&] { mesh = this->Read(input); });
  lmo::Piece piece = lmo::TakePiece(input, mesh, comm, this->ParallelFilter->GetController());
  this->SetOptimizer(input, std::move(mesh.numbering),
    std::make_unique<lmo::DistributedOptimizer>(comm, std::move(piece), std::move(mesh.triangles)));
}

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
