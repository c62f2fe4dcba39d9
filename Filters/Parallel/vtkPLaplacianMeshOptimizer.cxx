// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPLaplacianMeshOptimizer.h"

#include "../Private/FilterSupport.h"
#include "../Private/OptimizerSession.h"
#include "../Private/PolyDataConversion.h"
#include "DistributedOptimizer.h"

#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkExecutive.h"
#include "vtkGenerateGlobalIds.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMPI.h"
#include "vtkMPICommunicator.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

namespace
{
/// The processes of a controller; MPI_COMM_NULL if there is only one, or no MPI.
MPI_Comm CommunicatorOf(vtkMultiProcessController* controller)
{
  auto* communicator =
    controller ? vtkMPICommunicator::SafeDownCast(controller->GetCommunicator()) : nullptr;
  const bool isDistributed = communicator && controller->GetNumberOfProcesses() > 1;
  return isDistributed ? *communicator->GetMPIComm()->GetHandle() : MPI_COMM_NULL;
}

std::vector<lmo::GlobalId> ReadIds(vtkDataArray* array)
{
  std::vector<lmo::GlobalId> ids(array ? array->GetNumberOfTuples() : 0);
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    ids[i] = static_cast<lmo::GlobalId>(array->GetTuple1(static_cast<vtkIdType>(i)));
  }
  return ids;
}

/// Ids by which points of all processes are the same one: those of the input, or by coordinates.
std::vector<lmo::GlobalId> GlobalIds(
  vtkPolyData* input, const lmo::Communicator& comm, vtkMultiProcessController* controller)
{
  vtkDataArray* ids = input->GetPointData()->GetGlobalIds();
  const bool isMissing = input->GetNumberOfPoints() > 0 && !ids;
  if (comm.Maximum(isMissing) == 0)
  {
    return ReadIds(ids);
  }
  vtkNew<vtkPolyData> points;
  points->SetPoints(input->GetPoints());
  vtkNew<vtkGenerateGlobalIds> generator;
  generator->SetController(controller);
  generator->SetInputData(points);
  generator->Update();
  return ReadIds(vtkPolyData::SafeDownCast(generator->GetOutput())->GetPointData()->GetGlobalIds());
}

/// The triangles of the cells that are not marked as duplicates.
lmo::Triangles TrianglesThatCount(vtkPolyData* input, const lmo::SurfaceMesh& mesh)
{
  const lmo::Triangles& triangles = mesh.triangles;
  auto* ghosts = vtkUnsignedCharArray::SafeDownCast(
    input->GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName()));
  if (!ghosts)
  {
    return triangles;
  }
  lmo::Triangles counted(triangles.rows(), 3);
  Eigen::Index count = 0;
  for (lmo::Index t = 0; t < triangles.rows(); ++t)
  {
    if (!(ghosts->GetValue(mesh.numbering.CellOf(t)) & vtkDataSetAttributes::DUPLICATECELL))
    {
      counted.row(count++) = triangles.row(t);
    }
  }
  counted.conservativeResize(count, 3);
  return counted;
}

/// A monitor that stops in all processes if one is asked to stop.
class CollectiveMonitor : public lmo::FilterMonitor
{
public:
  CollectiveMonitor(vtkAlgorithm* filter, const lmo::Communicator& comm)
    : FilterMonitor(filter)
    , Comm(comm)
  {
  }

protected:
  bool IsCancelled() override { return this->Comm.Maximum(this->FilterMonitor::IsCancelled()) > 0; }

private:
  const lmo::Communicator Comm;
};
}

/// With one process, the session of the superclass.
class vtkPLaplacianMeshOptimizer::DistributedSession : public vtkLaplacianMeshOptimizer::Session
{
public:
  explicit DistributedSession(vtkPLaplacianMeshOptimizer* filter)
    : Session(filter)
    , ParallelFilter(filter)
  {
  }

protected:
  void CheckPieces(int pieces) const override
  {
    if (!this->IsDistributed())
    {
      this->Session::CheckPieces(pieces);
    }
  }

  void Try(const std::function<void()>& body) const override
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

  std::unique_ptr<lmo::ProgressMonitor> MakeMonitor() const override
  {
    if (!this->IsDistributed())
    {
      return this->Session::MakeMonitor();
    }
    return std::make_unique<CollectiveMonitor>(this->Filter, this->GetCommunicator());
  }

