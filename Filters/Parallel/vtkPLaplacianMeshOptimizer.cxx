// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPLaplacianMeshOptimizer.h"

#include "../Private/FilterSupport.h"
#include "DistributedSession.h"

#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

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

int vtkPLaplacianMeshOptimizer::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  int result = 0;
  const auto run = [&]
  { result = this->Superclass::RequestData(request, inputVector, outputVector); };
  if (DistributedSession::CommunicatorOf(this->Controller) == MPI_COMM_NULL)
  {
    run();
  }
  else
  {
    lmo::WithBackend(DistributedSession::NumberOfThreads(this), run);
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