  /// New places may lie on the pieces of other processes.
  bool InterpolatesPointData() const override
  {
    return !(this->IsDistributed() && this->GetCommunicator().Size() > 1) &&
           this->Session::InterpolatesPointData();
  }

  void SetInput(vtkPolyData* input) override
  {
    if (this->WasDistributed != this->IsDistributed())
    {
      this->Optimizer.reset();
      this->WasDistributed = this->IsDistributed();
    }
    if (!this->IsDistributed())
    {
      this->Session::SetInput(input);
    }
    else if (this->GetCommunicator().Maximum(this->IsNew(input)) > 0)
    {
      this->Optimizer.reset();
      this->Distribute(input);
    }
  }

private:
  bool IsDistributed() const
  {
    return CommunicatorOf(this->ParallelFilter->GetController()) != MPI_COMM_NULL;
  }

  lmo::Communicator GetCommunicator() const
  {
    return lmo::Communicator(CommunicatorOf(this->ParallelFilter->GetController()));
  }

  void Distribute(vtkPolyData* input)
  {
    const lmo::Communicator comm = this->GetCommunicator();
    lmo::SurfaceMesh mesh;
    comm.Try([&] { mesh = this->Read(input); });
    lmo::Piece piece;
    piece.triangles = TrianglesThatCount(input, mesh);
    piece.points = std::move(mesh.points);
    if (comm.Sum(std::int64_t(input->GetNumberOfPoints())) > 0)
    {
      piece.ids = GlobalIds(input, comm, this->ParallelFilter->GetController());
    }
    this->SetOptimizer(input, std::move(mesh.numbering),
      std::make_unique<lmo::DistributedOptimizer>(
        comm, std::move(piece), std::move(mesh.triangles)));
  }

  vtkPLaplacianMeshOptimizer* const ParallelFilter;
  bool WasDistributed = false; ///< the optimizer is a lmo::DistributedOptimizer
};

vtkStandardNewMacro(vtkPLaplacianMeshOptimizer);
vtkCxxSetObjectMacro(vtkPLaplacianMeshOptimizer, Controller, vtkMultiProcessController);

vtkPLaplacianMeshOptimizer::vtkPLaplacianMeshOptimizer()
{
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

vtkPLaplacianMeshOptimizer::~vtkPLaplacianMeshOptimizer()
{
  this->SetController(nullptr);
}

std::unique_ptr<vtkLaplacianMeshOptimizer::Session> vtkPLaplacianMeshOptimizer::MakeSession()
{
  return std::make_unique<DistributedSession>(this);
}

int vtkPLaplacianMeshOptimizer::UpdateMetrics()
{
  const bool isAlone = !this->Controller || this->Controller->GetNumberOfProcesses() < 2;
  return isAlone ? this->Superclass::UpdateMetrics() : 0;
}

int vtkPLaplacianMeshOptimizer::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  // The pipeline then executes block by block, in processes that have blocks only: the others would
  // not take part in what all do together. It asks for the extents of blocks without this key.
  const bool isForAll = request->Has(vtkExecutive::ALGORITHM_BEFORE_FORWARD());
  if (isForAll)
  {
    this->HasBlocks = vtkCompositeDataSet::GetData(inputVector[0]) != nullptr &&
                      CommunicatorOf(this->Controller) != MPI_COMM_NULL;
  }
  if (isForAll && this->HasBlocks)
  {
    vtkErrorMacro("The input is a composite data set, whose blocks cannot be optimized in several "
                  "processes. Extract a block and apply vtkMergeBlocks first (Extract Block and "
                  "Merge Blocks in ParaView).");
    return 0;
  }
  return this->Superclass::RequestUpdateExtent(request, inputVector, outputVector);
}

int vtkPLaplacianMeshOptimizer::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (this->HasBlocks)
  {
    return 0;
  }
  int result = 0;
  const auto run = [&]
  { result = this->Superclass::RequestData(request, inputVector, outputVector); };
  if (CommunicatorOf(this->Controller) == MPI_COMM_NULL)
  {
    run();
  }
  else
  {
    lmo::WithBackend(1, run);
  }
  return result;
}

void vtkPLaplacianMeshOptimizer::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Controller: " << this->Controller << "\n";
}

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
